/** The explorer: what a person does becomes state, state becomes a plant, the plant becomes picture and words. */
import { render } from "lit";
import { describe } from "../element/description.ts";
import type { Engine } from "../engine/engine.ts";
import { Grower } from "../engine/grower.ts";
import type { Entry } from "../form/entry.ts";
import { speak } from "../language/load.ts";
import { say } from "../language/say.ts";
import { read } from "../params/link.ts";
import { colors, presetState, type State, styles, themes, views } from "../params/state.ts";
import { type Change, Store } from "../params/store.ts";
import type { Plant } from "../plant/plant.ts";
import type { Study } from "../study/study.ts";
import { Address } from "./address.ts";
import { copyLink } from "./clipboard.ts";
import { failureText } from "./failure.ts";
import { Files, isPicture } from "./files.ts";
import { revealPlate, titleOf } from "./gallery.ts";
import { Intake } from "./intake.ts";
import { Late } from "./late.ts";
import type { Actions, Model } from "./model.ts";
import { Narrator } from "./narrator.ts";
import { noticeText } from "./notice.ts";
import { Notices } from "./notices.ts";
import { page } from "./page.ts";
import { Passage } from "./passage.ts";
import { Picture } from "./picture.ts";
import { pullSentence } from "./pull.ts";
import { Replay } from "./replay.ts";
import { listenToKeys } from "./shortcuts.ts";
import { Theme } from "./theme.ts";
import type { Touch } from "./touch.ts";

/** Composes the page in an element. `data-settled` on the root element says whether all is drawn and at rest. */
export class Explorer {
  readonly #root: HTMLElement;
  readonly #store: Store;
  readonly #address: Address;
  readonly #theme = new Theme(() => this.#draw());
  readonly #replay: Replay;
  readonly #passage = new Passage();
  readonly #notices = new Notices(() => this.#render());
  readonly #late = new Late(this.#notices);
  readonly #actions = this.#makeActions();
  #intake: Intake | null = null;
  /** What was entered before the engine was there. */
  readonly #early: Entry[] = [];
  #grower: Grower | null = null;
  #picture: Picture | null = null;
  #touch: Touch | null = null;
  #study: Study | null = null;
  #openStudy = async () => {};
  readonly #files = new Files((file) => this.#open(file));
  #plant: Plant | null = null;
  #grown: Plant | null = null;
  #progress: number | null = null;
  readonly #narrator = new Narrator((text) => {
    this.#picture?.stage.canvas.setAttribute("aria-label", `${say("The plant")}. ${text}`);
    this.#render();
  });
  #drags = false;
  #renders = false;
  #revealed: string | null | undefined;

  constructor(root: HTMLElement) {
    this.#root = root;
    const { state, notices } = read(location.search);
    this.#store = new Store(state);
    this.#address = new Address(this.#store);
    this.#replay = new Replay(
      this.#store,
      () => this.#grown,
      () => this.#want(),
    );
    this.#theme.apply(state.theme);
    for (const notice of notices) this.#notices.add(noticeText(notice, state));
    this.#store.subscribe((_, change) => this.#take(change));
    root.addEventListener("bough-enter", (event) => {
      this.#replay.stop();
      void this.#enter(event.detail);
      this.#rest();
    });
    listenToKeys(this.#actions);
    this.#files.listen();
    this.#renderNow();
  }

  /** Starts the engine, grows the first plant, and replays its growth once where motion is welcome. */
  async start(startEngine: () => Promise<Engine>): Promise<void> {
    const starting = startEngine();
    this.#openPicture();
    this.#speak();
    try {
      this.#openStudy = () => this.#layOut(startEngine);
      await this.#use(await starting);
    } catch (error) {
      this.#fail(error);
    }
  }

  async #use(engine: Engine): Promise<void> {
    const intake = new Intake(engine, this.#store, () => this.#render());
    for (const sentence of await intake.open()) this.#notices.add(sentence);
    this.#intake = intake;
    for (const entry of this.#early.splice(0)) void this.#enter(entry);
    this.#files.retry();
    this.#grower = new Grower(engine, {
      onPlant: (plant, grown) => this.#show(plant, grown),
      onIssues: (issues) => this.#intake?.show(issues),
      onFailure: (error) => this.#fail(error),
      onRestart: () => this.#notices.add(say("The computation broke off, and was begun again.")),
      onProgress: (share) => {
        this.#progress = share;
        this.#render();
      },
      // Only now the frame may fit closely again.
      onRest: () => this.#draw(),
    });
    this.#want();
    this.#late.load(async () => {
      await this.#lendHand(engine);
      const { keepOffline } = await import("./offline.ts");
      await keepOffline();
    });
  }

  /** From now on the plant can be touched: no sooner than it is there, so that it is there the sooner. */
  async #lendHand(engine: Engine): Promise<void> {
    const stage = this.#picture?.stage;
    if (!stage) return;
    const { Touch } = await import("./touch.ts");
    this.#touch = new Touch({
      engine,
      stage,
      plant: () => (this.#grower?.busy ? null : this.#plant),
      onTake: () => {
        this.#passage.stop();
        if (this.#replay.plays) this.#replay.pause();
      },
      onChange: () => this.#draw(),
      onLetGo: (held) => this.#pass(held, "swing"),
    });
    stage.canvas.setAttribute("aria-describedby", "touch-hint");
    this.#render();
  }

  /** What there is to study about the plant, in a place of its own beside the picture. */
  async #layOut(startEngine: () => Promise<Engine>): Promise<void> {
    const host = this.#root.querySelector<HTMLElement>(".study");
    const { Study } = await import("../study/study.ts");
    const stage = this.#picture?.stage ?? null;
    const desk = { stage, store: this.#store, address: this.#address, actions: this.#actions, startEngine };
    if (host) this.#study = new Study(host, desk);
    this.#rest();
    this.#files.retry();
  }

  #openPicture(): void {
    const host = this.#root.querySelector<HTMLElement>(".stage");
    if (!host) return;
    try {
      this.#picture = new Picture(host, this.#notices, () => this.#rest());
    } catch {
      this.#notices.add(
        say(
          "This browser draws no 3D pictures (WebGL 2 is missing or switched off); the numbers work all the same.",
        ),
        { tone: "problem" },
      );
    }
  }

  async #enter(entry: Entry): Promise<void> {
    try {
      if (this.#intake) await this.#intake.take(entry);
      else this.#early.push(entry);
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

  /** Opens a photo, or the document of a plant; false while there is nobody who could. */
  #open(file: File): boolean {
    const intake = this.#intake;
    const isPhoto = isPicture(file);
    if (!intake || (isPhoto && !this.#study)) return false;
    if (!isPhoto || !this.#study?.take(file))
      this.#late.file(file, { intake, store: this.#store, notices: this.#notices });
    return true;
  }

  /** The state changed. */
  #take(change: Change): void {
    this.#drags = change === "dragging";
    this.#touch?.letGo();
    if (change === "undo" || change === "redo") this.#intake?.clear();
    this.#replay.stop();
    this.#theme.apply(this.#store.state.theme);
    this.#speak();
    this.#want();
  }

  /** Speaks the language of the state. */
  #speak(): void {
    this.#late.load(async () => {
      const isOther = await speak(this.#store.state.lang);
      document.title = say("Bough: how branches bend as they grow");
      if (isOther) this.#picture?.say();
      if (isOther) this.#draw();
    });
  }

  /** Wants the plant that the state, or the replay of its growth, is about. */
  #want(): void {
    this.#grower?.want(this.#store.state.params, this.#replay.step);
    this.#draw();
  }

  #show(plant: Plant, grown: Plant): void {
    const before = this.#plant;
    const isFirst = before === null;
    if (isFirst) this.#late.load(() => this.#openStudy());
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
      this.#picture?.show({
        shape,
        force: this.#touch?.pull ?? null,
        grown: this.#grown,
        view,
        color,
        style,
        tone: this.#theme.tone,
        still: shape !== this.#plant,
        settled: !this.#drags && !this.#grower?.busy,
        passage: this.#replay.interval,
      });
    }
    this.#render();
  }

  #play(): void {
    this.#touch?.letGo();
    this.#passage.stop();
    this.#replay.play();
  }

  /** Gives up a long computation: the values go back to those of the plant that is shown. */
  #cancel(): void {
    this.#grower?.cancel();
    if (this.#plant) this.#store.set({ params: this.#plant.params }, "settled");
    this.#notices.add(say("Growing was cancelled."), { passes: this.#plant === null });
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
      this.#picture?.stage.canvas.focus({ preventScroll: true });
    }
  }

  /** Says whether all is at rest, and describes it then. Who cancels the first plant has none, and no reason to wait. */
  #rest(): void {
    const moves = this.#picture?.stage.moving || this.#passage.plant !== null || this.#touch?.busy;
    const works = this.#intake?.busy || this.#grower?.busy || moves;
    const rests = this.#grower !== null && !works && !this.#replay.plays && !this.#drags;
    document.documentElement.dataset.settled = String(rests);
    const shape = this.#shape;
    if (shape) this.#study?.show({ shape, rests });
    const pull = this.#touch?.pull;
    const plant = this.#plant;
    this.#narrator.follow(rests && plant ? () => (pull ? pullSentence(pull) : describe(plant)) : null);
  }

  #fail(error: unknown): void {
    const text = say("The plant could not be computed. {0}", failureText(error));
    this.#notices.add(text, { tone: "problem", passes: true });
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
      plays: this.#replay.plays,
      speed: this.#replay.speed,
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
        this.#picture?.stage.fit();
        this.#store.set(presetState(id), "settled");
      },
      resetAll: () => {
        this.#intake?.clear();
        this.#store.set({ params: presetState(this.#store.state.preset).params }, "settled");
      },
      togglePlay: () => (this.#replay.plays ? this.#replay.pause() : this.#play()),
      setSpeed: (speed) => {
        this.#replay.speed = speed;
        this.#render();
      },
      age: (steps) => this.#replay.go(steps),
      toggleLoads: () => this.#toggleLoads(),
      toggleHold: () => this.#toggleHold(),
      undo: () => this.#address.undo(),
      redo: () => this.#address.redo(),
      copyLink: () => void copyLink(this.#address.link, this.#notices),
      zoom: (factor) => this.#picture?.stage.zoom(factor),
      fit: () => this.#picture?.stage.fit(),
      cancel: () => this.#cancel(),
      dismiss: (notice) => this.#notices.dismiss((other) => other === notice),
      showGallery: () => this.#late.gallery(this.#store.state.preset, this.#actions),
      showKeys: () => this.#late.keys(),
      showTakeAway: () => {
        this.#late.takeAway({
          state: this.#store.state,
          title: titleOf(this.#store.state.preset),
          link: this.#address.link,
          plant: this.#shape,
          grown: this.#grown,
          stage: this.#picture?.stage ?? null,
          play: (onPlayed) => this.#replay.play(true, onPlayed),
          stop: () => this.#replay.stop(),
          open: (file) => this.#files.take(file),
        });
      },
      showEmbed: () => {
        const { state } = this.#store;
        this.#late.embed(state, titleOf(state.preset), this.#picture?.stage.canvas ?? null);
      },
      showControls: () => this.#root.querySelector<HTMLElement>("#controls")?.focus(),
    };
  }
}
