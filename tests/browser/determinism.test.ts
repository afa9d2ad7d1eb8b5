/** Chromium grows every preset to the last bit as Node and the native core do: in the page's thread and in the worker. */
import { readFileSync } from "node:fs";
import type { Browser } from "playwright";
import { createServer, type ViteDevServer } from "vite";
import { afterAll, beforeAll, expect, it } from "vitest";
import { root } from "../../tools/paths.mjs";
import { launchChromium } from "./chromium.ts";

const recorded = readFileSync(new URL("../contract/fingerprints.txt", import.meta.url), "utf8");

let browser: Browser;
let server: ViteDevServer;
beforeAll(async () => {
  browser = await launchChromium();
  // The sources themselves, not the built page: what runs here is the engine alone.
  server = await createServer({
    server: { host: "127.0.0.1", port: 0, fs: { allow: [root] } },
    // The engine needs no packages: nothing to search and bundle for the development server.
    optimizeDeps: { noDiscovery: true },
    logLevel: "error",
  });
  await server.listen();
});
afterAll(async () => {
  await browser.close();
  await server.close();
});

it.each(["workerEngine", "threadEngine"] as const)("with %s", async (transport) => {
  const page = await browser.newPage();
  const address = server.resolvedUrls?.local[0] ?? "";
  await page.route(`${address}blank`, (route) => route.fulfill({ contentType: "text/html", body: "" }));
  await page.goto(`${address}blank`);
  // As text: the page imports for itself, and Vitest must not rewrite that.
  const lines = await page.evaluate(`(async () => {
    const { ${transport} } = await import("/src/engine/engine.ts");
    const { presets } = await import("/src/params/declaration.ts");
    const { fingerprint } = await import("/@fs${root}/tests/fingerprint.ts");
    const engine = ${transport}();
    const lines = [];
    for (const [id, { params, step = null }] of Object.entries(presets)) {
      const inPaper = { ...params, solver: { ...params.solver, discretization: "paper" } };
      lines.push(id + " " + fingerprint(await engine.plant(params, step)) + "\\n");
      lines.push(id + "/paper " + fingerprint(await engine.plant(inPaper, step)) + "\\n");
    }
    engine.dispose();
    return lines.join("");
  })()`);
  expect(lines).toBe(recorded);
  await page.close();
});
