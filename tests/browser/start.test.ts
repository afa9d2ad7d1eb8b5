/** The page as `npm start` serves it: from the sources, not as built. */
import { spawn } from "node:child_process";
import { once } from "node:events";
import { join } from "node:path";
import { createInterface } from "node:readline";
import type { Browser } from "playwright";
import { afterAll, beforeAll, expect, test } from "vitest";
import { root } from "../../tools/paths.mjs";
import { launchChromium } from "./chromium.ts";
import { settled } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

/** Starts it on a free port; the address it tells. */
async function start() {
  const command = [join(root, "tools", "start.mjs"), "--host", "127.0.0.1", "--port", "0"];
  const server = spawn(process.execPath, command, { env: { ...process.env, NO_COLOR: "1" } });
  for await (const line of createInterface(server.stdout)) {
    const address = /http:\/\/\S+/.exec(line)?.[0];
    if (address) return { address, stop: () => server.kill() && once(server, "exit") };
  }
  throw new Error("npm start ended without an address.");
}

test("npm start shows the page and its study styled, and nothing is refused", async () => {
  const { address, stop } = await start();
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 }, reducedMotion: "reduce" });
  try {
    const errors: string[] = [];
    page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
    page.on("pageerror", ({ stack }) => errors.push(`exception: ${stack}`));
    await page.goto(address);
    await settled(page);
    await page.getByText("See why").click();
    const bar = page.locator(".study .bar").first();
    await bar.waitFor();
    // Without styles it is as high as any SVG: 150 px.
    expect((await bar.boundingBox())?.height).toBeLessThan(30);
    expect(errors).toEqual([]);
  } finally {
    await page.close();
    await stop();
  }
});
