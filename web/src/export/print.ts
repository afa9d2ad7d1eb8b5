/** The picture as a file: PNG, on paper or on nothing, with or without what a plate writes over its drawing. */

export interface Printed {
  /** What was drawn, on nothing. */
  readonly picture: HTMLCanvasElement;
  /** What is written over it, in CSS px; null leaves it out. */
  readonly annotation: SVGSVGElement | null;
  /** Colour of the paper, as CSS has it; null is transparent. */
  readonly paper: string | null;
}

/** Puts it all on one canvas. */
export async function composed({ picture, annotation, paper }: Printed): Promise<HTMLCanvasElement> {
  const canvas = document.createElement("canvas");
  canvas.width = picture.width;
  canvas.height = picture.height;
  const pen = canvas.getContext("2d");
  if (!pen) throw new Error("This browser has no canvas to draw on.");
  if (paper !== null) {
    pen.fillStyle = paper;
    pen.fillRect(0, 0, canvas.width, canvas.height);
  }
  pen.drawImage(picture, 0, 0);
  if (annotation) pen.drawImage(await imageOf(annotation, canvas), 0, 0, canvas.width, canvas.height);
  return canvas;
}

/** A canvas as a PNG. Rejects where it is too large for the browser. */
export function png(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((resolve, reject) =>
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new RangeError("The picture is too large."))),
      "image/png",
    ),
  );
}

/** What of the page's style an SVG takes along. */
const styles = [
  "display",
  "fill",
  "stroke",
  "stroke-width",
  "stroke-dasharray",
  "stroke-linecap",
  "stroke-linejoin",
  "opacity",
  "paint-order",
  "font-family",
  "font-size",
  "font-style",
  "font-weight",
  "font-variant-numeric",
  "text-anchor",
] as const;

/** An SVG of the page as a picture of its own, of the size of a canvas. */
async function imageOf(svg: SVGSVGElement, { width, height }: HTMLCanvasElement): Promise<HTMLImageElement> {
  const copy = svg.cloneNode(true) as SVGSVGElement;
  const [from, to] = [svg, copy].map((root) => [root, ...root.querySelectorAll<SVGElement>("*")]);
  from?.forEach((element, index) => {
    const style = getComputedStyle(element);
    for (const name of styles) to?.[index]?.style.setProperty(name, style.getPropertyValue(name));
  });
  copy.removeAttribute("class");
  const { clientWidth, clientHeight } = svg;
  copy.setAttribute("viewBox", `0 0 ${clientWidth} ${clientHeight}`);
  copy.setAttribute("width", String(width));
  copy.setAttribute("height", String(height));
  const image = new Image(width, height);
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(new XMLSerializer().serializeToString(copy))}`;
  await image.decode();
  return image;
}
