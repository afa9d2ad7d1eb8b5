/** A photo that is laid under the tracing of a branch, in real Chromium. */
import type { Browser, Page } from "playwright";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { grow, init } from "../../web/src/package/node.ts";
import { launchChromium } from "./chromium.ts";
import { pointOf } from "./points.ts";
import { dropFile, placeOf, query, settled, slider, visit } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  await init();
  browser = await launchChromium();
});
afterAll(() => browser.close());

describe("a photo", () => {
  /** The picture as a PNG, at one pixel a CSS pixel. */
  async function pictureOf(page: Page): Promise<number[]> {
    return page.evaluate(async () => {
      const canvas = document.querySelector<HTMLCanvasElement>("canvas.picture");
      const blob = await new Promise<Blob | null>((resolve) => canvas?.toBlob(resolve, "image/png"));
      return [...new Uint8Array((await blob?.arrayBuffer()) ?? new ArrayBuffer())];
    });
  }

  /** From pixels of the photo to the page, as the photo lies now. */
  async function lay(page: Page): Promise<(pixel: { u: number; v: number }) => { x: number; y: number }> {
    const matrix = (await page.locator(".overlay image").getAttribute("transform")) ?? "";
    const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0] = matrix.slice(7, -1).split(" ").map(Number);
    const stage = await page.locator(".overlay").boundingBox();
    return ({ u, v }) => ({ x: (stage?.x ?? 0) + a * u + c * v + e, y: (stage?.y ?? 0) + b * u + d * v + f });
  }

  // Two visits and two dozen clicks: where pictures are computed on a busy CPU, more than a minute.
  const unhurried = { timeout: 180_000 };
  it(
    "of a plant with a known modulus is traced with 2 px noise, and the fit finds the modulus",
    unhurried,
    async () => {
      // Photographed: a plant of 1.2 GPa.
      const truth = 1.2e9;
      const camera = await visit(browser, `?ym=${truth}`);
      const bytes = await pictureOf(camera.page);
      const plant = grow({ material: { youngsModulus: truth } });
      const lens = await camera.page.locator("canvas.picture").boundingBox();
      const pixels = await Promise.all(
        Array.from({ length: 41 }, async (_, point) => {
          const { x, y } = await placeOf(camera.page, pointOf(plant, point));
          return { u: x - (lens?.x ?? 0), v: y - (lens?.y ?? 0) };
        }),
      );
      await camera.page.context().close();
      const [base, tip] = [pixels[0], pixels[40]];
      if (!base || !tip) throw new Error("The plant was not seen.");
      // Known: everything but the modulus.
      const { page, problems } = await visit(browser, "?ym=600000000");
      // Its own plant hangs lower: from farther away there is room for both below the controls.
      for (let press = 0; press < 2; press++) await page.getByRole("button", { name: "Zoom out" }).click();
      await settled(page);
      await dropFile(page, "branch.png", "image/png", bytes);
      await page.locator(".overlay image").waitFor();
      const click = ({ x, y }: { x: number; y: number }) => page.mouse.click(x, y);
      // A photo that was dropped asks for its base first.
      await click((await lay(page))(base));
      await page.getByRole("radio", { name: "Measures a known length on the photo" }).check();
      const unscaled = await lay(page);
      await click(unscaled(base));
      await click(unscaled(tip));
      const [x, y] = pointOf(plant, 40);
      await page.getByRole("textbox", { name: "Known length (m)" }).fill(Math.hypot(x, y).toPrecision(8));
      await page.getByRole("button", { name: "Set the scale" }).click();
      let state = 11;
      const random = () => {
        state = (state * 16807) % 2147483647;
        return state / 2147483647;
      };
      const noise = () => 2 * Math.sqrt(-2 * Math.log(random())) * Math.cos(2 * Math.PI * random());
      const place = await lay(page);
      for (let point = 2; point <= 40; point += 2) {
        const pixel = pixels[point] ?? base;
        await click(place({ u: pixel.u + noise(), v: pixel.v + noise() }));
      }
      await page.getByText("20 points").waitFor();
      await page.getByRole("button", { name: "Fit to the line" }).click();
      const found = page.locator("table.fitted tr[data-path='material.youngsModulus']");
      await found.waitFor();
      const [low, high] = [await found.getAttribute("data-low"), await found.getAttribute("data-high")].map(
        Number,
      );
      expect(low).toBeLessThan(truth);
      expect(high).toBeGreaterThan(truth);
      expect((high ?? 0) - (low ?? 0)).toBeLessThan(0.1 * truth);
      await settled(page);
      // The plant has the value now, in one step that can be undone.
      expect(Number(query(page).get("ym"))).toBeGreaterThan(low ?? 0);
      expect(await page.getByText(/Within [\d.]+ mm \([12]\.\d px\) of the traced line/).count()).toBe(1);
      await page.getByRole("button", { name: "Undo" }).click();
      await settled(page);
      expect(query(page).get("ym")).toBe("600000000");
      expect(problems).toEqual([]);
      await page.context().close();
    },
  );

  it("is turned as its EXIF data says", async () => {
    const { page } = await visit(browser);
    const bytes = await page.evaluate(async () => {
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [60, 30];
      canvas.getContext("2d")?.fillRect(0, 0, 60, 30);
      const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, "image/jpeg"));
      return [...new Uint8Array((await blob?.arrayBuffer()) ?? new ArrayBuffer())];
    });
    // An EXIF segment with orientation 6: turned by a quarter.
    const text = (letters: string) => [...letters].map((letter) => letter.charCodeAt(0));
    const tiff = [...text("MM"), 0, 42, 0, 0, 0, 8, 0, 1, 1, 18, 0, 3, 0, 0, 0, 1, 0, 6, 0, 0, 0, 0, 0, 0];
    const exif = [...text("Exif"), 0, 0, ...tiff];
    const segment = [0xff, 0xe1, 0, exif.length + 2, ...exif];
    await dropFile(page, "turned.jpg", "image/jpeg", [...bytes.slice(0, 2), ...segment, ...bytes.slice(2)]);
    const image = page.locator(".overlay image");
    await image.waitFor();
    expect([await image.getAttribute("width"), await image.getAttribute("height")]).toEqual(["30", "60"]);
    await page.getByRole("button", { name: "Remove the photo" }).click();
    expect(await image.count()).toBe(0);
    await page.context().close();
  });

  it("can be pasted, moved and turned", async () => {
    const { page } = await visit(browser);
    const bytes = await pictureOf(page);
    await page.evaluate((bytes) => {
      const data = new DataTransfer();
      data.items.add(new File([new Uint8Array(bytes)], "pasted.png", { type: "image/png" }));
      document.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true }));
    }, bytes);
    await page.locator(".overlay image").waitFor();
    const before = (await lay(page))({ u: 100, v: 100 });
    await page.getByRole("radio", { name: "Moves the photo" }).check();
    await page.mouse.move(300, 300);
    await page.mouse.down();
    await page.mouse.move(340, 280, { steps: 3 });
    await page.mouse.up();
    const after = (await lay(page))({ u: 100, v: 100 });
    expect(after.x - before.x).toBeCloseTo(40, 0);
    expect(after.y - before.y).toBeCloseTo(-20, 0);
    await slider(page, "Turn").fill("30");
    const turned = await lay(page);
    const [origin, right] = [turned({ u: 0, v: 0 }), turned({ u: 100, v: 0 })];
    expect((Math.atan2(origin.y - right.y, right.x - origin.x) * 180) / Math.PI).toBeCloseTo(30, 1);
    await page.context().close();
  });

  it("that is none is told in a sentence, and nothing is lost", async () => {
    const { page } = await visit(browser);
    await dropFile(page, "broken.png", "image/png", [1, 2, 3]);
    await page.getByRole("alert").filter({ hasText: "broken.png cannot be read as a picture" }).waitFor();
    await dropFile(page, "drawing.svg", "image/svg+xml", [60, 115, 118, 103]);
    await page
      .getByRole("alert")
      .filter({ hasText: "drawing.svg is not a photo that can be shown" })
      .waitFor();
    await dropFile(page, "huge.png", "image/png", 65_000_000);
    await page.getByRole("alert").filter({ hasText: "huge.png has 65 MB" }).waitFor();
    expect(await page.locator(".overlay image").count()).toBe(0);
    await page.context().close();
  });
});
