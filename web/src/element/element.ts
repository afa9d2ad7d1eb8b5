/** `<bough-plant>`: the element itself, small enough to be everywhere. What draws and computes is loaded when it is wanted. */
import type { Issue } from "../params/issue.ts";
import type { Params, ParamsInput } from "../params/params.ts";
import type { Plant } from "../plant/plant.ts";
import { type Face, makeFace, naturalHeight } from "./face.ts";
import { type Attribute, attributes, type Request } from "./request.ts";
import type { Memory, Widget } from "./widget.ts";

/** Detail of `bough-ready` and `bough-change`. */
export interface PlantDetail {
  /** What is shown. */
  readonly plant: Plant;
  /** The growth step that is shown; null is full grown. */
  readonly step: number | null;
  /** Whether a gesture or a replay still goes on. */
  readonly moving: boolean;
}

/** Detail of `bough-error`. */
export interface ErrorDetail {
  /** Everything that is wrong, as `check` lists it; empty when something else failed. */
  readonly issues: readonly Issue[];
  /** What the widget says. */
  readonly message: string;
}

declare global {
  interface HTMLElementTagNameMap {
    "bough-plant": BoughPlantElement;
  }
  interface HTMLElementEventMap {
    "bough-ready": CustomEvent<PlantDetail>;
    "bough-change": CustomEvent<PlantDetail>;
    "bough-error": CustomEvent<ErrorDetail>;
  }
}

/** On a server there are no elements; importing this must do no harm there. */
const Base = (globalThis.HTMLElement ?? class {}) as typeof HTMLElement;

/** A plant in anybody's page. */
export class BoughPlantElement extends Base {
  /** Attributes that are heeded when they change. */
  static readonly observedAttributes: readonly string[] = attributes;

  readonly #face: Face;
  #widget: Promise<Widget> | null = null;
  /** The same, once it is there. */
  #loaded: Widget | null = null;
  /** What a widget leaves behind when the element is taken off the page. */
  #memory: Memory | null = null;
  #watch: IntersectionObserver | null = null;
  #inView = false;
  #given: ParamsInput | null = null;
  readonly #changed = new Set<Attribute>();

  constructor() {
    super();
    this.#face = makeFace(this.attachShadow({ mode: "open" }));
    const { enter, leave } = this.#face;
    enter.addEventListener("click", () => void this.activate());
    leave.addEventListener("click", () => this.deactivate());
  }

  /** Id of a preset. */
  get preset(): string | null {
    return this.getAttribute("preset");
  }

  set preset(id: string | null) {
    this.#reflect("preset", id);
  }

  /**
   * What differs from the preset, or from the defaults. Reads as the complete params of what is shown, once anything is.
   * Bad ones are told by `bough-error`, and change nothing.
   */
  get params(): Params | ParamsInput {
    return this.#loaded?.plant?.params ?? this.#given ?? {};
  }

  set params(params: ParamsInput | null) {
    this.#given = params;
    this.#note("params");
  }

  /** A link of Bough's page, or its query: another way to say preset, params, step, view, color, drawing and theme at once. */
  get link(): string {
    return this.#loaded?.link ?? this.getAttribute("link") ?? "";
  }

  set link(link: string | null) {
    this.#reflect("link", link);
  }

  /** The growth step that is shown; null is full grown. */
  get step(): number | null {
    const text = this.getAttribute("step");
    return this.#loaded ? this.#loaded.step : text === null ? null : Number(text);
  }

  set step(step: number | null) {
    this.#reflect("step", step === null ? null : String(step));
  }

  /** `"plane"` (the default) or `"space"`. */
  get view(): string {
    return this.getAttribute("view") ?? "plane";
  }

  set view(view: string | null) {
    this.#reflect("view", view);
  }

  /** What the colour means: `"bark"` (the default), `"moment"`, `"stress"`, `"curvature"` or `"age"`. */
  get color(): string {
    return this.getAttribute("color") ?? "bark";
  }

  set color(color: string | null) {
    this.#reflect("color", color);
  }

  /** `"limb"` (the default), or `"model"`: the rods, springs and masses that are computed with. */
  get drawing(): string {
    return this.getAttribute("drawing") ?? "limb";
  }

  set drawing(drawing: string | null) {
    this.#reflect("drawing", drawing);
  }

  /** `"light"`, `"dark"`, or `"auto"` (the default): as the page's own `color-scheme` has it. */
  get theme(): string {
    return this.getAttribute("theme") ?? "auto";
  }

  set theme(theme: string | null) {
    this.#reflect("theme", theme);
  }

  /** `"compact"` (the default), `"full"` or `"none"`. */
  get controls(): string {
    return this.getAttribute("controls") ?? "compact";
  }

  set controls(controls: string | null) {
    this.#reflect("controls", controls);
  }

  /** Paths of the parameters that the controls show first, as `"loads.gravity tropism.strength"`; null is the usual ones. */
  get fields(): string | null {
    return this.getAttribute("fields");
  }

  set fields(fields: string | null) {
    this.#reflect("fields", fields);
  }

  /** Address of a picture that is shown until the plant is. */
  get poster(): string | null {
    return this.getAttribute("poster");
  }

  set poster(address: string | null) {
    this.#reflect("poster", address);
  }

  /** What the picture shows, in words. Without them the plant is described by its measures. */
  get alt(): string | null {
    return this.getAttribute("alt");
  }

  set alt(alt: string | null) {
    this.#reflect("alt", alt);
  }

  /** `"lazy"` (the default): the plant is drawn when it comes into view. `"click"`: when someone asks for it. */
  get loading(): string {
    return this.getAttribute("loading") ?? "lazy";
  }

  set loading(loading: string | null) {
    this.#reflect("loading", loading);
  }

  /** What is shown; null before the first plant. */
  get plant(): Plant | null {
    return this.#loaded?.plant ?? null;
  }

  /** The picture as it is, without its paper and its labels; a PNG unless another type is wanted. */
  async toBlob(type: string = "image/png", quality?: number): Promise<Blob> {
    return (await this.#load()).toBlob(type, quality);
  }

  /** Loads the plant, whether anybody sees it or not. Otherwise that happens by itself, as `loading` has it. */
  async load(): Promise<void> {
    await this.#load();
  }

  /** Loads the plant if need be, and resolves when all that was asked for is shown or refused. */
  async settled(): Promise<void> {
    // What changes in one task is told at its end.
    await Promise.resolve();
    await (await this.#load()).settled();
  }

  /** The height at which nothing is squeezed, CSS px: for hosts that have to be told. */
  get naturalHeight(): number {
    return naturalHeight(this.#face);
  }

  /** Replays the growth, from the age that is shown or from the first one. */
  async play(): Promise<void> {
    (await this.#load()).play();
  }

  /** Stops the replay at the age that it has reached. */
  pause(): void {
    this.#loaded?.pause();
  }

  /** Loads the plant if need be, and hands the picture to pointer, wheel and keys, until they go elsewhere. */
  async activate(): Promise<void> {
    (await this.#load()).activate();
  }

  /** Gives pointer, wheel and keys back to the page. */
  deactivate(): void {
    this.#loaded?.deactivate();
  }

  connectedCallback(): void {
    for (const name of attributes) this.#upgrade(name);
    this.#showFace();
    this.#watch = new IntersectionObserver((entries) => this.#see(entries.at(-1)?.isIntersecting ?? false));
    this.#watch.observe(this);
  }

  disconnectedCallback(): void {
    this.#watch?.disconnect();
    this.#watch = null;
    // It may only be on its way to another place.
    queueMicrotask(() => {
      if (!this.isConnected) this.#unload();
    });
  }

  attributeChangedCallback(name: Attribute): void {
    if (name === "params") this.#given = null;
    this.#note(name);
  }

  #reflect(name: Attribute, value: string | null): void {
    if (value !== null) this.setAttribute(name, value);
    else if (this.hasAttribute(name)) this.removeAttribute(name);
    else this.#note(name);
  }

  /** Takes over a property that was set before the element was defined. */
  #upgrade(name: Attribute): void {
    if (!Object.hasOwn(this, name)) return;
    const value: unknown = Reflect.get(this, name);
    Reflect.deleteProperty(this, name);
    Reflect.set(this, name, value);
  }

  /** Tells of all changes of this task at once. */
  #note(name: Attribute): void {
    if (this.#changed.size === 0) {
      queueMicrotask(() => {
        const changed = new Set(this.#changed);
        this.#changed.clear();
        if (this.isConnected) this.#showFace();
        this.#loaded?.heed(this.#request, changed);
      });
    }
    this.#changed.add(name);
  }

  get #request(): Request {
    const texts = Object.fromEntries(attributes.map((name) => [name, this.getAttribute(name)]));
    return { ...(texts as Record<Attribute, string | null>), params: this.#given ?? texts.params };
  }

  #showFace(): void {
    const { poster, alt } = this;
    const { image, sapling, figure, enter } = this.#face;
    if (poster !== null && image.getAttribute("src") !== poster) image.src = poster;
    image.hidden = poster === null;
    sapling.toggleAttribute("hidden", poster !== null);
    if (!this.#loaded) figure.dataset.theme = this.theme;
    image.alt = alt ?? "A plant";
    const isIdle = this.#widget === null && this.loading === "click";
    figure.classList.toggle("idle", isIdle);
    enter.hidden = !isIdle && this.#loaded === null;
    (enter.firstElementChild ?? enter).textContent = isIdle ? "Show the plant" : "Move and zoom";
  }

  #see(inView: boolean): void {
    this.#inView = inView;
    if (inView && this.loading !== "click") void this.#load().catch(() => undefined);
    this.#loaded?.see(inView);
  }

  #load(): Promise<Widget> {
    this.#widget ??= this.#start().catch((error: unknown) => {
      this.#widget = null;
      const message = `The plant could not be loaded. ${error instanceof Error ? error.message : error}`;
      this.#face.message.textContent = message;
      this.dispatchEvent(new CustomEvent("bough-error", { bubbles: true, detail: { issues: [], message } }));
      throw error;
    });
    return this.#widget;
  }

  async #start(): Promise<Widget> {
    const { Widget } = await import("./widget.ts");
    if (!this.isConnected) throw new Error("The element is not on the page.");
    const tell = (type: string, detail: PlantDetail | ErrorDetail) =>
      this.dispatchEvent(new CustomEvent(type, { bubbles: true, detail }));
    const widget = new Widget(this.#face, tell, this.#memory);
    this.#loaded = widget;
    widget.see(this.#inView);
    widget.heed(this.#request, new Set(attributes));
    this.#showFace();
    return widget;
  }

  #unload(): void {
    this.#memory = this.#loaded?.leave() ?? null;
    this.#loaded = null;
    this.#widget = null;
  }
}

/**
 * Defines the element under a tag. The first definition of a tag wins: another one, of another version say, changes
 * nothing.
 */
export function define(tag: string = "bough-plant"): void {
  if (!globalThis.customElements || customElements.get(tag)) return;
  // A class can be defined but once.
  customElements.define(tag, class extends BoughPlantElement {});
}
