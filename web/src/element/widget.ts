/** What an element becomes once it is wanted: state, growth, picture and controls. Loaded late, with all that it needs. */
import type { Engine } from "../engine/engine.ts";
import { Grower } from "../engine/grower.ts";
import type { Entry } from "../form/entry.ts";
import type { Value } from "../params/declaration.ts";
import type { Issue } from "../params/issue.ts";
import { write } from "../params/link.ts";
import { withValue } from "../params/params.ts";
import { initialState, presetState, type State } from "../params/state.ts";
import type { Plant } from "../plant/plant.ts";
import { Playback } from "../scene/playback.ts";
import { Controls, sheetOfControls } from "./controls.ts";
import { describe } from "./description.ts";
import type { ErrorDetail, PlantDetail } from "./element.ts";
import type { Face } from "./face.ts";
import { HandOver } from "./hand-over.ts";
import { sheetOfLegends, showLegend } from "./legend.ts";
import { Picture } from "./picture.ts";
import type { Attribute, Request } from "./request.ts";
import { controlKinds, pathsIn, wantedState } from "./wanted.ts";
import { join, leave } from "./workshop.ts";

/** What remains of a widget that was taken off the page. */
export interface Memory {
  readonly state: State;
}

/** Dispatches an event of the element. */
export type Tell = (type: string, detail: PlantDetail | ErrorDetail) => void;

export class Widget {
  readonly #face: Face;
  readonly #tell: Tell;
  readonly #engine: Engine;
  readonly #grower: Grower;
  readonly #picture: Picture;
  readonly #handOver: HandOver;
  readonly #playback = new Playback();
  #controls: Controls | null = null;
  /** What the controls were made for. */
  #equipment = "";
  #alt: string | null = null;
  #state: State;
  /** The last state that a plant could be grown from. */
  #good: State;
  #plant: Plant | null = null;
  #grown: Plant | null = null;
  #drags = false;
  #isFresh: boolean;
  #turn = 0;
  /** Requests that are being examined. */
  #asks = 0;
  #waiting: (() => void)[] = [];

  constructor(face: Face, tell: Tell, memory: Memory | null) {
    this.#face = face;
    this.#tell = tell;
    this.#state = memory?.state ?? initialState;
    this.#good = this.#state;
    this.#isFresh = memory === null;
    const { adoptedStyleSheets: sheets } = face.root;
    face.root.adoptedStyleSheets = [...new Set([...sheets, sheetOfControls(), sheetOfLegends()])];
    this.#handOver = new HandOver(face);
    this.#picture = new Picture(
      face,
      () => this.#draw(),
      (message) => this.#fail(message, []),
    );
    this.#engine = join();
    this.#grower = new Grower(this.#engine, {
      onPlant: (plant, grown) => this.#take(plant, grown),
      onIssues: (issues) => this.#refuse(issues),
      onFailure: ({ message }) => this.#fail(`The plant could not be computed. ${message}`, []),
      onProgress: (share) => this.#say(share === null ? "" : "Growing …", "info"),
      onRest: () => {
        this.#draw();
        this.#rest();
      },
    });
  }

  /** What is shown; null before the first plant. */
  get plant(): Plant | null {
    return this.#plant;
  }

  /** The growth step that is shown; null is full grown. */
  get step(): number | null {
    return this.#playback.step ?? this.#state.step;
  }

  /** The query of the link to what is shown. */
  get link(): string {
    return write(this.#state);
  }

  /** Heeds what the author changed. */
  heed(request: Request, changed: ReadonlySet<Attribute>): void {
    if (changed.has("controls") || changed.has("fields")) this.#equip(request);
    if (changed.has("alt")) this.#alt = request.alt;
    const isStart = changed.size > 0 && !this.#plant;
    // After its return to the page a widget is as its reader left it.
    if (!this.#isFresh && isStart) this.#want();
    else void this.#ask(request, changed);
    this.#isFresh = true;
  }

  /** Takes notice of whether anybody can see it. */
  see(inView: boolean): void {
    this.#picture.inView = inView;
    if (inView) return;
    this.deactivate();
    this.pause();
  }

  /** Replays the growth. */
  play(): void {
    const last = this.#grown?.report.steps;
    if (last === undefined) return;
    const { step } = this.#state;
    this.#playback.start(
      step === null || step >= last ? 1 : step,
      last,
      () => this.#want(),
      () => {
        this.#state = { ...this.#state, step: null };
        this.#want();
      },
    );
  }

  /** Stops the replay where it is. */
  pause(): void {
    const { step } = this.#playback;
    if (step === null) return;
    this.#playback.stop();
    this.#state = { ...this.#state, step };
    this.#want();
  }

  /** Hands the picture to the reader. */
  activate(): void {
    this.#handOver.toReader(this.#picture.stage);
  }

  /** Gives it back to the page. */
  deactivate(): void {
    this.#handOver.toPage();
  }

  /** The picture, once it is done. */
  toBlob(type: string, quality: number | undefined): Promise<Blob> {
    return this.#picture.toBlob(type, quality);
  }

  /** Frees everything; returns what another widget can go on with. */
  leave(): Memory {
    this.#turn++;
    this.#grower.cancel();
    this.#playback.stop();
    this.deactivate();
    this.#picture.dispose();
    this.#controls?.remove();
    this.#face.legend.hidden = true;
    leave();
    return { state: this.#good };
  }

  /** Resolves when nothing that was asked for is under way any more. */
  settled(): Promise<void> {
    return new Promise((resolve) => {
      this.#waiting.push(resolve);
      this.#rest();
    });
  }

  #rest(): void {
    if (this.#asks > 0 || this.#grower.busy) return;
    for (const resolve of this.#waiting.splice(0)) resolve();
  }

  async #ask(request: Request, changed: ReadonlySet<Attribute>): Promise<void> {
    const turn = ++this.#turn;
    this.#asks++;
    this.#picture.expect();
    try {
      const { state, issues, notices } = await wantedState(request, changed, this.#state, this.#engine);
      if (turn !== this.#turn) return;
      if (issues.length > 0) return this.#refuse(issues);
      this.#playback.stop();
      this.#say(notices.join(" "), "info");
      this.#state = state;
      this.#want();
    } catch (error) {
      if (turn === this.#turn) this.#fail(error instanceof Error ? error.message : String(error), []);
    } finally {
      this.#asks--;
      this.#rest();
    }
  }

  /** Wants the plant that the state, or the replay, is about. */
  #want(): void {
    this.#grower.want(this.#state.params, this.step);
    this.#draw();
  }

  #take(plant: Plant, grown: Plant): void {
    const isFirst = this.#plant === null;
    this.#plant = plant;
    this.#grown = grown;
    this.#good = { ...this.#state, params: plant.params };
    if (this.#face.message.dataset.tone === "problem") this.#say("", "info");
    this.#draw();
    const detail = { plant, step: this.step, moving: this.#drags || this.#playback.plays };
    this.#tell(isFirst ? "bough-ready" : "bough-change", detail);
  }

  #refuse(issues: readonly Issue[]): void {
    this.#state = { ...this.#good };
    this.#fail(issues.map(({ message }) => message).join(" "), issues);
    this.#draw();
  }

  #fail(message: string, issues: readonly Issue[]): void {
    this.#say(message, "problem");
    if (!this.#plant) this.#picture.giveUp(message);
    this.#tell("bough-error", { issues, message });
  }

  #say(text: string, tone: "info" | "problem"): void {
    const { message } = this.#face;
    message.dataset.tone = tone;
    if (message.textContent !== text) message.textContent = text;
  }

  #draw(): void {
    const [plant, grown] = [this.#plant, this.#grown];
    if (!plant || !grown) return;
    const { theme, view, color, style, params } = this.#state;
    this.#face.figure.dataset.theme = theme;
    const settled = !this.#drags && !this.#grower.busy;
    const objection = this.#picture.show(plant, {
      grown,
      view,
      color,
      style,
      settled,
      passage: this.#playback.interval,
    });
    if (objection) this.#say(objection, "info");
    if (settled && !this.#playback.plays) this.#picture.label = this.#alt ?? `The plant. ${describe(plant)}`;
    showLegend(this.#face.legend, plant, color, grown);
    const last = grown.report.steps;
    const step = Math.min(last, this.#playback.plays ? plant.report.steps : (this.#state.step ?? last));
    this.#face.controls.hidden = this.#controls === null;
    this.#controls?.show({ state: this.#state, params, step, last, plays: this.#playback.plays });
  }

  /** Makes the controls that are asked for; of a kind that there is not, the usual ones: an issue says so. */
  #equip({ controls: asked, fields }: Request): void {
    const kind = controlKinds.find((one) => one === asked) ?? "compact";
    const equipment = `${kind} ${fields}`;
    if (equipment === this.#equipment) return;
    this.#equipment = equipment;
    const { controls, figure } = this.#face;
    this.#controls?.remove();
    this.#controls = null;
    controls.hidden = true;
    figure.classList.remove(...controlKinds);
    figure.classList.add(kind);
    if (kind === "none") return;
    this.#controls = new Controls(controls, kind, pathsIn(fields), {
      enter: (path, value, how) => this.#enter(path, value, how),
      age: (step, how) => this.#age(step, how),
      look: (change) => {
        this.#state = { ...this.#state, ...change };
        this.#want();
      },
      togglePlay: () => (this.#playback.plays ? this.pause() : this.play()),
      reset: () => {
        this.#state = { ...this.#state, params: presetState(this.#state.preset).params };
        this.#want();
      },
    });
    this.#draw();
  }

  #enter(path: string, value: Value, how: Entry["how"]): void {
    this.#drags = how === "dragging";
    this.#playback.stop();
    this.#state = { ...this.#state, params: withValue(this.#state.params, path, value) };
    this.#want();
  }

  #age(step: number, how: Entry["how"]): void {
    this.#drags = how === "dragging";
    this.#playback.stop();
    const last = this.#grown?.report.steps ?? step;
    this.#state = { ...this.#state, step: step >= last ? null : step };
    this.#want();
  }
}
