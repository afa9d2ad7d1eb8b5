/** The explorer: what a person does becomes state, state becomes a plant, the plant becomes picture and words. */
import { render } from "lit";
import type { Engine } from "../engine/engine.ts";
import type { Entry } from "../form/entry.ts";
import { read } from "../params/link.ts";
import { colors, presetState, type State, styles, themes, views } from "../params/state.ts";
import { type Change, Store } from "../params/store.ts";
import type { Plant } from "../plant/plant.ts";
import { Stage } from "../scene/stage.ts";
import { Address } from "./address.ts";
import { describe } from "./description.ts";
import { revealPlate } from "./gallery.ts";
import { Grower } from "./grower.ts";
import { Intake } from "./intake.ts";
import type { Actions, Model } from "./model.ts";
import { Narrator } from "./narrator.ts";
import { Notices } from "./notices.ts";
import { page } from "./page.ts";
import { Passage } from "./passage.ts";
import { Playback } from "./playback.ts";
import { pullSentence } from "./pull.ts";
import { listenToKeys } from "./shortcuts.ts";
import { Theme } from "./theme.ts";
import type { Touch } from "./touch.ts";

/** Composes the page in an element. `data-settled` on the root element says whether all is drawn and at rest. */
export class Explorer {
  readonly #root: HTMLElement;
  readonly #store: Store;
  readonly #address: Address;
  readonly #theme = new Theme(() => this.#draw());
  readonly #playback = new Playback();
  readonly #passage = new Passage();
  readonly #notices = new Notices(() => this.#render());
  readonly #actions = this.#makeActions();
  #intake: Intake | null = null;
  #grower: Grower | null = null;
  #stage: Stage | null = null;
  #touch: Touch | null = null;
  #plant: Plant | null = null;
  #grown: Plant | null = null;
  #progress: number | null = null;
  readonly #narrator = new Narrator((text) => {
    this.#stage?.canvas.setAttribute("aria-label", `The plant. ${text}`);
    this.#render();
  });
  /** Why the stage shows something other than what is wanted. */
  #objection: string | null = null;
  #drags = false;
  #renders = false;
  #revealed: string | null = null;

  constructor(root: HTMLElement) {
    this.#root = root;
    const { state, notices } = read(location.search);
    this.#store = new Store(state);
    this.#address = new Address(this.#store);
    this.#theme.apply(state.theme);
    for (const { message } of notices) this.#notices.add(message);
    this.#store.subscribe((_, change) => this.#take(change));
    root.addEventListener("bough-enter", (event) => {
      this.#playback.stop();
      void this.#enter(event.detail);
      this.#rest();
    });
    listenToKeys(this.#actions);
    this.#renderNow();
  }

  /** Starts the engine, grows the first plant, and replays its growth once where motion is welcome. */
  async start(startEngine: () => Promise<Engine>): Promise<void> {
    const starting = startEngine();
    this.#openStage();
    try {
      await this.#use(await starting);
    } catch (error) {
      this.#fail(error);
    }
  }

  async #use(engine: Engine): Promise<void> {
    this.#intake = new Intake(engine, this.#store, () => this.#render());
    const { params, sentences } = await this.#intake.repair(this.#store.state.params);
    for (const sentence of sentences) this.#notices.add(sentence);
    this.#store.set({ params }, "settled");
    this.#grower = new Grower(engine, {
      onPlant: (plant, grown) => this.#show(plant, grown),
      onIssues: (issues) => this.#intake?.show(issues),
      onFailure: (message) => this.#fail(message),
      onProgress: (share) => {
        this.#progress = share;
        this.#render();
      },
      // Only now the frame may fit closely again.
      onRest: () => this.#draw(),
    });
    this.#want();
    this.#load(() => this.#lendHand(engine));
  }

  /** From now on the plant can be touched: no sooner than it is there, so that it is there the sooner. */
  async #lendHand(engine: Engine): Promise<void> {
    const stage = this.#stage;
    if (!stage) return;
    const { Touch } = await import("./touch.ts");
    this.#touch = new Touch({
      engine,
      stage,
      plant: () => (this.#grower?.busy ? null : this.#plant),
      onTake: () => {
        this.#passage.stop();
        if (this.#playback.plays) this.#pause();
      },
      onChange: () => this.#draw(),
      onLetGo: (held) => this.#pass(held, "swing"),
    });
    stage.canvas.setAttribute("aria-describedby", "touch-hint");
    this.#render();
  }

  #openStage(): void {
    const host = this.#root.querySelector<HTMLElement>(".stage");
    if (!host) return;
    try {
      this.#stage = new Stage(host);
    } catch {
      this.#notices.add(
        "This browser draws no 3D pictures (WebGL 2 is missing or switched off); the numbers work all the same.",
        { tone: "problem" },
      );
      return;
    }
    const { canvas } = this.#stage;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "The plant");
    const lost =
      "The graphics card dropped the picture: this is the last one. It will come back, or after a reload.";
    canvas.addEventListener("bough-lost", () => this.#notices.add(lost, { tone: "problem" }));
    canvas.addEventListener("bough-restored", () => this.#notices.dismiss(({ text }) => text === lost));
    canvas.addEventListener("bough-due", () => this.#rest());
    canvas.addEventListener("bough-drawn", () => this.#rest());
  }

  async #enter(entry: Entry): Promise<void> {
    try {
      await this.#intake?.take(entry);
    } catch (error) {
      this.#fail(error);
    }
    if (entry.how === "settled") this.#endGesture();
  }

  /** The gesture is over, even if it ended where it began and so changed nothing. */
  #endGesture(): void {
    if (!this.#drags) return;
    this.#drags = false;
    this.#draw();
  }

  /** The state changed. */
  #take(change: Change): void {
    this.#drags = change === "dragging";
    this.#touch?.letGo();
    if (change === "undo" || change === "redo") this.#intake?.clear();
    this.#playback.stop();
    this.#theme.apply(this.#store.state.theme);
    this.#want();
  }

  /** Wants the plant that the state, or the replay of its growth, is about. */
  #want(): void {
    const { params, step } = this.#store.state;
    const wanted = this.#playback.step ?? step;
    this.#grower?.want(params, wanted);
    this.#draw();
  }

  #show(plant: Plant, grown: Plant): void {
    const before = this.#plant;
    const isFirst = before === null;
    this.#notices.dismiss(({ passes }) => passes);
    if (before !== plant) this.#passage.stop();
    this.#plant = plant;
    this.#grown = grown;
    if (before && before.params.loads.removed !== plant.params.loads.removed) this.#pass(before, "ease");
    this.#draw();
    // A plant that takes long to compute is not replayed unasked.
    const isWelcome = !matchMedia("(prefers-reduced-motion: reduce)").matches && this.#progress === null;
    if (isFirst && isWelcome && this.#store.state.step === null) this.#play();
  }

  /** The shape before the eye: the plant as it is held, or on its way to its own shape, or its own. */
  get #shape(): Plant | null {
    return this.#touch?.plant ?? this.#passage.plant ?? this.#plant;
  }

  /** Lets the plant pass from another shape of it to its own. */
  #pass(from: Plant | null, gait: "ease" | "swing"): void {
    if (from && this.#plant) this.#passage.start(from, this.#plant, gait, () => this.#draw());
    this.#draw();
  }

  #draw(): void {
    const shape = this.#shape;
    if (shape && this.#grown) {
      const { view, color, style } = this.#store.state;
      const isFree = shape === this.#plant;
      const objection = this.#stage?.show(shape, {
        grown: this.#grown,
        view,
        color,
        style,
        tone: this.#theme.tone,
        still: !isFree,
        settled: !this.#drags && !this.#grower?.busy,
        passage: this.#playback.interval,
      });
      this.#notices.replace(this.#objection, objection ?? null);
      this.#objection = objection ?? null;
      this.#stage?.showForce(this.#touch?.pull ?? null);
    }
    this.#render();
  }

  #play(): void {
    if (!this.#grown) return;
    this.#touch?.letGo();
    this.#passage.stop();
    const last = this.#grown.report.steps;
    const { step } = this.#store.state;
    const from = step === null || step >= last ? 1 : step;
    const onEnd = () => {
      this.#store.set({ step: null }, "settled");
      this.#want();
    };
    this.#playback.start(from, last, () => this.#want(), onEnd);
  }

  /** Gives up a long computation: the values go back to those of the plant that is shown. */
  #cancel(): void {
    this.#grower?.cancel();
    if (this.#plant) this.#store.set({ params: this.#plant.params }, "settled");
    this.#notices.add("Growing was cancelled.", { passes: this.#plant === null });
  }

  #pause(): void {
    const { step } = this.#playback;
    this.#playback.stop();
    this.#store.set({ step }, "settled");
    this.#render();
  }

  /** Shows another age, and stops the replay. */
  #age(steps: number): void {
    if (!this.#plant || !this.#grown) return;
    const last = this.#grown.report.steps;
    const step = Math.min(Math.max((this.#playback.step ?? this.#store.state.step ?? last) + steps, 1), last);
    this.#store.set({ step: step === last ? null : step }, "settled");
    this.#playback.stop();
    this.#want();
  }

  /** Takes the loads off, or puts them on again. */
  #toggleLoads(): void {
    const value = !this.#store.state.params.loads.removed;
    void this.#enter({ path: "loads.removed", value, how: "settled" });
    this.#rest();
  }

  #toggleHold(): void {
    if (this.#touch?.holds) this.#touch.letGo();
    else {
      this.#touch?.takeTip();
      this.#stage?.canvas.focus({ preventScroll: true });
    }
  }

  /** Says whether all is at rest, and describes it then. */
  #rest(): void {
    const moves = this.#stage?.moving || this.#passage.plant !== null || this.#touch?.busy;
    const works = this.#intake?.busy || this.#grower?.busy || moves;
    const rests = this.#plant !== null && !works && !this.#playback.plays && !this.#drags;
    document.documentElement.dataset.settled = String(rests);
    const pull = this.#touch?.pull;
    const plant = this.#plant;
    this.#narrator.follow(rests && plant ? () => (pull ? pullSentence(pull) : describe(plant)) : null);
  }

  #fail(error: unknown): void {
    const reason = error instanceof Error ? error.message : String(error);
    this.#notices.add(`The plant could not be computed. ${reason}`, { tone: "problem", passes: true });
    this.#rest();
  }

  /** Renders once for all changes of this task. */
  #render(): void {
    if (this.#renders) return;
    this.#renders = true;
    queueMicrotask(() => this.#renderNow());
  }

  #renderNow(): void {
    this.#renders = false;
    render(page(this.#model(), this.#actions), this.#root);
    const { preset } = this.#store.state;
    if (preset !== this.#revealed) revealPlate(this.#root);
    this.#revealed = preset;
    this.#rest();
  }

  #model(): Model {
    const { state, canUndo, canRedo } = this.#store;
    return {
      state,
      baseline: presetState(state.preset).params,
      plant: this.#shape,
      grown: this.#grown,
      issues: this.#intake?.issues ?? new Map(),
      notices: this.#notices.list,
      progress: this.#progress,
      announcement: this.#narrator.text,
      plays: this.#playback.plays,
      speed: this.#playback.speed,
      holds: this.#touch?.holds ?? false,
      pull: this.#touch?.pull ?? null,
      canUndo,
      canRedo,
    };
  }

  #makeActions(): Actions {
    return {
      change: (change: Partial<State>, how = "settled") => {
        this.#store.set(change, how);
        if (how === "settled") this.#endGesture();
      },
      next: (aspect) => {
        const { state } = this.#store;
        const options: readonly string[] = { color: colors, style: styles, view: views, theme: themes }[
          aspect
        ];
        const next = options[(options.indexOf(state[aspect]) + 1) % options.length];
        this.#store.set({ [aspect]: next }, "settled");
      },
      choosePreset: (id) => {
        this.#intake?.clear();
        this.#stage?.fit();
        this.#store.set(presetState(id), "settled");
      },
      resetAll: () => {
        this.#intake?.clear();
        this.#store.set({ params: presetState(this.#store.state.preset).params }, "settled");
      },
      togglePlay: () => (this.#playback.plays ? this.#pause() : this.#play()),
      setSpeed: (speed) => {
        this.#playback.speed = speed;
        this.#render();
      },
      age: (steps) => this.#age(steps),
      toggleLoads: () => this.#toggleLoads(),
      toggleHold: () => this.#toggleHold(),
      undo: () => this.#address.undo(),
      redo: () => this.#address.redo(),
      copyLink: () => void this.#copyLink(),
      zoom: (factor) => this.#stage?.zoom(factor),
      fit: () => this.#stage?.fit(),
      cancel: () => this.#cancel(),
      dismiss: (notice) => this.#notices.dismiss((other) => other === notice),
      showGallery: () =>
        this.#load(async () =>
          (await import("./dialog.ts")).openGallery(this.#store.state.preset, this.#actions),
        ),
      showKeys: () => this.#load(async () => (await import("./dialog.ts")).openKeys()),
      showControls: () => this.#root.querySelector<HTMLElement>("#controls")?.focus(),
    };
  }

  /** Does something with a part of the page that is loaded late. */
  #load(work: () => Promise<void>): void {
    work().catch((error: unknown) => {
      const reason = error instanceof Error ? error.message : String(error);
      this.#notices.add(`A part of the page could not be loaded: reload it. (${reason})`, {
        tone: "problem",
      });
    });
  }

  async #copyLink(): Promise<void> {
    try {
      await navigator.clipboard.writeText(this.#address.link);
      this.#notices.add("The link is copied: it opens exactly this plant.");
    } catch {
      this.#notices.add("Copying is not allowed here; the address bar holds the same link.", {
        tone: "problem",
      });
    }
  }
}
