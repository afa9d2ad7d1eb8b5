/** How to cite what was made here: the paper that is computed, and Bough. `CITATION.cff` says the same to machines. */
import { version } from "../params/declaration.ts";

/** The paper that Bough implements. */
export const paper = {
  authors: [
    ["Jirasek", "Catherine"],
    ["Prusinkiewicz", "Przemyslaw"],
  ],
  title: "A Biomechanical Model of Branch Shape in Plants",
  year: 1998,
} as const;

/** Bough itself. */
export const software = {
  authors: "The Bough authors",
  title: "Bough: the shape of plant branches under gravity and tropisms",
} as const;

/** For a list of references; `link` is where the very plant is. */
export function citation(link: string): string {
  const authors = paper.authors.map(([family, given]) => `${family}, ${given.charAt(0)}.`).join(" & ");
  return [
    `${authors} (${paper.year}). ${paper.title}.`,
    `${software.authors}. ${software.title} (version ${version}) [Computer software]. ${link}`,
  ].join("\n");
}

/** For BibTeX. */
export function bibtex(link: string): string {
  const authors = paper.authors.map((names) => names.join(", ")).join(" and ");
  return [
    `@misc{jirasek${paper.year}branch,\n  author = {${authors}},\n  title = {${paper.title}},\n  year = {${paper.year}}\n}`,
    `@misc{bough,\n  author = {{${software.authors}}},\n  title = {${software.title}},\n  version = {${version}},\n  url = {${link}}\n}`,
  ].join("\n\n");
}
