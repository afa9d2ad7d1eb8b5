/** The list of keys. Loaded when it is first wanted. */
import { html } from "lit";
import { openDialog } from "./dialog.ts";
import { shortcuts, singleKeysAreOn, turnSingleKeys } from "./shortcuts.ts";

/** Opens it. */
export function openKeys(): void {
  openDialog(
    "Keys",
    "key-list",
    html`<dl>
        ${shortcuts.map(
          ({ sign, name }) =>
            html`<div><dt>${sign.split(" ").map((key) => html`<kbd>${key}</kbd>`)}</dt><dd>${name}</dd></div>`,
        )}
      </dl>
      <p>
        With the focus on the picture, <kbd>↑</kbd> <kbd>↓</kbd> <kbd>←</kbd> <kbd>→</kbd> move it; while a point is held,
        they pull at it, with <kbd>Shift</kbd> finely. <kbd>Page ↑</kbd> <kbd>Page ↓</kbd> take hold nearer to the tip or
        the base, <kbd>Esc</kbd> lets go. Among the plates the same arrows go from one to the next.
      </p>
      <label class="option"
        ><input
          type="checkbox"
          .checked=${singleKeysAreOn()}
          @change=${(event: Event) => turnSingleKeys((event.target as HTMLInputElement).checked)}
        />Single keys are shortcuts</label
      >`,
  );
}
