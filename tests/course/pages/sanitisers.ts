/**
 * What platforms for teaching let through, as they publish it. Canvas: `SANITIZE` of its package canvas_sanitize. Moodle,
 * where students write: HTML Purifier with the doctype XHTML 1.0 Transitional (`purify_html` of weblib.php), which knows
 * neither frames nor scripts.
 */
import type { IOptions } from "sanitize-html";

const common = (tags: string, attributes: Readonly<Record<string, string>>): IOptions => ({
  allowedTags: tags.split(" "),
  allowedAttributes: Object.fromEntries(
    Object.entries(attributes).map(([tag, names]) => [tag, names.split(" ")]),
  ),
  allowedSchemes: ["http", "https", "mailto", "ftp"],
  allowProtocolRelative: false,
});

/** An older list of theirs, which lacks `loading` and `allow`: what passes here passes now. */
export const canvas: IOptions = common(
  "a b blockquote br caption cite code col hr h1 h2 h3 h4 h5 h6 h7 h8 del ins iframe font colgroup dd div dl dt em " +
    "figure figcaption i img li ol p pre q small span strike strong sub sup table tbody td tfoot th thead tr u ul " +
    "object embed param video audio",
  {
    "*": "style class id title role lang dir aria-labelledby aria-describedby aria-hidden aria-label",
    a: "href target name",
    img: "align alt height src width",
    iframe:
      "src width height name align frameborder scrolling sandbox allowfullscreen webkitallowfullscreen mozallowfullscreen",
    ol: "start type",
    td: "abbr axis colspan rowspan width align valign dir",
    th: "abbr axis colspan rowspan width align valign dir scope",
  },
);

export const purifier: IOptions = common(
  "a abbr acronym b bdo big blockquote br caption center cite code col colgroup dd del dfn dir div dl dt em font h1 h2 h3 " +
    "h4 h5 h6 hr i img ins kbd li menu ol p pre q s samp small span strike strong sub sup table tbody td tfoot th thead " +
    "tr tt u ul var",
  {
    "*": "class style title lang dir",
    a: "href rel rev name target",
    img: "alt src width height align border hspace vspace longdesc name",
  },
);
