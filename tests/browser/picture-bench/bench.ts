/** A stage in real Chromium, without the explorer around it. */
import { fileURLToPath } from "node:url";
import type { Browser, Page } from "playwright";
import { build, preview } from "vite";
import type { Bench } from "./page.ts";

/** The bench's page, built and served; closed by `close`. */
export async function serveBench(): Promise<{ address: string; close: () => Promise<void> }> {
  const root = fileURLToPath(new URL(".", import.meta.url));
  const outDir = fileURLToPath(new URL("../../../dist/picture-bench", import.meta.url));
  const shared = { root, configFile: false, logLevel: "error", base: "./" } as const;
  await build({
    ...shared,
    worker: { format: "es" },
    build: { outDir, emptyOutDir: true, chunkSizeWarningLimit: 1e4 },
  });
  const server = await preview({ ...shared, build: { outDir }, preview: { host: "127.0.0.1", port: 0 } });
  const address = server.resolvedUrls?.local[0];
  if (!address) throw new Error("The preview server has no address.");
  return { address, close: () => server.close() };
}

/** Opens the bench with a plant on it. Motion is unwelcome. */
export async function visitBench(
  browser: Browser,
  address: string,
  ...shown: Parameters<Bench["show"]>
): Promise<Page> {
  const context = await browser.newContext({
    viewport: { width: 900, height: 600 },
    reducedMotion: "reduce",
  });
  const page = await context.newPage();
  await page.goto(address);
  await page.waitForFunction(() => window.bench !== undefined);
  await page.evaluate(async (shown) => window.bench.show(...shown), shown);
  return page;
}
