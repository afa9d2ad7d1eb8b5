// A live figure of the course, from the few lines that an author writes:
//
//     id: axis
//     link: ?v=1&preset=figure-8d
//     fields: loads.gravity material.youngsModulus
//     readings: tip q
//     alt: What the picture shows before it can be moved.
//
//     The caption.
//
// What lies inside the element is what remains where no script runs: poster, caption and link.

/** The lines that an author may write; those with a question mark may be missing. */
const keys = ["id", "link", "fields", "readings?", "alt"];

/**
 * @typedef {object} Figure
 * @property {string} id
 * @property {string} link query of Bough's page
 * @property {string} fields paths of the parameters that can be changed
 * @property {string} [readings] what is read off below the picture
 * @property {string} alt
 * @property {string} caption Markdown
 */

/**
 * Reads the lines.
 * @param {string} text
 * @returns {Figure}
 */
export function readFigure(text) {
  const [head = "", ...rest] = text.trim().split(/\n\s*\n/);
  const entries = head.split("\n").map((line) => {
    const [, key, value] = /^(\w+): (.+)$/.exec(line) ?? [];
    if (!key || !keys.some((known) => known.replace("?", "") === key))
      throw new Error(`A figure says “${line}”.`);
    return [key, value];
  });
  const figure = Object.fromEntries(entries);
  const missing = keys.filter((key) => !key.endsWith("?") && !figure[key]);
  if (missing.length > 0) throw new Error(`Figure ${figure.id} lacks ${missing.join(", ")}.`);
  return { ...figure, caption: rest.join(" ").replaceAll("\n", " ") };
}

/**
 * @param {string} text
 * @param {(text: string) => string} inline
 */
export function figureBlock(text, inline) {
  const { id, link, fields, readings, alt, caption } = readFigure(text);
  const reading = readings ? `<p class="reading" data-readings="${readings}" hidden></p>` : "";
  return `<div class="figure">
<bough-plant id="${id}" link="${escaped(link)}" fields="${fields}" alt="${escaped(alt)}">
<img slot="poster" src="posters/${id}.webp" alt="${escaped(alt)}" width="720" height="480" loading="lazy">
<span slot="caption">${inline(caption)} <a href="../${escaped(link)}">Open it in Bough</a></span>
</bough-plant>${reading}
</div>
`;
}

/** @param {string} text */
function escaped(text) {
  return text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");
}
