// The frame of every page of the docs.

import { groups, neighbours } from "./pages.mjs";

/**
 * @param {object} content
 * @param {string} content.file the page, in the folder of the docs
 * @param {string} content.title
 * @param {string} content.html
 * @param {readonly import("./markdown.mjs").Section[]} [content.sections]
 */
export function framed({ file, title, html, sections = [] }) {
  const up = "../".repeat(file.split("/").length - 1);
  const contents = groups
    .map(({ group, pages }) => {
      const links = pages.map((page) => item(`${up}${page.file}`, page.title, page.file === file));
      return `<h2>${group}</h2><ul>${links.join("")}</ul>`;
    })
    .join("");
  const beside = neighbours().map(({ href, title: name }) => `<a href="${up}${href}">${name}</a>`);
  const within = sections.slice(1).filter(({ anchor }) => anchor !== "");
  const outline =
    within.length < 3 || within.length > 40
      ? ""
      : `<nav class="outline" aria-label="On this page"><h2>On this page</h2><ul>${within.map(({ anchor, heading }) => item(`#${anchor}`, heading, false)).join("")}</ul></nav>`;
  return `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8">
    <meta name="viewport" content="width=device-width, initial-scale=1">
    <meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; worker-src 'self'; base-uri 'none'; form-action 'none'">
    <meta name="color-scheme" content="light dark">
    <title>${escaped(title)} · Bough</title>
    <link rel="icon" href="${up}../favicon.svg" type="image/svg+xml">
    <link rel="stylesheet" href="${up}docs.css">
    <script type="module" src="${up}search.js"></script>
  </head>
  <body>
    <a class="skip" href="#content">To the text</a>
    <header>
      <a class="name" href="${up}index.html">Bough</a>
      <search class="search" hidden data-docs="${up}">
        <label for="words">Search</label>
        <input id="words" type="search" autocomplete="off" spellcheck="false">
        <div class="found" hidden><p class="count" role="status"></p><ol></ol></div>
      </search>
      <nav class="beside" aria-label="Beside the docs">${beside.join(" ")}</nav>
    </header>
    <nav class="contents" aria-label="Contents"><details open><summary>Contents</summary>${contents}</details></nav>
    <main id="content">${html}</main>
    ${outline}
  </body>
</html>
`;
}

/**
 * @param {string} href
 * @param {string} text
 * @param {boolean} isCurrent
 */
function item(href, text, isCurrent) {
  return `<li><a href="${href}"${isCurrent ? ' aria-current="page"' : ""}>${escaped(text)}</a></li>`;
}

/** @param {string} text */
export function escaped(text) {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll('"', "&quot;");
}
