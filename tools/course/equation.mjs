// Equations in Markdown: `$…$` in a line, and `$$` above and below one of its own, which may end in its number, `\tag{9}`.
// They become MathML when the page is built: browsers draw it, and no page loads anything for it.

import katex from "katex";

/** @param {InstanceType<typeof import("markdown-it").default>} markdown */
export function equations(markdown) {
  markdown.inline.ruler.before("escape", "equation", (state, silent) => {
    if (state.src[state.pos] !== "$") return false;
    const end = state.src.indexOf("$", state.pos + 1);
    if (end < 0) return false;
    if (!silent) {
      state.push("html_inline", "", 0).content = mathml(state.src.slice(state.pos + 1, end), false);
    }
    state.pos = end + 1;
    return true;
  });
  markdown.block.ruler.before("fence", "equation", (state, start, last, silent) => {
    const isFence = (/** @type {number} */ line) => state.getLines(line, line + 1, 0, false).trim() === "$$";
    if (!isFence(start)) return false;
    if (silent) return true;
    let end = start + 1;
    while (end < last && !isFence(end)) end++;
    if (end === last) throw new Error(`An equation has no end: ${state.getLines(start, last, 0, false)}`);
    state.push("html_block", "", 0).content = display(state.getLines(start + 1, end, 0, false));
    state.line = end + 1;
    return true;
  });
}

/** @param {string} tex */
function display(tex) {
  const [, body = "", number] = /^(.*?)(?:\\tag\{(.+)\})?$/s.exec(tex.trim()) ?? [];
  const tag = number ? `<span class="number">(${number})</span>` : "";
  return `<div class="equation">${mathml(body, true)}${tag}</div>\n`;
}

/**
 * @param {string} tex
 * @param {boolean} displayMode
 */
function mathml(tex, displayMode) {
  return katex.renderToString(tex, { displayMode, output: "mathml", throwOnError: true, strict: "error" });
}
