/** Plots to take away: as a drawing that looks the same elsewhere, and as numbers. */

/** What a drawing takes from the page's style sheet. */
const inherited = [
  "fill",
  "stroke",
  "stroke-width",
  "stroke-dasharray",
  "font-family",
  "font-size",
  "font-style",
];

/** An SVG of the page as a file of its own: its styles are written into it. */
export function drawingOf(svg: SVGSVGElement, background: string): string {
  const copy = svg.cloneNode(true) as SVGSVGElement;
  const originals = [svg, ...svg.querySelectorAll("*")];
  [copy, ...copy.querySelectorAll("*")].forEach((element, index) => {
    const original = originals[index];
    if (!original) return;
    const style = getComputedStyle(original);
    for (const name of inherited) element.setAttribute(name, style.getPropertyValue(name));
    element.removeAttribute("class");
  });
  const { width, height } = svg.viewBox.baseVal;
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", String(width));
  copy.setAttribute("height", String(height));
  copy.removeAttribute("aria-hidden");
  const ground = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  ground.setAttribute("width", String(width));
  ground.setAttribute("height", String(height));
  ground.setAttribute("fill", background);
  copy.prepend(ground);
  return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(copy).replaceAll(/<!--.*?-->/gs, "")}\n`;
}

/** Columns as comma-separated values: names with units in the header, numbers with all their digits. */
export function csvOf(columns: readonly { name: string; values: readonly number[] }[]): string {
  const rows =
    columns[0]?.values.map((_, row) => columns.map(({ values }) => String(values[row] ?? "")).join(",")) ??
    [];
  return `${columns.map(({ name }) => name).join(",")}\n${rows.map((row) => `${row}\n`).join("")}`;
}

/** Gives a text as a file. */
export function offer(text: string, type: string, name: string): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address));
}
