/** The list of keys. Loaded when it is first wanted. */
import { html } from "lit";
import { pieces, say } from "../language/say.ts";
import { openDialog } from "./dialog.ts";
import { shortcuts, singleKeysAreOn, turnSingleKeys } from "./shortcuts.ts";

/** Keys that are called by a name. */
function signOf(sign: string): string {
  return sign === "Spacebar" ? say("Spacebar") : sign.replace("Ctrl", say("Ctrl"));
}

/** Opens it. */
export function openKeys(): void {
  openDialog(
    say("Keys"),
    "key-list",
    html`<dl>
        ${shortcuts.map(
          ({ sign, name }) =>
            html`<div><dt>${signOf(sign)
              .split(" ")
              .map((key) => html`<kbd>${key}</kbd>`)}</dt><dd>${name()}</dd></div>`,
        )}
      </dl>
      <p>
        ${pieces(
          "With the focus on the picture, {0} move it; while a point is held, they pull at it, with {1} finely. {2} take hold nearer to the tip or the base, {3} lets go. Among the plates the same arrows go from one to the next.",
          html`<kbd>↑</kbd> <kbd>↓</kbd> <kbd>←</kbd> <kbd>→</kbd>`,
          html`<kbd>${say("Shift")}</kbd>`,
          html`<kbd>${say("Page ↑")}</kbd> <kbd>${say("Page ↓")}</kbd>`,
          html`<kbd>${say("Esc")}</kbd>`,
        )}
      </p>
      <label class="option"
        ><input
          type="checkbox"
          .checked=${singleKeysAreOn()}
          @change=${(event: Event) => turnSingleKeys((event.target as HTMLInputElement).checked)}
        />${say("Single keys are shortcuts")}</label
      >`,
  );
}
