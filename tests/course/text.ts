/** The course as it is written: its pages, its figures, its links. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { type Figure, readFigure } from "../../tools/course/figure.mjs";
import { courseFolder, coursePages } from "../../tools/course/pages.mjs";

const folder = join(courseFolder, "edition");

/** The chapters of the edition as Markdown, by the name in their address. */
export const chapters: ReadonlyMap<string, string> = new Map(
  readdirSync(folder)
    .sort()
    .map((file) => [file.replace(/^\d+-|\.md$/g, ""), readFileSync(join(folder, file), "utf8")]),
);

const figurePattern = /```figure\n(.*?)```/gs;

/** The live figures, by name. */
export const figures: ReadonlyMap<string, Figure> = new Map(
  [...chapters.values()]
    .flatMap((text) => [...text.matchAll(figurePattern)])
    .map(([, lines = ""]) => readFigure(lines))
    .map((figure) => [figure.id, figure]),
);

/** What a reader reads of a chapter, on one line: figures by their captions, no equations of their own, no addresses. */
export function prose(chapter: string): string {
  const text = chapters.get(chapter);
  if (text === undefined) throw new Error(`There is no chapter ${chapter}.`);
  return text
    .replace(figurePattern, (_, lines: string) => readFigure(lines).caption)
    .replace(/\$\$.*?\$\$/gs, " … ")
    .replace(/\]\([^)]*\)/g, "]")
    .replace(/<[^>]*>/g, " ")
    .replace(/[*[\]]/g, "")
    .replace(/\s+/g, " ");
}

/** The built pages by file name; what loads the figures is left out. */
export const pages: ReadonlyMap<string, string> = coursePages("");

/** A link of a page. */
export interface Link {
  readonly page: string;
  readonly address: string;
  readonly text: string;
}

/** All links, in order. */
export const links: readonly Link[] = [...pages].flatMap(([page, html]) =>
  [...html.matchAll(/<a\b[^>]*? href="([^"]*)"[^>]*>(.*?)<\/a>/gs)].map(([, address = "", text = ""]) => ({
    page,
    address: address.replaceAll("&amp;", "&"),
    text: text.replace(/<[^>]*>/g, ""),
  })),
);

/** The states of Bough that are linked to: text and query. */
export const stateLinks = links.flatMap(({ page, address, text }) =>
  address.startsWith("../?") ? [{ page, text, query: address.slice(4) }] : [],
);
