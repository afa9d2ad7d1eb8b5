// The pages of the course: web/course/*.md, each in the frame that all share. The edition is many chapters on one page.

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { root } from "../paths.mjs";
import { markdown } from "./markdown.mjs";

export const courseFolder = join(root, "web", "course");

/** What the reader needs besides the text. */
export const builtScripts =
  '<script src="../bough-widget.js" defer></script>\n<script src="course.js" defer></script>';

/** In the order of the menu. */
const menu = [
  { name: "index", title: "The edition" },
  { name: "teaching", title: "Teaching" },
  { name: "worksheet", title: "Worksheet" },
  { name: "recipes", title: "Recipes" },
];

/**
 * The HTML of every page, by file name.
 * @param {string} scripts
 * @returns {Map<string, string>}
 */
export function coursePages(scripts) {
  return new Map(
    menu.map(({ name }) => {
      const content = name === "index" ? edition() : sheet(name);
      return [`${name}.html`, frame(name, content, scripts)];
    }),
  );
}

/** @typedef {{ title: string, description: string, html: string }} Content */

/**
 * Chapter after chapter, with a table of contents.
 * @returns {Content}
 */
function edition() {
  const files = readdirSync(join(courseFolder, "edition")).sort();
  const chapters = files.map((file) => {
    const html = markdown.render(read(join("edition", file)));
    const [, heading = ""] = /<h2>(.*?)<\/h2>/.exec(html) ?? [];
    const id = file.replace(/^\d+-|\.md$/g, "");
    return { id, heading, html };
  });
  const links = chapters.map(({ id, heading }) => `<li><a href="#${id}">${heading}</a></li>`).join("\n");
  const start = sheet("edition");
  const body = chapters.map(({ id, html }) => `<section id="${id}">\n${html}</section>`).join("\n");
  const contents = `<nav class="contents" aria-label="Contents"><ol start="0">${links}</ol></nav>`;
  return { ...start, html: `${start.html}${contents}\n${body}` };
}

/**
 * @param {string} name
 * @returns {Content}
 */
function sheet(name) {
  const [first = "", ...rest] = read(`${name}.md`).split("\n");
  const [, description] = /^<!-- (.+) -->$/.exec(first) ?? [];
  if (!description) throw new Error(`${name}.md must begin with what it is about, as a comment.`);
  const html = markdown.render(rest.join("\n"));
  const [, title = ""] = /<h1>(.*?)<\/h1>/.exec(html) ?? [];
  return { title, description, html };
}

/** @param {string} file */
function read(file) {
  return readFileSync(join(courseFolder, file), "utf8");
}

/**
 * @param {string} name
 * @param {Content} content
 * @param {string} scripts
 */
function frame(name, { title, description, html }, scripts) {
  const links = menu.map((page) => {
    const present = page.name === name ? ' aria-current="page"' : "";
    return `<li><a href="${page.name}.html"${present}>${page.title}</a></li>`;
  });
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${title} – Bough</title>
<meta name="description" content="${description}">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="../favicon.svg" type="image/svg+xml">
<link rel="stylesheet" href="course.css">
${scripts}
</head>
<body class="${name}">
<a class="skip" href="#text">Skip to the text</a>
<header>
<a class="home" href="../index.html">Bough</a>
<nav aria-label="Course"><ul>
${links.join("\n")}
<li><a href="../docs/index.html">Docs</a></li>
</ul></nav>
</header>
<main id="text">
${html}</main>
<footer><p>Text and figures of this course: <a href="https://creativecommons.org/licenses/by/4.0/" rel="license">CC BY 4.0</a>. The program: MIT or Apache-2.0. <a href="teaching.html#licence">How to cite and reuse</a>.</p></footer>
</body>
</html>
`;
}
