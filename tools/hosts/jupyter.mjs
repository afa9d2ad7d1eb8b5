// JupyterLab with a notebook that shows a plant: what the reader moves comes back to Python, and what Python sets is shown.

import { spawn } from "node:child_process";
import { writeFile } from "node:fs/promises";
import { join } from "node:path";
import { Obstacle } from "../obstacle.mjs";
import { recipe } from "./recipe.mjs";

/**
 * Writes the cells of the recipe as a notebook.
 * @param {string} folder
 */
export async function writeNotebook(folder) {
  const files = recipe("jupyter");
  const cells = ["show.py", "read.py", "write.py", "read.py"].map((file, at) => ({
    cell_type: "code",
    id: `cell-${at}`,
    execution_count: null,
    metadata: {},
    outputs: [],
    source: files.get(file)?.trim() ?? "",
  }));
  const kernelspec = { display_name: "Python 3", language: "python", name: "python3" };
  const notebook = { cells, metadata: { kernelspec }, nbformat: 4, nbformat_minor: 5 };
  await writeFile(join(folder, "plant.ipynb"), JSON.stringify(notebook));
}

/**
 * Starts JupyterLab, for this machine only.
 * @param {string} python
 * @param {string} folder
 * @returns {Promise<{ address: string, close: () => void }>}
 */
export function startJupyter(python, folder) {
  const options = [
    "--no-browser",
    "--allow-root",
    "--ip=127.0.0.1",
    "--port=0",
    "--ServerApp.port_retries=0",
  ];
  const open = [
    "--IdentityProvider.token=",
    "--ServerApp.password=",
    "--LabApp.news_url=",
    "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate",
  ];
  const child = spawn(python, ["-m", "jupyter", "lab", ...options, ...open], {
    cwd: folder,
    env: {
      ...process.env,
      JUPYTER_CONFIG_DIR: join(folder, ".jupyter"),
      JUPYTER_DATA_DIR: join(folder, ".data"),
    },
  });
  return new Promise((resolve, reject) => {
    let output = "";
    const close = () => void child.kill();
    const timer = setTimeout(() => {
      close();
      reject(new Obstacle("JupyterLab did not start within two minutes.", { output }));
    }, 120_000);
    child.on("error", (error) => reject(new Obstacle(`JupyterLab did not start: ${error.message}`)));
    child.stderr.setEncoding("utf8").on("data", (text) => {
      output += text;
      const [, address] = /(http:\/\/127\.0\.0\.1:\d+\/)lab/.exec(output) ?? [];
      if (!address) return;
      clearTimeout(timer);
      resolve({ address, close });
    });
  });
}

/**
 * Runs the notebook's cells as a reader does.
 * @param {import("playwright").Page} page
 */
export async function useNotebook(page) {
  const cells = page.locator(".jp-Notebook .jp-CodeCell");
  await cells.first().waitFor({ timeout: 60_000 });
  await page.getByText("Python 3", { exact: false }).first().waitFor();
  const run = async (/** @type {number} */ at) => {
    await cells.nth(at).locator(".jp-InputArea-editor").click();
    await page.keyboard.press("Control+Enter");
  };
  const outputOf = (/** @type {number} */ at, /** @type {string} */ text) =>
    cells.nth(at).locator(".jp-OutputArea-output", { hasText: text }).waitFor({ timeout: 60_000 });
  await run(0);
  const plant = page.locator("bough-plant");
  await plant.waitFor({ timeout: 60_000 });
  await settle(plant);
  await plant.getByRole("slider", { name: "Gravity" }).fill("2");
  await settle(plant);
  await run(1);
  await outputOf(1, "&g=2'");
  await run(2);
  await page.waitForFunction(() => /[?&]g=1\.62/.test(document.querySelector("bough-plant")?.link ?? ""));
  await settle(plant);
  await run(3);
  await outputOf(3, "1.62");
  return "a slider moved is read in Python, what Python sets is shown";
}

/** @param {import("playwright").Locator} plant */
function settle(plant) {
  return plant.evaluate(async (element) => {
    const plant = /** @type {HTMLElementTagNameMap["bough-plant"]} */ (element);
    await plant.settled();
    await plant.toBlob();
  });
}
