/** embed.html in a frame of somebody else's page: the conversation with the page around. */
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { launchChromium } from "../browser/chromium.ts";
import { type Host, open, openHost } from "./host.ts";

let browser: Browser;
let host: Host;
let frames: Host;

beforeAll(async () => {
  browser = await launchChromium();
  [host, frames] = [await openHost(), await openHost()];
});
afterAll(async () => {
  await browser.close();
  host.close();
  frames.close();
});

/** What a frame said to the page around. */
interface Said {
  readonly origin: string;
  readonly data: Record<string, unknown>;
}

declare global {
  interface Window {
    said: Said[];
    /** Sends a message to the frame, and returns the answer to it. */
    ask(message: Record<string, unknown>): Promise<Record<string, unknown>>;
  }
}

/** A page that embeds a plant, and listens. */
async function embed(query: string, height = 320): Promise<{ page: Page; problems: string[] }> {
  const { page, problems } = await open(
    browser,
    host.page(`<html lang="en"><title>A course</title><script>
      self.said = [];
      addEventListener("message", ({ data, origin }) => said.push({ data, origin }));
      self.ask = (message) => new Promise((resolve) => {
        const id = Math.random();
        addEventListener("message", function hear({ data }) {
          if (data.id !== id) return;
          removeEventListener("message", hear);
          resolve(data);
        });
        frames[0].postMessage({ bough: 1, id, ...message }, "*");
      });
    </script>
    <iframe src="${frames.address}embed.html?${query}" width="480" height="${height}" title="A plant" style="border:0"></iframe>
    </html>`),
  );
  await said(page, "ready");
  return { page, problems };
}

/** Waits for a message of a type. */
async function said(page: Page, type: string): Promise<Said> {
  const handle = await page.waitForFunction(
    (type) => window.said.find(({ data }) => data.type === type),
    type,
  );
  return (await handle.jsonValue()) as Said;
}

function ask(page: Page, message: Record<string, unknown>): Promise<Record<string, unknown>> {
  return page.evaluate((message) => window.ask(message), message);
}

describe("the page around an embedded plant", () => {
  it("hears that it is ready, from the frame's own origin", async () => {
    const { page, problems } = await embed("v=1&preset=figure-13a");
    expect(await said(page, "ready")).toEqual({
      data: { bough: 1, type: "ready" },
      origin: new URL(frames.address).origin,
    });
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("asks for the state, and sets it", async () => {
    const { page } = await embed("v=1&preset=figure-13a&ui=none");
    const set = await ask(page, { type: "set", params: { loads: { gravity: 3 } }, step: 5 });
    expect(set).toMatchObject({
      bough: 1,
      type: "state",
      step: 5,
      link: "?v=1&preset=figure-13a&g=3&step=5",
    });
    expect(set.params).toMatchObject({ loads: { gravity: 3 }, axis: { segments: 40 } });
    expect(set.report).toMatchObject({ status: "converged", steps: 5 });
    expect(await ask(page, { type: "get" })).toMatchObject({ type: "state", link: set.link });
    const again = await ask(page, { type: "set", link: "?v=1&preset=figure-8a&color=moment", step: null });
    expect(again).toMatchObject({ type: "state", link: "?v=1&preset=figure-8a&color=moment" });
    await page.context().close();
  });

  it("hears what is wrong with a change, as the core words it; the last good plant stays", async () => {
    const { page } = await embed("v=1&preset=figure-13a&ui=none");
    const before = await ask(page, { type: "set", step: 4 });
    const error = await ask(page, { type: "set", params: { axis: { segments: 0 } } });
    expect(error).toMatchObject({
      bough: 1,
      type: "error",
      issues: [{ code: "outOfRange", path: "axis.segments" }],
    });
    expect(error.message).toContain("axis.segments must be a whole number");
    expect(await ask(page, { type: "get" })).toMatchObject({ type: "state", link: before.link });
    await page.context().close();
  });

  it("answers in the order in which it was asked", async () => {
    const { page } = await embed("v=1&ui=none");
    const answers = await page.evaluate(() =>
      Promise.all([2, 0, 5].map((segments) => window.ask({ type: "set", params: { axis: { segments } } }))),
    );
    expect(answers.map(({ type }) => type)).toEqual(["state", "error", "state"]);
    expect(answers[2]).toMatchObject({ report: { steps: 5 } });
    await page.context().close();
  });

  it("follows what the reader does, if it asks for that", async () => {
    const { page } = await embed("v=1&ui=compact", 420);
    await ask(page, { type: "get", follow: true });
    const frame = page.frameLocator("iframe");
    await frame.getByRole("slider", { name: "Gravity" }).focus();
    await page.keyboard.press("Home");
    await page.waitForFunction(() => window.said.some(({ data }) => data.link === "?v=1&g=0"));
    await page.context().close();
  });

  it("is told the height that is needed, as an LMS expects it", async () => {
    const { page } = await embed("v=1&ui=compact");
    await page.waitForFunction(() => window.said.filter(({ data }) => data.type === "resize").length > 1);
    const [resize] = await page.evaluate(() =>
      window.said.filter(({ data }) => data.type === "resize").reverse(),
    );
    const height = Number(resize?.data.height);
    // Two thirds of the width for the picture, and the controls below.
    expect(height).toBeGreaterThan(320);
    expect(height).toBeLessThan(520);
    const lti = await page.evaluate(() => window.said.filter(({ data }) => data.subject).reverse());
    expect(lti[0]?.data).toEqual({ subject: "lti.frameResize", height });
    await page.context().close();
  });
});

describe("what is not meant for it", () => {
  it("is met with silence: other windows, other messages", async () => {
    const { page } = await embed("v=1&ui=none");
    const heard = await page.evaluate(async () => {
      const before = window.said.length;
      const stranger = document.createElement("iframe");
      stranger.srcdoc = `<script>
        addEventListener("message", ({ data }) => parent.postMessage({ stranger: data }, "*"));
        parent.frames[0].postMessage({ bough: 1, type: "get", id: "stranger" }, "*");
      </script>`;
      document.body.append(stranger);
      await new Promise((resolve) => stranger.addEventListener("load", resolve));
      for (const message of [1, "get", { type: "get" }, { subject: "x" }])
        window[0]?.postMessage(message, "*");
      await window.ask({ type: "get" });
      // Of its own accord it tells its height, whenever that changes.
      const answers = window.said.slice(before).filter(({ data }) => data.type !== "resize" && !data.subject);
      return answers.map(({ data }) => data.type ?? Object.keys(data));
    });
    expect(heard).toEqual(["state"]);
    await page.context().close();
  });

  it("is held off when it is a flood, and 10,000 messages at random break nothing", async () => {
    const { page, problems } = await embed("v=1&ui=none");
    const told = await page.evaluate(async () => {
      const pieces = [
        1,
        2,
        "get",
        "set",
        "",
        null,
        undefined,
        {},
        [],
        Number.NaN,
        -1,
        true,
        "params",
        "figure-8a",
      ];
      let seed = 7;
      const any = () => {
        seed = (seed * 16807) % 2147483647;
        return pieces[seed % pieces.length];
      };
      const before = window.said.length;
      for (let k = 0; k < 10_000; k++) {
        const message = {
          bough: k % 3 === 0 ? 1 : any(),
          id: any(),
          type: any(),
          step: any(),
          [String(any())]: any(),
        };
        window[0]?.postMessage(message, "*");
      }
      // After a pause it listens again.
      let answer: Record<string, unknown> | undefined;
      while (!answer) {
        const late = new Promise<undefined>((resolve) => setTimeout(resolve, 500, undefined));
        answer = await Promise.race([window.ask({ type: "get" }), late]);
      }
      return { answers: window.said.length - before, last: answer };
    });
    expect(told.last).toMatchObject({ type: "state" });
    expect(told.answers).toBeLessThan(500);
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("a frame that is opened by itself says nothing", async () => {
    const { page, problems } = await open(browser, `${frames.address}embed.html?v=1&preset=figure-13a`);
    await page.locator("bough-plant").evaluate(async (plant: HTMLElementTagNameMap["bough-plant"]) => {
      await plant.toBlob();
    });
    expect(problems).toEqual([]);
    await page.context().close();
  });
});
