/** The gallery of all plates. Loaded when it is first wanted. */
import { html, type TemplateResult } from "lit";
import type { Text } from "../language/english.ts";
import { say } from "../language/say.ts";
import { presets } from "../params/declaration.ts";
import { openDialog } from "./dialog.ts";
import { card, titleOf } from "./gallery.ts";
import type { Actions } from "./model.ts";
import { makeStop, rove } from "./roving.ts";

const plain: Text = "An axis under its weight";

/** The plates by what they are about, each named by the figures that it shows. */
const chapters: readonly (readonly [title: Text, figures: RegExp])[] = [
  ["Which way an organ grows", /^figure-2[a-e]$/],
  [plain, /^figure-(8|10)/],
  ["Tropism turns it up", /^figure-13/],
  ["Wood thickens and remembers", /^figure-17/],
  ["Forks", /^figure-(18|20|21)/],
  ["Plants one knows", /^(?!figure-)/],
];

/** Opens it; the plate that is shown is marked. */
export function openGallery(present: string | null, actions: Actions): void {
  const choose = (id: string | null) => {
    actions.choosePreset(id);
    close();
  };
  const known = Object.keys(presets);
  const rest = known.filter((id) => !chapters.some(([, figures]) => figures.test(id)));
  const chapter = (title: Text, ids: readonly (string | null)[]) =>
    html`<section aria-label=${say(title)}>
      <h3>${say(title)}</h3>
      <ul class="plates">
        ${ids.map((id) => card(id, titleOf(id), present, choose))}
      </ul>
    </section>`;
  const all: TemplateResult[] = chapters.map(([title, figures]) => {
    const own = known.filter((id) => figures.test(id));
    // The plant of the bare page is one under its weight, too.
    return chapter(title, title === plain ? [null, ...own] : own);
  });
  const close = openDialog(
    say("All plates"),
    "all-plates",
    html`<div @keydown=${rove} @focusin=${rove}>${all} ${rest.length > 0 ? chapter("More", rest) : ""}</div>`,
  );
  const chosen = document.querySelector<HTMLElement>(".all-plates [aria-pressed=true]");
  if (!chosen) return;
  makeStop(chosen);
  chosen.focus();
  chosen.scrollIntoView({ block: "center" });
}
