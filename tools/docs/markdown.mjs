// Markdown of the repository as HTML, and its sections as they are searched.

import MarkdownIt from "markdown-it";

/**
 * @typedef {object} Section
 * @property {string} anchor
 * @property {string} heading
 * @property {string} text
 */

/**
 * @param {string} text
 * @param {(href: string) => string} linked what a link of the source becomes on the site
 * @returns {{ html: string, sections: Section[] }}
 */
export function rendered(text, linked) {
  const markdown = new MarkdownIt({ html: false, linkify: false });
  const anchors = new Set();
  /** @type {Section[]} */
  const sections = [];
  markdown.core.ruler.push("site", ({ tokens }) => {
    for (const [index, token] of tokens.entries()) {
      const inline = tokens[index + 1];
      if (token.type === "heading_open" && inline) {
        const heading = plain(inline);
        const anchor = fresh(slug(heading), anchors);
        token.attrSet("id", anchor);
        sections.push({ anchor, heading, text: "" });
      }
      const section = sections.at(-1);
      if (token.type === "inline" && section && tokens[index - 1]?.type !== "heading_open")
        section.text += ` ${plain(token)}`;
      if (token.type === "fence" && section) section.text += ` ${token.content}`;
      for (const child of token.children ?? []) {
        for (const name of ["href", "src"]) {
          const address = child.attrGet(name);
          if (address !== null) child.attrSet(name, linked(String(address)));
        }
      }
    }
  });
  markdown.core.ruler.push("headless", (state) => {
    state.tokens = withoutEmptyHeads(state.tokens);
  });
  const { rules } = markdown.renderer;
  // What is wider than a phone scrolls by itself, and by keys.
  rules.table_open = () => '<div class="wide" tabindex="0" role="group" aria-label="Table"><table>\n';
  rules.table_close = () => "</table></div>\n";
  rules.fence = (tokens, index) => {
    const { content = "", info = "" } = tokens[index] ?? {};
    const code = markdown.utils.escapeHtml(content);
    return `<pre tabindex="0" role="group" aria-label="${info ? `Code, ${info}` : "Diagram"}"><code>${code}</code></pre>\n`;
  };
  rules.code_block = rules.fence;
  return { html: markdown.render(text), sections };
}

/**
 * Markdown knows no table without a head; one with nothing in it is none.
 * @param {import("markdown-it").Token[]} tokens
 */
function withoutEmptyHeads(tokens) {
  const kept = [];
  for (let at = 0; at < tokens.length; at++) {
    const token = tokens[at];
    if (token?.type === "thead_open") {
      const end = tokens.findIndex(({ type }, index) => index > at && type === "thead_close");
      if (tokens.slice(at, end).every(({ content }) => content === "")) {
        at = end;
        continue;
      }
    }
    if (token) kept.push(token);
  }
  return kept;
}

/** @param {import("markdown-it").Token} token */
function plain({ children }) {
  return (children ?? []).map(({ type, content }) => (type === "softbreak" ? " " : content)).join("");
}

/** As GitHub makes it. @param {string} heading */
function slug(heading) {
  return heading
    .toLowerCase()
    .replace(/[^\p{L}\p{N} _-]/gu, "")
    .replaceAll(" ", "-");
}

/**
 * @param {string} wanted
 * @param {Set<unknown>} taken
 */
function fresh(wanted, taken) {
  let anchor = wanted;
  for (let copy = 1; taken.has(anchor); copy++) anchor = `${wanted}-${copy}`;
  taken.add(anchor);
  return anchor;
}
