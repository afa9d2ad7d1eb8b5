// Markdown of the course as HTML. What is written in HTML stays as it is; a block ```figure``` becomes a live plant, and
// one that is a file of a recipe, as ```html reveal/index.html```, says its name.

import MarkdownIt from "markdown-it";
import { equations } from "./equation.mjs";
import { figureBlock } from "./figure.mjs";

export const markdown = new MarkdownIt({ html: true, typographer: true }).use(equations);

const { rules } = markdown.renderer;
const { fence } = rules;

/** @type {NonNullable<typeof fence>} */
rules.fence = (tokens, index, ...rest) => {
  const token = tokens[index];
  if (token?.info === "figure") return figureBlock(token.content, (text) => markdown.renderInline(text));
  const [, file] = token?.info.split(" ") ?? [];
  const name = file ? `<p class="file">${file.replace(/^\w+\//, "")}</p>\n` : "";
  return name + (fence?.(tokens, index, ...rest) ?? "");
};
