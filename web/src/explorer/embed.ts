/** The dialog that makes the snippet for another page. Loaded when it is first wanted. */
import { html, nothing, render, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { type State, themes } from "../params/state.ts";
import { openDialog } from "./dialog.ts";
import { controls, type Form, frameAddress, posterFile, snippet, type Wishes } from "./snippet.ts";
import "../style/embed.css";

/** Sizes that fit a text, a page, a slide. */
const sizes = [
  ["Small", 480, 320],
  ["Medium", 640, 420],
  ["Large", 960, 600],
] as const;
/** Smaller shows nothing, larger no screen. px */
const [least, most] = [120, 4000];

const forms: Readonly<Record<Form, string>> = {
  iframe: "For a course page (LMS)",
  element: "For your own page",
};
const themeNames: Readonly<Record<State["theme"], string>> = {
  auto: "As the reader’s",
  light: "Light",
  dark: "Dark",
};
const controlNames: Readonly<Record<Wishes["controls"], string>> = {
  full: "All",
  compact: "A few",
  none: "None",
};

/** Opens the dialog for what is shown; `picture` is the drawing of it, if there is one. */
export function openEmbed(state: State, title: string, picture: HTMLCanvasElement | null): void {
  openDialog("Embed", "embedding", html`<div class="embed"></div>`);
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
            "Where",
            "form",
            Object.keys(forms) as Form[],
            form,
            (one) => forms[one],
            (one) => this.#wish({ form: one }),
          )}
          <label class="title"
            >Title, for readers who do not see it
            <span class="box"
              ><input type="text" .value=${live(wishes.title)} @input=${(event: Event) => this.#wish({ title: (event.target as HTMLInputElement).value.trim() || this.#title })} /></span
          ></label>
          ${form === "element" ? this.#poster() : nothing}
          </div>
          <fieldset>
            <legend>Size</legend>
            ${sizes.map(
              ([name, across, down]) => html`<label class="option"
                ><input type="radio" name="size" .checked=${live(name === chosen)} @change=${() => this.#resize(String(across), String(down))} />${name}
                <span class="unit">${across} × ${down}</span></label
              >`,
            )}
            <div class="own">${this.#side("width", "Width")} ${this.#side("height", "Height")}</div>
          </fieldset>
          ${choice(
            "Theme",
            "embed-theme",
            themes,
            wishes.theme,
            (one) => themeNames[one],
            (theme) => this.#wish({ theme }),
          )}
          ${choice(
            "Controls",
            "controls",
            controls,
            wishes.controls,
            (one) => controlNames[one],
            (one) => this.#wish({ controls: one }),
          )}
        </div>
        <label class="snippet"
          >${form === "iframe" ? "Paste this as HTML" : "Put this into your page"}
          <textarea readonly rows="6" spellcheck="false" .value=${snippet(this.#state, location.href, wishes)} @focus=${(event: Event) => (event.target as HTMLTextAreaElement).select()}></textarea></label
        >
        <p class="deed">
          <button type="button" class="copy" @click=${() => this.#copy()}>Copy</button>
          <a href=${frameAddress(this.#state, location.href, wishes)} target="_blank" rel="noopener">Open it by itself</a>
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
      >${isWrong ? html`<p class="issue" id="embed-${side}" role="alert">${name} must be a whole number from ${least} to ${most}.</p>` : nothing}`;
  }

  #poster(): TemplateResult {
    return html`<fieldset>
      <legend>Poster</legend>
      <label class="option"
        ><input
          type="checkbox"
          .checked=${live(this.#wishes.poster)}
          @change=${(event: Event) => this.#wish({ poster: (event.target as HTMLInputElement).checked })}
        />A picture until it is touched</label
      >
      ${this.#wishes.poster && this.#picture ? html`<button type="button" @click=${() => this.#savePicture()}>Save ${posterFile}</button>` : nothing}
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
      this.#said = "Copied.";
    } catch {
      text?.focus();
      this.#said = "Copying is not allowed here; the text is selected.";
    }
    this.#render();
  }

  #savePicture(): void {
    this.#picture?.toBlob(
      (blob) => {
        if (!blob) return;
        const address = URL.createObjectURL(blob);
        const link = document.createElement("a");
        link.href = address;
        link.download = posterFile;
        link.click();
        setTimeout(() => URL.revokeObjectURL(address));
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
