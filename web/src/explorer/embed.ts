/** The dialog that makes the snippet for another page. Loaded when it is first wanted. */
import { html, nothing, render, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import type { Text } from "../language/english.ts";
import { say } from "../language/say.ts";
import { type State, themes } from "../params/state.ts";
import { openDialog } from "./dialog.ts";
import { download } from "./download.ts";
import { controls, type Form, frameAddress, posterFile, snippet, type Wishes } from "./snippet.ts";
import "../style/embed.css";

/** Sizes that fit a text, a page, a slide. */
const sizes: readonly (readonly [name: Text, width: number, height: number])[] = [
  ["Small", 480, 320],
  ["Medium", 640, 420],
  ["Large", 960, 600],
];
/** Smaller shows nothing, larger no screen. px */
const [least, most] = [120, 4000];

const forms: Readonly<Record<Form, Text>> = {
  iframe: "For a course page (LMS)",
  element: "For your own page",
};
const themeNames: Readonly<Record<State["theme"], Text>> = {
  auto: "As the reader’s",
  light: "Light",
  dark: "Dark",
};
const controlNames: Readonly<Record<Wishes["controls"], Text>> = {
  full: "All",
  compact: "A few",
  none: "None",
};

/** Opens the dialog for what is shown; `picture` is the drawing of it, if there is one. */
export function openEmbed(state: State, title: string, picture: HTMLCanvasElement | null): void {
  openDialog(say("Embed"), "embedding", html`<div class="embed"></div>`);
  const host = document.querySelector<HTMLElement>("dialog.embedding .embed");
  if (host) new Embedding(host, state, title, picture);
}

class Embedding {
  readonly #host: HTMLElement;
  readonly #state: State;
  readonly #title: string;
  readonly #picture: HTMLCanvasElement | null;
  #wishes: Wishes;
  /** What stands in the boxes of the size; it counts only as far as it can be a size. */
  #drafts: Readonly<Record<"width" | "height", string>> = { width: "640", height: "420" };
  #said = "";

  constructor(host: HTMLElement, state: State, title: string, picture: HTMLCanvasElement | null) {
    this.#host = host;
    this.#state = state;
    this.#title = title;
    this.#picture = picture;
    const { theme } = state;
    this.#wishes = {
      form: "iframe",
      width: 640,
      height: 420,
      theme,
      controls: "compact",
      poster: false,
      title,
    };
    this.#render();
  }

  #wish(wishes: Partial<Wishes>): void {
    this.#wishes = { ...this.#wishes, ...wishes };
    this.#said = "";
    this.#render();
  }

  #render(): void {
    const wishes = this.#wishes;
    const { form, width, height } = wishes;
    const chosen = sizes.find(([, across, down]) => across === width && down === height)?.[0] ?? "";
    render(
      html`<div class="wishes">
          <div class="where">
          ${choice(
            say("Where"),
            "form",
            Object.keys(forms) as Form[],
            form,
            (one) => say(forms[one]),
            (one) => this.#wish({ form: one }),
          )}
          <label class="title"
            >${say("Title, for readers who do not see it")}
            <span class="box"
              ><input type="text" .value=${live(wishes.title)} @input=${(event: Event) => this.#wish({ title: (event.target as HTMLInputElement).value.trim() || this.#title })} /></span
          ></label>
          ${form === "element" ? this.#poster() : nothing}
          </div>
          <fieldset>
            <legend>${say("Size")}</legend>
            ${sizes.map(
              ([name, across, down]) => html`<label class="option"
                ><input type="radio" name="size" .checked=${live(name === chosen)} @change=${() => this.#resize(String(across), String(down))} />${say(name)}
                <span class="unit">${across} × ${down}</span></label
              >`,
            )}
            <div class="own">${this.#side("width", say("Width"))} ${this.#side("height", say("Height"))}</div>
          </fieldset>
          ${choice(
            say("Theme"),
            "embed-theme",
            themes,
            wishes.theme,
            (one) => say(themeNames[one]),
            (theme) => this.#wish({ theme }),
          )}
          ${choice(
            say("Controls"),
            "controls",
            controls,
            wishes.controls,
            (one) => say(controlNames[one]),
            (one) => this.#wish({ controls: one }),
          )}
        </div>
        <label class="snippet"
          >${form === "iframe" ? say("Paste this as HTML") : say("Put this into your page")}
          <textarea readonly rows="6" spellcheck="false" .value=${snippet(this.#state, location.href, wishes)} @focus=${(event: Event) => (event.target as HTMLTextAreaElement).select()}></textarea></label
        >
        <p class="deed">
          <button type="button" class="copy" @click=${() => this.#copy()}>${say("Copy")}</button>
          <a href=${frameAddress(this.#state, location.href, wishes)} target="_blank" rel="noopener">${say("Open it by itself")}</a>
          <span role="status">${this.#said}</span>
        </p>`,
      this.#host,
    );
  }

  #side(side: "width" | "height", name: string): TemplateResult {
    const isWrong = !isSize(this.#drafts[side]);
    const enter = (event: Event) =>
      this.#resize(
        ...(["width", "height"].map((one) =>
          one === side ? (event.target as HTMLInputElement).value : this.#drafts[one as "width"],
        ) as [string, string]),
      );
    return html`<label
        >${name}
        <span class="box"
          ><input
            type="text"
            inputmode="numeric"
            .value=${live(this.#drafts[side])}
            aria-invalid=${isWrong ? "true" : nothing}
            aria-describedby=${isWrong ? `embed-${side}` : nothing}
            @input=${enter}
          /><span class="unit">px</span></span
        ></label
      >${isWrong ? html`<p class="issue" id="embed-${side}" role="alert">${say("{0} must be a whole number from {1} to {2}.", name, least, most)}</p>` : nothing}`;
  }

  #poster(): TemplateResult {
    return html`<fieldset>
      <legend>${say("Poster")}</legend>
      <label class="option"
        ><input
          type="checkbox"
          .checked=${live(this.#wishes.poster)}
          @change=${(event: Event) => this.#wish({ poster: (event.target as HTMLInputElement).checked })}
        />${say("A picture until it is touched")}</label
      >
      ${this.#wishes.poster && this.#picture ? html`<button type="button" @click=${() => this.#savePicture()}>${say("Save {0}", posterFile)}</button>` : nothing}
    </fieldset>`;
  }

  #resize(width: string, height: string): void {
    this.#drafts = { width, height };
    const size = isSize(width) && isSize(height) ? { width: Number(width), height: Number(height) } : {};
    this.#wish(size);
  }

  async #copy(): Promise<void> {
    const text = this.#host.querySelector("textarea");
    try {
      await navigator.clipboard.writeText(text?.value ?? "");
      this.#said = say("Copied.");
    } catch {
      text?.focus();
      this.#said = say("Copying is not allowed here; the text is selected.");
    }
    this.#render();
  }

  #savePicture(): void {
    this.#picture?.toBlob(
      (blob) => {
        if (blob) download(blob, posterFile);
      },
      "image/webp",
      0.9,
    );
  }
}

function choice<Name extends string>(
  legend: string,
  group: string,
  options: readonly Name[],
  present: Name,
  nameOf: (name: Name) => string,
  choose: (name: Name) => void,
): TemplateResult {
  return html`<fieldset>
    <legend>${legend}</legend>
    ${options.map(
      (option) => html`<label class="option"
        ><input type="radio" name=${group} .checked=${live(option === present)} @change=${() => choose(option)} />${nameOf(option)}</label
      >`,
    )}
  </fieldset>`;
}

function isSize(text: string): boolean {
  const size = Number(text);
  return /^\d+$/.test(text.trim()) && size >= least && size <= most;
}
