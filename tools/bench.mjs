// npm run bench: how fast everything is, over the floor of the machine and over every other way to do it, in one run and one table.
// Options: --quick (small sizes, few samples), --only <part>,<part>, --fresh (slow peers are timed again, not taken from
// an earlier run), --save (writes docs/evidence/bench.txt).

import { mkdirSync, writeFileSync } from "node:fs";
import { cpus } from "node:os";
import { dirname, join } from "node:path";
import { parseArgs } from "node:util";
import { buildPackage } from "./build-package.mjs";
import { Obstacle, orExplain } from "./obstacle.mjs";
import { root } from "./paths.mjs";
import { setUpForTests } from "./setup.mjs";

await orExplain(async () => {
  const { only, quick, fresh, save } = options();
  await setUpForTests();
  await buildPackage();
  // Imported only now: they need the node packages.
  const { parts } = await import("../bench/parts.mjs");
  const { launchChromium } = await import("./chromium.mjs");
  const { compileNative, compileWasm } = await import("../bench/compile.mjs");
  const { chromiumHost, nativeHost, nodeHost } = await import("../bench/hosts.mjs");
  const { Table } = await import("../bench/table.mjs");
  const unknown = only.filter((name) => !parts.some((part) => part.name === name));
  if (unknown.length > 0) {
    const names = parts.map(({ name }) => name).join(", ");
    throw new Obstacle(`There is no part ${unknown.join(", ")}; there are ${names}.`);
  }
  const program = await compileNative();
  const wasm = await compileWasm();
  const browser = await launchChromium();
  /** @type {import("../bench/bench.mjs").Bench["hosts"]} */
  const hosts = [nativeHost(program), await nodeHost(wasm), await chromiumHost(wasm, browser)];
  const effort = quick ? { repeats: 5, least: 0.01 } : { repeats: 15, least: 0.04 };
  const table = new Table();
  try {
    table.note(
      `${new Date().toISOString().slice(0, 10)}, Node ${process.version}, Chromium ${browser.version()}`,
    );
    table.note(`${cpus()[0]?.model ?? "unknown CPU"}, ${cpus().length} cores`);
    table.note(
      "Medians (min .. max). Ratios: of samples next to each other in time; “best” is that of the best samples of both.",
    );
    for (const { name, rows } of parts) {
      if (only.length === 0 || only.includes(name))
        await rows({ table, effort, quick, fresh, hosts, browser });
    }
  } finally {
    for (const host of hosts) await host.close();
    await browser.close();
  }
  if (!save) return;
  const evidence = join(root, "docs", "evidence", "bench.txt");
  mkdirSync(dirname(evidence), { recursive: true });
  writeFileSync(evidence, `${table.lines.join("\n")}\n`);
});

function options() {
  try {
    const { values } = parseArgs({
      options: {
        only: { type: "string", default: "" },
        quick: { type: "boolean", default: false },
        fresh: { type: "boolean", default: false },
        save: { type: "boolean", default: false },
      },
    });
    return { ...values, only: values.only.split(",").filter(Boolean) };
  } catch (error) {
    throw new Obstacle(error instanceof Error ? error.message : String(error), {
      remedy: "npm run bench -- --quick",
    });
  }
}
