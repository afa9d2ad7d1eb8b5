/** What is seen of a widget before anything is computed: its frame, the poster, the caption, and where the rest will go. */
import { sheetOfWidgets } from "./style.ts";

/** The parts of a widget's shadow tree. */
export interface Face {
  readonly root: ShadowRoot;
  readonly figure: HTMLElement;
  /** Holds the canvas. */
  readonly scene: HTMLElement;
  /** Covers the picture, and hands it to whoever presses it. */
  readonly enter: HTMLButtonElement;
  readonly leave: HTMLButtonElement;
  readonly message: HTMLElement;
  readonly controls: HTMLElement;
  readonly legend: HTMLElement;
  readonly poster: HTMLElement;
  readonly image: HTMLImageElement;
  /** Stands where a poster is missing. */
  readonly sapling: SVGElement;
  /** Has a colour that tells whether the page is dark here. */
  readonly tone: HTMLElement;
}

/** Makes an element: its properties, of which `part` and `class` are attributes, and what is in it. */
export function element<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  attributes: Readonly<Record<string, string>> = {},
  ...content: (Node | string)[]
): HTMLElementTagNameMap[Name] {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...content);
  return made;
}

/** The widget's own language, in pages of any. */
const lang = "en";

/** Builds the shadow tree. Node by node, as some pages forbid to parse HTML. */
export function makeFace(root: ShadowRoot): Face {
  const image = element("img", { part: "poster", alt: "" });
  const sapling = drawSapling();
  const posterSlot = element("slot", { name: "poster" }, image, sapling);
  const captionSlot = element("slot", { name: "caption" });
  const caption = element("figcaption", { part: "caption", hidden: "" }, captionSlot);
  captionSlot.addEventListener("slotchange", () => {
    caption.hidden = captionSlot.assignedNodes().length === 0;
  });
  const face = {
    root,
    image,
    sapling,
    poster: element("div", { class: "poster" }, posterSlot),
    scene: element("div", { class: "scene" }),
    enter: element("button", { class: "enter", part: "enter", type: "button", lang }, element("span")),
    leave: element("button", { class: "leave", part: "leave", type: "button", lang }, "Done"),
    message: element("p", { class: "message", part: "message", role: "status", lang }),
    legend: element("div", { class: "legend", part: "legend", hidden: "", lang }),
    controls: element("div", { class: "controls", part: "controls", hidden: "", lang }),
    tone: element("span", { class: "tone" }),
  };
  image.hidden = true;
  // A poster that is not there is none.
  image.addEventListener("error", () => {
    image.hidden = true;
    sapling.removeAttribute("hidden");
  });
  const { poster, scene, legend, enter, leave, message, controls, tone } = face;
  const stage = element("div", { class: "stage", part: "stage" });
  stage.append(poster, scene, legend, enter, leave, message, tone);
  const figure = element("figure", { part: "figure" }, stage, controls, caption);
  root.adoptedStyleSheets = [sheetOfWidgets()];
  root.append(figure);
  return { ...face, figure };
}

/** The height at which the picture has its own proportions and no control is out of sight, CSS px. */
export function naturalHeight({ figure, controls }: Face): number {
  const [stage, , caption] = [...figure.children] as HTMLElement[];
  if (!stage || !caption) return 0;
  const [across = 3, up = 2] = getComputedStyle(stage).aspectRatio.split("/").map(Number);
  const isBeside = controls.offsetTop === stage.offsetTop && controls.offsetWidth > 0;
  const borders = figure.offsetHeight - figure.clientHeight;
  const below = isBeside ? 0 : controls.scrollHeight;
  return Math.ceil((stage.offsetWidth * (up || 1)) / across + below + caption.offsetHeight + borders);
}

function drawSapling(): SVGElement {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("class", "sapling");
  svg.setAttribute("viewBox", "0 0 60 40");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS(svg.namespaceURI, "path");
  path.setAttribute("d", "M10 38C16 20 30 8 54 14M20 22C20 14 24 8 30 5M5 38H24");
  svg.append(path);
  return svg;
}
