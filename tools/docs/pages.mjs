// Which documents of the repository are pages of the docs site, and in which order.

/**
 * @typedef {object} Page
 * @property {string} source the Markdown file
 * @property {string} file the page, in the folder of the docs
 * @property {string} title in the contents
 */

/** @type {readonly { group: string, pages: readonly Page[] }[]} */
export const groups = [
  {
    group: "Start",
    pages: [
      page("README.md", "index", "What Bough is"),
      page("docs/package.md", "package", "The npm package"),
      page("examples/README.md", "examples", "Examples"),
      page("docs/features.md", "features", "Beside other pages"),
    ],
  },
  {
    group: "Recipes",
    pages: [
      page("docs/three.md", "three", "Plants in three.js"),
      page("docs/sweeps.md", "sweeps", "Sweeps"),
      page("docs/widget.md", "widget", "A plant in your page"),
      page("docs/links.md", "links", "Links"),
      page("python/README.md", "notebooks", "Notebooks"),
    ],
  },
  {
    group: "Reference",
    pages: [
      page("docs/parameters.md", "parameters", "Parameters and presets"),
      page("docs/api.md", "api", "API"),
      page("docs/promises.md", "promises", "What is promised"),
      page("docs/stability.md", "stability", "What stays as it is"),
      page("CHANGELOG.md", "changelog", "Changes"),
    ],
  },
  {
    group: "Inside",
    pages: [
      page("docs/how-it-computes.md", "how-it-computes", "How it computes"),
      page("docs/benchmarks.md", "benchmarks", "Benchmarks"),
      page("ARCHITECTURE.md", "architecture", "Architecture"),
      page("rust-core/bough/README.md", "crate", "The Rust crate"),
    ],
  },
];

export const pages = groups.flatMap(({ pages }) => pages);

/** Sources of what lies beside the docs on the site. */
export const beside = new Map([["web/course", "../course/index.html"]]);

/** What lies beside the docs on the site. */
export function neighbours() {
  return [
    { href: "../index.html", title: "Grow a branch" },
    { href: "../course/index.html", title: "Course" },
  ];
}

/**
 * @param {string} source
 * @param {string} name
 * @param {string} title
 * @returns {Page}
 */
function page(source, name, title) {
  return { source, file: `${name}.html`, title };
}
