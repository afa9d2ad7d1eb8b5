// Every consumer of the npm package that is tried, and what it must show.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { npm } from "../commands.mjs";
import { Obstacle } from "../obstacle.mjs";
import { runCommand } from "../run-command.mjs";
import { examples } from "./examples.mjs";
import { requireEqual, requireReport } from "./expectation.mjs";
import { serveBy, serveFolder } from "./servers.mjs";
import { runSnippets } from "./snippets.mjs";

/**
 * @typedef {object} Consumer
 * @property {string} name
 * @property {boolean} [isQuick] part of the check
 * @property {(place: Place) => Promise<void>} run
 *
 * @typedef {object} Place
 * @property {import("./workshop.mjs").Workshop} workshop
 * @property {import("./visitor.mjs").Visitor} visitor
 */

const [thisMajor] = process.versions.node.split(".");

/** @type {readonly Consumer[]} */
export const matrix = [
  ...["20.20.2", "22.23.3", "24.21.0"].map(inNode),
  {
    name: "code blocks in the docs",
    isQuick: true,
    run: async ({ workshop, visitor }) => runSnippets(await workshop.install("documentation"), visitor),
  },
  {
    name: "two versions at once",
    isQuick: true,
    run: async ({ workshop }) => {
      const folder = await workshop.install("two-versions");
      await runCommand("two versions", [process.execPath, "--test"], { cwd: folder });
    },
  },
  {
    name: "Vite, dev and build",
    isQuick: true,
    run: async ({ workshop, visitor }) => {
      const folder = await workshop.install("vite");
      await visitServer(folder, visitor);
      await build(folder);
      await visitFolder(join(folder, "dist"), visitor);
    },
  },
  bundler("webpack"),
  bundler("esbuild"),
  bundler("Rollup", (folder) => {
    requireSmall(join(folder, "dist", "error.js"), 1000);
    requireSmall(join(folder, "dist", "presets.js"), 60_000);
  }),
  { name: "<script type=module>", run: withoutBundler },
  {
    name: "<bough-plant> without a bundler",
    run: async ({ workshop, visitor }) => visitPlants(await workshop.install("element"), visitor),
  },
  ...["React", "Vue", "Svelte"].map(withElement),
  {
    name: "TypeScript, nodenext and bundler",
    run: async ({ workshop }) => {
      const folder = await workshop.install("typescript");
      for (const script of ["nodenext", "bundler"]) {
        await runCommand(`types in ${script}`, [...npm(), "run", "--silent", script], { cwd: folder });
      }
    },
  },
  {
    name: "Next.js, server and browser",
    run: async ({ workshop, visitor }) => {
      const folder = await workshop.install("next");
      await build(folder);
      await visitServer(folder, visitor, "#server");
    },
  },
  ...examples,
];

/**
 * @param {string} version
 * @returns {Consumer}
 */
function inNode(version) {
  const [major = ""] = version.split(".");
  const isThis = major === thisMajor;
  return {
    name: `Node ${major}, script and test runner`,
    isQuick: isThis,
    run: async ({ workshop }) => {
      const folder = await workshop.install("node", isThis ? {} : { node: version });
      const node = isThis ? process.execPath : join(folder, "node_modules", "node", "bin", "node");
      requireReport(await runCommand(`a script in Node ${major}`, [node, "consume.js"], { cwd: folder }));
      await runCommand(`Node ${major}'s test runner`, [node, "--test"], { cwd: folder, limit: 120 });
    },
  };
}

/**
 * The element in an app of a framework.
 * @param {string} name
 * @returns {Consumer}
 */
function withElement(name) {
  return {
    name: `<bough-plant> in ${name}`,
    run: async ({ workshop, visitor }) => {
      const folder = await workshop.install(name.toLowerCase());
      await build(folder);
      await visitPlants(join(folder, "dist"), visitor);
    },
  };
}

/**
 * A page with two plants, as tests/consumers/plants.js has it.
 * @param {string} folder
 * @param {import("./visitor.mjs").Visitor} visitor
 */
async function visitPlants(folder, visitor) {
  const server = await serveFolder(folder);
  try {
    const { report } = await visitor.visit(server.address);
    requireEqual(
      report,
      "figure-13a ready: converged, step 13\nown ready: converged, step null\n" +
        "params 3\nstep 5\nimage/png with something in it\nimage/png with something in it",
    );
  } finally {
    server.close();
  }
}

/**
 * @param {string} name
 * @param {(folder: string) => void} [more] what else to look at in the built folder
 * @returns {Consumer}
 */
function bundler(name, more) {
  return {
    name,
    run: async ({ workshop, visitor }) => {
      const folder = await workshop.install(name.toLowerCase());
      await build(folder);
      await visitFolder(folder, visitor);
      more?.(folder);
    },
  };
}

/**
 * What is not imported is not bundled: no core, and no more than that.
 * @param {string} file
 * @param {number} most bytes
 */
function requireSmall(file, most) {
  const code = readFileSync(file, "utf8");
  if (code.length <= most && !code.includes("WebAssembly")) return;
  throw new Obstacle(`${file} has ${code.length} bytes: more was bundled than was imported.`);
}

/** @param {Place} place */
async function withoutBundler({ workshop, visitor }) {
  const folder = await workshop.install("static");
  await visitFolder(folder, visitor);
  const server = await serveFolder(folder);
  try {
    const strict = await visitor.visit(`${server.address}strict.html`, { expected: /worker/i });
    requireEqual(
      strict.report.replace(/because: .+/, "because: …"),
      "engine in thread, because: …\npool of 1 in thread\n" +
        "converged after 40 steps\nconverged after 40 steps\nconverged after 3 steps",
    );
    const missing = await visitor.visit(`${server.address}missing.html`, { expected: /404/ });
    requireEqual(missing.report, missingReport(server.address));
    const dying = await visitor.visit(`${server.address}dying.html`);
    const died = "rejected LostError: The worker failed: Uncaught Error: Thirteen.";
    const aborted = "rejected AbortError: signal is aborted without reason";
    requireEqual(dying.report, [died, 12, died, 14, aborted, 16, 17, 18].join("\n"));
  } finally {
    server.close();
  }
}

/** @param {string} address */
function missingReport(address) {
  return [
    `LoadError: What came from ${address}nowhere.wasm is not WebAssembly: the server answered 404 Not Found.`,
    `LoadError: What came from ${address}missing.html is not WebAssembly; it begins with ` +
      "“<!doctype html> <title>Bough that finds no wasm</title> <lin”: a web page, as servers send it for files they do not have.",
    "converged",
  ].join("\n");
}

/** @param {string} folder */
async function build(folder) {
  await runCommand("building", [...npm(), "run", "build"], { cwd: folder, limit: 600 });
}

/**
 * @param {string} folder
 * @param {import("./visitor.mjs").Visitor} visitor
 */
async function visitFolder(folder, visitor) {
  const server = await serveFolder(folder);
  try {
    requireReport((await visitor.visit(server.address)).report);
  } finally {
    server.close();
  }
}

/**
 * @param {string} folder
 * @param {import("./visitor.mjs").Visitor} visitor
 * @param {string} [selector] of an element that has the server's own report
 */
async function visitServer(folder, visitor, selector) {
  const server = await serveBy(folder);
  try {
    const { report, text } = await visitor.visit(server.address, selector ? { text: selector } : {});
    requireReport(report);
    if (selector) requireReport(text);
  } finally {
    server.close();
  }
}
