// Every host of course material that is tried from its own package, with the recipe that the course prints for it.

import { cpSync, mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { buildNotebook } from "../build-notebook.mjs";
import { buildSite } from "../build-site.mjs";
import { launchChromium } from "../chromium.mjs";
import { serveFolder } from "../consumers/servers.mjs";
import { Obstacle } from "../obstacle.mjs";
import { root, site } from "../paths.mjs";
import { runCommand } from "../run-command.mjs";
import { installFromNpm, installFromPyPi } from "../setup/peers.mjs";
import { move, visit } from "./guest.mjs";
import { startJupyter, useNotebook, writeNotebook } from "./jupyter.mjs";
import { layOut } from "./recipe.mjs";

const locks = join(root, "tests", "hosts");

/**
 * @typedef {object} Host
 * @property {string} name
 * @property {(place: Place) => Promise<string>} run what it found, in a few words
 *
 * @typedef {object} Place
 * @property {string} folder an empty one
 * @property {import("playwright").Browser} browser
 */

/** @type {readonly Host[]} */
const matrix = [
  {
    name: "reveal.js",
    run: async ({ folder, browser }) => {
      await layOut("reveal", folder);
      cpSync(join(await fromNpm(), "reveal.js", "dist"), join(folder, "reveal"), { recursive: true });
      copyWidget(folder);
      return serve(folder, browser, useSlides);
    },
  },
  {
    name: "MkDocs",
    run: async ({ folder, browser }) => {
      await layOut("mkdocs", folder);
      copyWidget(join(folder, "docs"));
      await python("building with MkDocs", ["-m", "mkdocs", "build", "--strict"], folder);
      return serve(join(folder, "site"), browser, useOne);
    },
  },
  {
    name: "Sphinx",
    run: async ({ folder, browser }) => {
      await layOut("sphinx", folder);
      copyWidget(join(folder, "_static"));
      await python("building with Sphinx", ["-m", "sphinx", "-W", "-b", "html", ".", "built"], folder);
      return serve(join(folder, "built"), browser, useOne);
    },
  },
  {
    name: "Docsify",
    run: async ({ folder, browser }) => {
      await layOut("docsify", folder);
      cpSync(join(await fromNpm(), "docsify", "dist"), join(folder, "docsify"), { recursive: true });
      copyWidget(folder);
      return serve(folder, browser, useOne);
    },
  },
  {
    name: "JupyterLab",
    run: async ({ folder, browser }) => {
      await buildNotebook();
      await python(
        "installing the widget",
        ["-m", "pip", "install", "--quiet", "--no-deps", "--force-reinstall", "./python"],
        root,
      );
      await python("its own tests", ["-m", "pytest", "-q", "-p", "no:cacheprovider", "python/tests"], root);
      await writeNotebook(folder);
      const server = await startJupyter(await fromPyPi(), folder);
      try {
        const address = `${server.address}lab/tree/plant.ipynb`;
        return await visit(
          browser,
          address,
          useNotebook,
          /favicon|source ?map|Failed to load resource|translation/i,
        );
      } finally {
        server.close();
      }
    },
  },
];

/** @type {Promise<void> | undefined} */
let built;

/** The hosts as shards of the soak. */
export const hosts = matrix.map(({ name, run }) => ({
  name,
  run: async () => {
    built ??= buildSite();
    await built;
    const folder = mkdtempSync(join(tmpdir(), "bough-host-"));
    const browser = await launchChromium();
    try {
      return await run({ folder, browser });
    } catch (error) {
      throw error instanceof Obstacle ? error : new Obstacle(String(error));
    } finally {
      await browser.close();
      rmSync(folder, { recursive: true, force: true, maxRetries: 3 });
    }
  },
}));

function fromNpm() {
  return installFromNpm(locks, "the hosts");
}

function fromPyPi() {
  return installFromPyPi(locks, "the hosts");
}

/**
 * @param {string} purpose
 * @param {readonly string[]} args
 * @param {string} cwd
 */
async function python(purpose, args, cwd) {
  await runCommand(purpose, [await fromPyPi(), ...args], { cwd });
}

/** @param {string} folder */
function copyWidget(folder) {
  mkdirSync(folder, { recursive: true });
  cpSync(join(site, "bough-widget.js"), join(folder, "bough-widget.js"));
}

/**
 * @param {string} folder
 * @param {import("playwright").Browser} browser
 * @param {(page: import("playwright").Page) => Promise<string>} use
 */
async function serve(folder, browser, use) {
  const server = await serveFolder(folder);
  try {
    return await visit(browser, server.address, use);
  } finally {
    server.close();
  }
}

/** @param {import("playwright").Page} page */
async function useOne(page) {
  await page.getByText("The text goes on").waitFor();
  return `a live plant: ${await move(page.locator("bough-plant"))}`;
}

/** @param {import("playwright").Page} page */
async function useSlides(page) {
  const [first, second] = [page.locator("bough-plant").nth(0), page.locator("bough-plant").nth(1)];
  const found = [await move(first)];
  const slide = () => page.evaluate(() => Reflect.get(globalThis, "Reveal").getIndices().h);
  await first.getByRole("slider", { name: "Gravity" }).press("ArrowRight");
  if ((await slide()) !== 0) throw new Obstacle("An arrow key on a slider turned the page.");
  await first.evaluate((element) => element.blur());
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => Reflect.get(globalThis, "Reveal").getIndices().h === 1);
  found.push(await move(second));
  return `live plants on two slides: ${found.join(", ")}`;
}
