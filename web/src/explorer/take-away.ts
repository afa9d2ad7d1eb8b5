/** The dialog that makes files of the plant: pictures, bodies, tables, a clip, a citation. Loaded when it is first wanted. */
import { html, nothing, render, type TemplateResult } from "lit";
import { live } from "lit/directives/live.js";
import { bibtex, citation } from "../export/citation.ts";
import { Clip, clipType, endingOf } from "../export/clip.ts";
import { documentOf } from "../export/document.ts";
import { drawing } from "../export/drawing.ts";
import { composed, png } from "../export/print.ts";
import { table } from "../export/table.ts";
import { paintOf } from "../geometry/legend.ts";
import { say } from "../language/say.ts";
import type { State } from "../params/state.ts";
import type { Plant } from "../plant/plant.ts";
import type { Stage } from "../scene/stage.ts";
import { openDialog } from "./dialog.ts";
import { download } from "./download.ts";
import "../style/take-away.css";

/** What there is to be taken away, and what the page does for it. */
export interface Desk {
  readonly state: State;
  readonly title: string;
  /** The address of exactly this plant. */
  readonly link: string;
  /** The plant as it is shown, and the same full grown; null before the first. */
  readonly plant: Plant | null;
  readonly grown: Plant | null;
  /** Null where the browser draws no pictures. */
  readonly stage: Stage | null;
  /** Plays all of the growth, and tells when it is over. */
  play(onPlayed: () => void): void;
  stop(): void;
  open(file: File): void;
}

/** Pixels a CSS px. */
const scales = [1, 2, 3, 4] as const;

/** Opens it. */
export function openTakeAway(desk: Desk): void {
  openDialog(say("Take it away"), "taking", html`<div class="take-away"></div>`);
  const host = document.querySelector<HTMLElement>("dialog.taking .take-away");
  if (host) new TakeAway(host, desk);
}

class TakeAway {
  readonly #host: HTMLElement;
  readonly #desk: Desk;
  #scale: number = 2;
  #transparent = false;
  #annotated = true;
  #clip: Clip | null = null;
  #said = "";

  constructor(host: HTMLElement, desk: Desk) {
    this.#host = host;
    this.#desk = desk;
    host.closest("dialog")?.addEventListener("close", () => this.#endClip());
    this.#render();
  }

  get #name(): string {
    return `bough-${this.#desk.state.preset ?? "plant"}`;
  }

  #render(): void {
    const { plant, stage, link } = this.#desk;
    render(
      html`<ul class="goods">
          ${this.#good(say("Picture"), say("PNG, as it is shown"), "PNG", stage && plant ? () => this.#savePicture(stage) : null, this.#pictureWishes())}
          ${this.#good(say("Centre lines"), say("SVG from the front, in millimetres at full size"), "SVG", plant && (() => this.#save("svg", "image/svg+xml", drawing(plant, this.#desk.title))))}
          ${this.#good(say("Body"), say("glTF for other programs, in metres, with its colours and parameters"), "GLB", plant && (() => this.#saveBody(plant, "glb")))}
          ${this.#good(say("Body, plain"), say("For programs that take no glTF"), "OBJ", plant && (() => this.#saveBody(plant, "obj")))}
          ${this.#good(say("Table"), say("One row a segment: place, girth, moment, curvature, stress; units in the header"), "CSV", plant && (() => this.#save("csv", "text/csv", table(plant))))}
          ${this.#good(say("Parameters"), say("Opens here again: drop it on the page, or choose it below"), "JSON", () => this.#save("json", "application/json", documentOf(this.#desk.state)))}
          ${this.#clipGood()}
        </ul>
        <p class="said" role="status">${this.#said}</p>
        <section aria-labelledby="citation-title">
          <h3 id="citation-title">${say("To cite it")}</h3>
          ${this.#text(say("As text"), citation(link))} ${this.#text("BibTeX", bibtex(link))}
        </section>
        <section aria-labelledby="opening-title">
          <h3 id="opening-title">${say("Open a file")}</h3>
          <label class="choose"
            >${say("Parameters that were saved here (JSON)")}
            <input type="file" accept=".json,application/json" @change=${(event: Event) => this.#open(event)}
          /></label>
        </section>`,
      this.#host,
    );
  }

  /** One thing to take; `save` is null where it cannot be had. */
  #good(
    name: string,
    what: string,
    kind: string,
    save: (() => unknown) | null,
    wishes: TemplateResult | typeof nothing = nothing,
  ): TemplateResult {
    return html`<li>
      <div><b>${name}</b> <span class="what">${what}</span>${wishes}</div>
      <button type="button" ?disabled=${save === null} aria-label=${say("Save {0}", kind)} @click=${() => save && this.#try(save)}>${kind}</button>
    </li>`;
  }

  #pictureWishes(): TemplateResult {
    const tick = (name: string, on: boolean, turn: (on: boolean) => void) =>
      html`<label class="option"
        ><input type="checkbox" .checked=${live(on)} @change=${(event: Event) => turn((event.target as HTMLInputElement).checked)} />${name}</label
      >`;
    return html`<div class="wishes">
      <label class="option"
        >${say("Scale")}
        <select @change=${(event: Event) => {
          this.#scale = Number((event.target as HTMLSelectElement).value);
        }}>
          ${scales.map((one) => html`<option value=${one} ?selected=${one === this.#scale}>${one}×</option>`)}
        </select></label
      >
      ${tick(say("Transparent"), this.#transparent, (on) => {
        this.#transparent = on;
      })}
      ${tick(say("With angle and scale bar"), this.#annotated, (on) => {
        this.#annotated = on;
      })}
    </div>`;
  }

  #clipGood(): TemplateResult {
    const { stage, plant } = this.#desk;
    const type = stage && plant && clipType();
    const what = type
      ? say("Growth as a film, recorded while it plays")
      : say("This browser cannot record what is drawn; another one, or one that is newer, can.");
    if (this.#clip) {
      return html`<li>
        <div><b>${say("Clip")}</b> <span class="what">${say("Recording: it plays once from the first step to the last.")}</span></div>
        <button type="button" @click=${() => this.#cancelClip()}>${say("Cancel")}</button>
      </li>`;
    }
    const kind = type ? endingOf(type).toUpperCase() : "WEBM";
    return this.#good(say("Clip"), what, kind, type ? () => this.#record(stage as Stage, type) : null);
  }

  #text(name: string, text: string): TemplateResult {
    return html`<div class="citation">
      <label>${name}<textarea readonly rows="4" spellcheck="false" .value=${text} @focus=${(event: Event) => (event.target as HTMLTextAreaElement).select()}></textarea></label>
      <button type="button" aria-label=${say("Copy {0}", name)} @click=${(event: Event) => this.#copy(text, event)}>${say("Copy")}</button>
    </div>`;
  }

  #say(text: string): void {
    this.#said = text;
    this.#render();
  }

  async #try(save: () => unknown): Promise<void> {
    try {
      await save();
    } catch (error) {
      const isTooLarge = error instanceof RangeError;
      this.#say(
        isTooLarge
          ? say("That is too large for this computer: take a smaller scale.")
          : say("It could not be made. {0}", error instanceof Error ? error.message : String(error)),
      );
    }
  }

  #save(ending: string, type: string, content: BlobPart): void {
    const name = `${this.#name}.${ending}`;
    download(content instanceof Blob ? content : new Blob([content], { type }), name);
    this.#say(say("{0} is saved.", name));
  }

  async #savePicture(stage: Stage): Promise<void> {
    const picture = stage.reprint(this.#scale);
    if (!picture) return;
    const annotation = this.#annotated ? stage.annotation : null;
    const paper = this.#transparent ? null : paperOf();
    this.#save("png", "image/png", await png(await composed({ picture, annotation, paper })));
  }

  async #saveBody(plant: Plant, kind: "glb" | "obj"): Promise<void> {
    const [{ meshOf }, { glb, obj }] = await Promise.all([
      import("../export/mesh.ts"),
      import("../export/solid.ts"),
    ]);
    const grown = this.#desk.grown ?? plant;
    const mesh = meshOf(plant, paintOf(plant, this.#desk.state.color, grown), grown.report.steps);
    if (kind === "glb") this.#save(kind, "model/gltf-binary", await glb(mesh, plant));
    else this.#save(kind, "model/obj", obj(mesh, plant));
  }

  async #record(stage: Stage, type: string): Promise<void> {
    const clip = new Clip(stage.canvas, paperOf(), type);
    this.#clip = clip;
    this.#say("");
    await clip.started;
    if (this.#clip === clip) this.#desk.play(() => this.#try(() => this.#keep(clip, type)));
  }

  /** Saves what was recorded. */
  async #keep(clip: Clip, type: string): Promise<void> {
    const film = await clip.finish();
    if (this.#clip !== clip) return;
    this.#clip = null;
    this.#save(endingOf(type), type, film);
  }

  #cancelClip(): void {
    this.#endClip();
    this.#say(say("Recording was cancelled."));
  }

  #endClip(): void {
    if (!this.#clip) return;
    this.#clip.cancel();
    this.#clip = null;
    this.#desk.stop();
  }

  async #copy(text: string, event: Event): Promise<void> {
    const box = (event.target as HTMLElement).parentElement?.querySelector("textarea");
    try {
      await navigator.clipboard.writeText(text);
      this.#say(say("Copied."));
    } catch {
      box?.focus();
      this.#say(say("Copying is not allowed here; the text is selected."));
    }
  }

  #open(event: Event): void {
    const [file] = (event.target as HTMLInputElement).files ?? [];
    if (!file) return;
    this.#host.closest("dialog")?.close();
    this.#desk.open(file);
  }
}

/** The colour of the page's paper. */
function paperOf(): string {
  return getComputedStyle(document.body).backgroundColor;
}
