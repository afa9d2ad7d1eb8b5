// The docs site: the repository's Markdown as pages in dist/site/docs, searchable, and readable without a network once it was visited.

import { createHash } from "node:crypto";
import {
  copyFileSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  writeFileSync,
} from "node:fs";
import { dirname, join, posix } from "node:path";
import { bundle } from "./bundle.mjs";
import { checkLinks } from "./docs/links.mjs";
import { rendered } from "./docs/markdown.mjs";
import { beside, pages } from "./docs/pages.mjs";
import { escaped, framed } from "./docs/template.mjs";
import { Obstacle } from "./obstacle.mjs";
import { root, site } from "./paths.mjs";
import { stylesheet } from "./stylesheet.mjs";

const source = join(root, "web", "docs");

/** How the docs are searched; the page gets it with the index, as both must be asked alike. */
const searched = {
  fields: ["heading", "text", "page"],
  storeFields: ["page", "heading"],
  searchOptions: {
    prefix: true,
    fuzzy: 0.15,
    boost: { heading: 4, page: 2 },
    combineWith: /** @type {const} */ ("AND"),
  },
};

/** @param {string} [outDir] where the whole site is */
export async function buildDocs(outDir = site) {
  const folder = join(outDir, "docs");
  rmSync(folder, { recursive: true, force: true });
  const docs = new Docs(folder);
  for (const page of pages) docs.page(page);
  docs.linkedFiles();
  await docs.search();
  writeFileSync(join(folder, "docs.css"), stylesheet(join(source, "docs.css")));
  docs.offline();
  console.log(
    `✓ building the docs: ${pages.length} pages, ${checkLinks(outDir, folder)} links lead somewhere`,
  );
}

class Docs {
  #folder;
  /** Files of the repository that pages link to, and that are no pages themselves. @type {Set<string>} */
  #linked = new Set();
  /** @type {{ id: string, page: string, heading: string, text: string }[]} */
  #sections = [];

  /** @param {string} folder */
  constructor(folder) {
    this.#folder = folder;
  }

  /** @param {import("./docs/pages.mjs").Page} page */
  page({ source: markdown, file, title }) {
    const text = readFileSync(join(root, markdown), "utf8");
    const { html, sections } = rendered(text, (href) => this.#address(href, markdown, file));
    for (const { anchor, heading, text: words } of sections) {
      this.#sections.push({ id: `${file}#${anchor}`, page: title, heading, text: words });
    }
    this.#write(file, framed({ file, title, html, sections }));
  }

  /** Shows the files that pages link to: text as it is, folders as lists of what they hold. */
  linkedFiles() {
    for (const path of this.#linked) {
      const file = `files/${path}.html`;
      const place = join(root, path);
      const html = statSync(place).isDirectory()
        ? `<ul>${readdirSync(place)
            // What tools put there is none of the repository's.
            .filter((name) => !/^\.|^(node_modules|dist|__pycache__|static)$/.test(name))
            .map(
              (name) => `<li><a href="${this.#address(name, `${path}/x`, file)}">${escaped(name)}</a></li>`,
            )
            .join("")}</ul>`
        : `<pre tabindex="0" role="group" aria-label="The file"><code>${escaped(readFileSync(place, "utf8"))}</code></pre>`;
      this.#write(file, framed({ file, title: path, html: `<h1>${escaped(path)}</h1>${html}` }));
    }
  }

  /** The index of all sections, and the script that asks it. */
  async search() {
    const { default: MiniSearch } = await import("minisearch");
    const index = new MiniSearch(searched);
    index.addAll(this.#sections);
    this.#write("search.json", JSON.stringify({ options: searched, index }));
    await bundle({
      build: {
        outDir: this.#folder,
        emptyOutDir: false,
        lib: { entry: join(source, "search.ts"), formats: ["es"], fileName: () => "search.js" },
      },
    });
  }

  /** The script that keeps the docs for readers without a network. It must change with any file. */
  offline() {
    const files = readdirSync(this.#folder, { recursive: true, encoding: "utf8" })
      .filter((file) => statSync(join(this.#folder, file)).isFile())
      .map((file) => file.replaceAll("\\", "/"))
      .sort();
    const hash = createHash("sha256");
    for (const file of files) hash.update(readFileSync(join(this.#folder, file)));
    const kept = { name: `bough-docs-${hash.digest("hex").slice(0, 12)}`, files: ["./", ...files] };
    const script = readFileSync(join(source, "offline.js"), "utf8");
    this.#write("offline.js", `const kept = ${JSON.stringify(kept)};\n${script}`);
  }

  /**
   * Where a link of a document leads on the site.
   * @param {string} href
   * @param {string} from the document
   * @param {string} file the page it becomes
   */
  #address(href, from, file) {
    if (/^[a-z]+:|^#/i.test(href)) return href;
    const [path = "", place] = href.split("#");
    const target = posix.normalize(posix.join(posix.dirname(from), path)).replace(/\/$/, "");
    if (!existsSync(join(root, target)))
      throw new Obstacle(`${from} links to ${href}, which does not exist.`);
    const found =
      pages.find((page) => page.source === target)?.file ?? beside.get(target) ?? this.#fileOf(target);
    const way = posix.relative(posix.dirname(file), found);
    return place === undefined ? way : `${way}#${place}`;
  }

  /** @param {string} path */
  #fileOf(path) {
    if (!/\.(png|svg|webp)$/.test(path)) {
      this.#linked.add(path);
      return `files/${path}.html`;
    }
    const copy = posix.basename(path);
    mkdirSync(this.#folder, { recursive: true });
    copyFileSync(join(root, path), join(this.#folder, copy));
    return copy;
  }

  /**
   * @param {string} file
   * @param {string} content
   */
  #write(file, content) {
    const path = join(this.#folder, file);
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, content);
  }
}
