/**
 * Key states as pictures. `BOUGH_GOLDEN=update npx vitest run --project browser visual` writes them anew, to be looked at.
 *
 * Compared is what the renderer draws, without any text: fonts differ between machines. The software renderer draws the same
 * picture on one machine; another version of it may place an edge elsewhere in a pixel. So the pictures are made four
 * times smaller, where an edge that moves by a tenth of a pixel changes a colour by at most 3 %, and may then differ
 * by `most` in a colour of a pixel and by `mean` on average. A limb that is missing changes hundreds of pixels by 30 % and
 * more, another light or palette the mean. Motion is unwelcome in these visits: nothing in them depends on a clock.
 */
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import type { Browser, BrowserContextOptions, Page } from "playwright";
import { afterAll, beforeAll, expect, it } from "vitest";
import { launchChromium } from "./chromium.ts";
import { settled, visit } from "./visit.ts";

/** Of 255. */
const [most, mean] = [24, 0.8];
/** How many times smaller. */
const shrink = 4;

interface State {
  readonly query?: string;
  readonly options?: BrowserContextOptions;
  /** Done before the picture is taken. */
  act?(page: Page): Promise<void>;
  /** What the picture is of. */
  readonly of?: string;
}

const states: Readonly<Record<string, State>> = {
  "first-view": {},
  gallery: {
    query: "?preset=figure-17c",
    of: "dialog section:nth-of-type(4) .plates",
    async act(page) {
      await page.getByRole("button", { name: "All plates" }).click();
      await page.getByRole("dialog").waitFor();
      // The drawings alone, which are as large on every machine.
      await page.addStyleTag({
        content:
          "dialog section:not(:nth-of-type(4)), dialog h3, .dialog-head, .plate-name, .plate-title { display: none !important; }",
      });
      await page.waitForFunction(() =>
        [...document.querySelectorAll<HTMLImageElement>("dialog section:nth-of-type(4) img")].every(
          ({ complete, naturalWidth }) => complete && naturalWidth > 0,
        ),
      );
    },
  },
  fork: { query: "?preset=figure-18b" },
  model: { query: "?n=10&l=0.12&style=model" },
  moment: { query: "?preset=figure-18b&color=moment" },
  phone: {
    query: "?preset=figure-13c",
    options: { viewport: { width: 390, height: 844 } },
  },
  dark: { query: "?preset=figure-13d&theme=dark" },
  space: { query: "?preset=figure-17d&view=space" },
};

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

it.each(Object.entries(states))(
  "%s looks as it did",
  async (name, { query, options, act, of = ".stage" }) => {
    const viewport = { width: 1000, height: 640 };
    const { page } = await visit(browser, query, {
      bypassCSP: true,
      viewport,
      deviceScaleFactor: 1,
      ...options,
    });
    await page.addStyleTag({
      content:
        ".annotation, .look, .zoom, .legend, .notices { visibility: hidden } *:focus { outline: none !important }",
    });
    await act?.(page);
    await settled(page);
    const shot = (await page.locator(of).screenshot({ animations: "disabled" })).toString("base64");
    const golden = new URL(`golden/${name}.png`, import.meta.url);
    if (process.env.BOUGH_GOLDEN === "update") {
      const { png } = await page.evaluate(shrunk, { png: shot, size: null, by: shrink });
      writeFileSync(golden, Buffer.from(png, "base64"));
    }
    expect(existsSync(golden), `There is no golden picture of ${name} yet.`).toBe(true);
    const kept = readFileSync(golden).toString("base64");
    const before = await page.evaluate(shrunk, { png: kept, size: null, by: 1 });
    // To the same size: another font may make the timeline a pixel higher, and the picture as much lower.
    const present = await page.evaluate(shrunk, { png: shot, size: before.size, by: shrink });
    const differences = present.colors.map((color, k) => Math.abs(color - (before.colors[k] ?? 0)));
    expect(Math.max(...differences.filter((_, k) => k % 4 !== 3))).toBeLessThanOrEqual(most);
    expect(
      differences.reduce((sum, difference) => sum + difference, 0) / differences.length,
    ).toBeLessThanOrEqual(mean);
    await page.context().close();
  },
);

interface Shrinking {
  readonly png: string;
  /** Wanted width and height; null is `by` times smaller than it is. */
  readonly size: readonly [number, number] | null;
  readonly by: number;
}

/** Runs in the page: a picture made smaller, as PNG and as numbers. */
async function shrunk({ png, size, by }: Shrinking) {
  const image = new Image();
  image.src = `data:image/png;base64,${png}`;
  await image.decode();
  const [width, height] = size ?? [Math.round(image.width / by), Math.round(image.height / by)];
  const canvas = new OffscreenCanvas(width, height);
  const pen = canvas.getContext("2d");
  if (!pen) throw new Error("There is no pen.");
  pen.imageSmoothingQuality = "high";
  pen.drawImage(image, 0, 0, width, height);
  const bytes = new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer());
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  const colors = [...pen.getImageData(0, 0, width, height).data];
  return { size: [width, height] as [number, number], png: btoa(text), colors };
}
