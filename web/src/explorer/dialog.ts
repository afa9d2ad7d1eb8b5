/** What opens over the page. Loaded when it is first wanted. */
import { html, render, type TemplateResult } from "lit";
import { presets } from "../params/declaration.ts";
import { card, ownTitle } from "./gallery.ts";
import { icon } from "./icons.ts";
import type { Actions } from "./model.ts";
import { shortcuts, singleKeysAreOn, turnSingleKeys } from "./shortcuts.ts";

const plain = "An axis under its weight";

/** The plates by what they are about, each named by the figures that it shows. */
const chapters: readonly (readonly [title: string, figures: RegExp])[] = [
  ["Which way an organ grows", /^figure-2[a-e]$/],
  [plain, /^figure-(8|10)/],
  ["Tropism turns it up", /^figure-13/],
  ["Wood thickens and remembers", /^figure-17/],
  ["Forks", /^figure-(18|20|21)/],
];

/** Opens the gallery of all plates. */
export function openGallery(present: string | null, actions: Actions): void {
  const choose = (id: string | null) => {
    actions.choosePreset(id);
    close();
  };
  const known = Object.keys(presets);
  const rest = known.filter((id) => !chapters.some(([, figures]) => figures.test(id)));
  const chapter = (title: string, plates: readonly TemplateResult[]) =>
    html`<section aria-label=${title}>
      <h3>${title}</h3>
      <ul class="plates">
        ${plates}
      </ul>
    </section>`;
  const plates = (ids: readonly string[]) =>
    ids.map((id) => card(id, presets[id]?.title ?? id, present, choose));
  const close = open(
    "All plates",
    "all-plates",
    html`${chapters.map(([title, figures]) => {
      const own = plates(known.filter((id) => figures.test(id)));
      // The plant of the bare page is one under its weight, too.
      return chapter(title, title === plain ? [card(null, ownTitle, present, choose), ...own] : own);
    })}
    ${rest.length > 0 ? chapter("More", plates(rest)) : ""}`,
  );
}

/** Opens the list of keys. */
export function openKeys(): void {
  open(
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
        the base, <kbd>Esc</kbd> lets go.
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

/** Opens a dialog over the page; returns what closes it. */
function open(title: string, name: string, content: TemplateResult): () => void {
  const dialog = document.createElement("dialog");
  dialog.className = name;
  dialog.setAttribute("aria-labelledby", `${name}-title`);
  const close = () => dialog.close();
  // A click beside the dialog is one on the element itself: its content fills it.
  dialog.addEventListener("click", ({ target }) => target === dialog && close());
  dialog.addEventListener("close", () => dialog.remove());
  render(
    html`<div class="content">
      <div class="dialog-head">
        <h2 id="${name}-title">${title}</h2>
        <button type="button" class="tool" aria-label="Close" title="Close" @click=${close}>${icon("close")}</button>
      </div>
      ${content}
    </div>`,
    dialog,
  );
  document.body.append(dialog);
  dialog.showModal();
  const chosen = dialog.querySelector<HTMLElement>("[aria-pressed=true]");
  chosen?.focus();
  chosen?.scrollIntoView({ block: "center" });
  return close;
}
