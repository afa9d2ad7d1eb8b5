/** Everything that can be taken away, saved by a person and opened by something that is not ours; and opened here again. */
import { readFile } from "node:fs/promises";
import { parse } from "csv-parse/sync";
import { validateBytes } from "gltf-validator";
import type { Browser, Page } from "playwright";
import { type BufferGeometry, Mesh } from "three";
import { OBJLoader } from "three/addons/loaders/OBJLoader.js";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { grow, init } from "../../web/src/package/node.ts";
import { presets } from "../../web/src/params/declaration.ts";
import { launchChromium } from "./chromium.ts";
import { openDialog, said, type Tag } from "./sights.ts";
import { dropFile, placeOf, query, readTip, settled, visit } from "./visit.ts";

let browser: Browser;
beforeAll(async () => {
  browser = await launchChromium();
});
afterAll(() => browser.close());

/** Pictures are computed on the CPU here: a small one is enough. */
const small = { viewport: { width: 800, height: 500 } };

async function open(link = "", options = {}, tag: Tag = "en") {
  const visited = await visit(browser, link, options);
  const dialog = await openDialog(visited.page, tag, "Take it away");
  return { ...visited, dialog };
}

/** Presses a button of the dialog; the file that the browser saves. */
async function saved(page: Page, name: string, tag: Tag = "en"): Promise<{ name: string; bytes: Buffer }> {
  const [download] = await Promise.all([
    page.waitForEvent("download", { timeout: 30_000 }),
    page.getByRole("button", { name: said(tag, "Save {0}").replace("{0}", name) }).click(),
  ]);
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

/** Red, green, blue and opacity of a picture file, as Chromium draws it at a size; its own size unless said otherwise. */
async function drawn(page: Page, bytes: Buffer, type: string, size?: { width: number; height: number }) {
  const { width, height, text } = await page.evaluate(
    async ({ base64, type, size }) => {
      const image = new Image();
      image.src = `data:${type};base64,${base64}`;
      await image.decode();
      const canvas = document.createElement("canvas");
      canvas.width = size?.width ?? image.naturalWidth;
      canvas.height = size?.height ?? image.naturalHeight;
      const pen = canvas.getContext("2d") as CanvasRenderingContext2D;
      pen.drawImage(image, 0, 0, canvas.width, canvas.height);
      return dump(pen);
      function dump(pen: CanvasRenderingContext2D) {
        const { data, width, height } = pen.getImageData(0, 0, pen.canvas.width, pen.canvas.height);
        let text = "";
        for (let at = 0; at < data.length; at += 8192)
          text += String.fromCharCode(...data.subarray(at, at + 8192));
        return { width, height, text: btoa(text) };
      }
    },
    { base64: bytes.toString("base64"), type, size },
  );
  return { width, height, data: Buffer.from(text, "base64") };
}

/** The picture of the page, on nothing. */
async function view(page: Page) {
  const url = await page.evaluate(
    () => document.querySelector<HTMLCanvasElement>("canvas.picture")?.toDataURL() ?? "",
  );
  return drawn(page, Buffer.from(url.split(",")[1] ?? "", "base64"), "image/png");
}

describe("a picture", () => {
  it("on nothing is the view, pixel by pixel; on paper, larger, it has the scale bar", async () => {
    const { page, dialog, problems } = await open("?preset=figure-13c&color=moment", small);
    await dialog.getByRole("combobox", { name: "Scale" }).selectOption("1");
    await dialog.getByRole("checkbox", { name: "Transparent" }).check();
    await dialog.getByRole("checkbox", { name: /^With angle/ }).uncheck();
    const file = await saved(page, "PNG");
    expect(file.name).toBe("bough-figure-13c.png");
    const [seen, png] = [await view(page), await drawn(page, file.bytes, "image/png")];
    expect([png.width, png.height]).toEqual([seen.width, seen.height]);
    const off = seen.data.reduce(
      (sum, value, at) => sum + (Math.abs(value - (png.data[at] ?? 0)) > 8 ? 1 : 0),
      0,
    );
    // Printed by another context: edges may round otherwise.
    expect(off / seen.data.length).toBeLessThan(1e-4);
    expect(png.data[3]).toBe(0);
    await dialog.getByRole("combobox", { name: "Scale" }).selectOption("2");
    await dialog.getByRole("checkbox", { name: "Transparent" }).uncheck();
    await dialog.getByRole("checkbox", { name: /^With angle/ }).check();
    const large = await drawn(page, (await saved(page, "PNG")).bytes, "image/png");
    expect([large.width, large.height]).toEqual([2 * seen.width, 2 * seen.height]);
    expect(large.data[3]).toBe(255);
    // The scale bar is 20 px from the left and from below, on what is paper in the view.
    const row = 2 * (seen.height - 20);
    const dark = (x: number) => (large.data[4 * (row * large.width + x)] ?? 255) < 160;
    expect(Array.from({ length: 30 }, (_, x) => dark(50 + x)).some(Boolean)).toBe(true);
    expect(problems).toEqual([]);
    await page.context().close();
  });
});

describe("the centre lines", () => {
  it("lie on the limbs of the view, and reach as far", async () => {
    const { page, problems } = await open("?preset=figure-18b");
    const { bytes } = await saved(page, "SVG");
    const [, width = 0, height = 0] = /viewBox="0 0 (\S+) (\S+)"/.exec(bytes.toString())?.map(Number) ?? [];
    const pixels = (meters: number[]) => placeOf(page, meters);
    const [base, east] = [await pixels([0, 0, 0]), await pixels([1, 0, 0])];
    const scale = (east.x - base.x) / 1000;
    const size = { width: Math.round(width * scale), height: Math.round(height * scale) };
    const [svg, seen] = [await drawn(page, bytes, "image/svg+xml", size), await view(page)];
    const [, x0 = 0, y0 = 0] = /id="axis-0"[^>]*d="M(\S+) ([\d.]+)/.exec(bytes.toString())?.map(Number) ?? [];
    const canvas = await page.locator("canvas.picture").boundingBox();
    const [dx, dy] = [base.x - (canvas?.x ?? 0) - x0 * scale, base.y - (canvas?.y ?? 0) - y0 * scale];
    let [inked, onWood] = [0, 0];
    for (let y = 0; y < svg.height; y++) {
      for (let x = 0; x < svg.width; x++) {
        if ((svg.data[4 * (y * svg.width + x) + 3] ?? 0) < 200) continue;
        inked++;
        const at = 4 * (Math.round(y + dy) * seen.width + Math.round(x + dx));
        if ((seen.data[at + 3] ?? 0) > 200) onWood++;
      }
    }
    expect(inked).toBeGreaterThan(300);
    // The pen is about as wide as the thinnest limbs: its edge may stick out by a pixel.
    expect(onWood / inked).toBeGreaterThan(0.93);
    expect(problems).toEqual([]);
    await page.context().close();
  });
});

describe("the table", () => {
  it("is read by a parser of CSV to the numbers of the plant, bit by bit", async () => {
    const { page, problems } = await open("?preset=figure-18b&lang=de", small, "de");
    const { name, bytes } = await saved(page, "CSV", "de");
    expect(name).toBe("bough-figure-18b.csv");
    const rows: Record<string, number>[] = parse(bytes, {
      columns: true,
      cast: (cell, { header }) => (header ? cell : Number(cell)),
    });
    await init();
    const { segments } = grow(presets["figure-18b"]?.params ?? {});
    const column = (title: string) => rows.map((row) => row[title]);
    expect(column("length (m)")).toEqual([...segments.length]);
    expect(column("bending moment (N m)")).toEqual([...segments.moment]);
    expect(column("largest stress (Pa)")).toEqual([...segments.stress]);
    expect(column("birth (growth step)")).toEqual([...segments.birth]);
    expect(problems).toEqual([]);
    await page.context().close();
  });
});

describe("a body", () => {
  it.each([
    ["?preset=figure-21c", "figure-21c"],
    ["?preset=figure-17d&color=stress", "figure-17d"],
  ])("is a valid glTF, and the same as OBJ: %s", async (link, preset) => {
    const { page, problems } = await open(link);
    const { name, bytes } = await saved(page, "GLB");
    expect(name).toBe(`bough-${preset}.glb`);
    const { issues, info } = await validateBytes(new Uint8Array(bytes));
    expect(issues.messages.map(({ code, message }) => `${code}: ${message}`)).toEqual([]);
    expect([issues.numErrors, issues.numWarnings]).toEqual([0, 0]);
    const { bytes: text } = await saved(page, "OBJ");
    const loaded = new OBJLoader().parse(text.toString());
    const geometries: BufferGeometry[] = [];
    loaded.traverse((object) => object instanceof Mesh && geometries.push(object.geometry));
    const triangles = geometries.reduce((sum, one) => sum + one.getAttribute("position").count / 3, 0);
    expect(triangles).toBe(info.totalTriangleCount);
    // Metres: as high as the page says.
    geometries[0]?.computeBoundingBox();
    expect(geometries[0]?.boundingBox?.max.y).toBeGreaterThan(0.1);
    expect(geometries[0]?.boundingBox?.max.y).toBeLessThan(4);
    expect(problems).toEqual([]);
    await page.context().close();
  });
});

describe("growth", () => {
  it("is recorded from the first step to the last, as a film that the browser plays", async () => {
    const { page, dialog, problems } = await open("?n=12", { reducedMotion: "no-preference" });
    const kind = await dialog.getByRole("button", { name: /^Save (WEBM|MP4)$/ }).innerText();
    const { bytes } = await saved(page, kind);
    // The page itself may load no films: another one plays it.
    const cinema = await page.context().newPage();
    const { duration, width, changed } = await cinema.evaluate(
      async ({ base64, type }) => {
        const film = document.createElement("video");
        const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
        const address = URL.createObjectURL(new Blob([bytes], { type }));
        film.muted = true;
        film.src = address;
        await new Promise((resolve, reject) => {
          film.onloadeddata = resolve;
          film.onerror = () => reject(new Error(film.error?.message));
        });
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [80, 60];
        const pen = canvas.getContext("2d") as CanvasRenderingContext2D;
        const shot = () => {
          pen.drawImage(film, 0, 0, 80, 60);
          return [...pen.getImageData(0, 0, 80, 60).data];
        };
        const first = shot();
        film.currentTime = 1e9;
        await new Promise((resolve) => {
          film.onseeked = resolve;
        });
        const last = shot();
        const changed = first.filter((value, at) => Math.abs(value - (last[at] ?? 0)) > 24).length;
        return { duration: film.currentTime, width: film.videoWidth, changed };
      },
      { base64: bytes.toString("base64"), type: `video/${kind.toLowerCase()}` },
    );
    expect(duration).toBeGreaterThan(2);
    expect(width).toBeGreaterThan(300);
    expect(changed).toBeGreaterThan(20);
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("left in its midst, shows the full-grown plant again", async () => {
    const { page, dialog } = await open("?n=40", { reducedMotion: "no-preference" });
    const length = page.locator(".readout dd").first();
    await settled(page);
    const grown = await length.innerText();
    await dialog.getByRole("button", { name: /^Save (WEBM|MP4)$/ }).click();
    // The readings follow the film.
    await expect.poll(() => length.innerText()).not.toBe(grown);
    await page.keyboard.press("Escape");
    await settled(page);
    expect(await length.innerText()).toBe(grown);
    await page.context().close();
  });

  it("can be cancelled; and where the browser cannot record, the page says so", async () => {
    const { page, dialog } = await open("", { reducedMotion: "no-preference" });
    await dialog.getByRole("button", { name: /^Save (WEBM|MP4)$/ }).click();
    await dialog.getByRole("button", { name: "Cancel" }).click();
    await dialog.getByText("Recording was cancelled.").waitFor();
    await page.keyboard.press("Escape");
    await page.evaluate(() => {
      Reflect.deleteProperty(window, "MediaRecorder");
    });
    await page.getByRole("button", { name: "Take it away" }).click();
    await dialog.getByText("This browser cannot record what is drawn").waitFor();
    expect(await dialog.getByRole("button", { name: "Save WEBM" }).isDisabled()).toBe(true);
    await page.context().close();
  });
});

describe("a file", () => {
  it("that was saved opens to the same plant, dropped or chosen; Undo brings back the other", async () => {
    const { page, dialog, problems } = await open("?v=1&preset=figure-13b&g=3&color=age");
    const { bytes, name } = await saved(page, "JSON");
    expect(name).toBe("bough-figure-13b.json");
    const tip = await readTip(page);
    const link = page.url();
    await page.keyboard.press("Escape");
    await page.getByRole("button", { name: /^Figure 8 d/ }).click();
    await settled(page);
    await dropFile(page, name, "application/json", bytes.toString());
    await page.getByText(`${name} is open`).waitFor();
    await settled(page);
    expect([page.url(), await readTip(page)]).toEqual([link, tip]);
    await page.getByRole("button", { name: "Undo" }).click();
    await page.waitForFunction(() => location.search.includes("figure-8d"));
    await page.getByRole("button", { name: "Take it away" }).click();
    await dialog.getByLabel(/^Parameters that were saved/).setInputFiles({
      name: "mine.json",
      mimeType: "application/json",
      buffer: Buffer.from('{"axis":{"segments":20},"loads":{"gravity":0}}'),
    });
    await page.getByText("mine.json is open").waitFor();
    await settled(page);
    expect([query(page).get("n"), query(page).get("g"), query(page).get("preset")]).toEqual([
      "20",
      "0",
      null,
    ]);
    expect(problems).toEqual([]);
    await page.context().close();
  });

  it("that is no plant is refused in a sentence, and nothing is lost", async () => {
    const { page, problems } = await visit(browser, "?preset=figure-13c&g=3", small);
    await page.locator("details.measure").waitFor();
    const [link, tip] = [page.url(), await readTip(page)];
    for (const [name, type, content, sentence] of [
      ["notes.txt", "text/plain", "hello", "it holds no JSON"],
      ["cells.json", "application/json", "[1,2,3]", "holds JSON, but no plant"],
      ["huge.json", "application/json", 500_000_000, "has 500 MB"],
      [
        "next.json",
        "application/json",
        '{"format":"bough-plant","edition":9}',
        "was written by a newer Bough",
      ],
      ["bad.json", "application/json", '{"axis":{"segments":-1}}', "Segments must be a whole number from 1"],
      ["strange.json", "application/json", '{"axis":{"length":2}}', "axis.length"],
      // Pictures are taken as photos, and their problem is said there.
      ["picture.svg", "image/svg+xml", "<svg/>", "is not a photo that can be shown here"],
      ["huge.png", "image/png", 500_000_000, "has 500 MB"],
    ] as const) {
      await dropFile(page, name, type, content);
      const notice = page.locator(".notice.problem, #photo-problem").filter({ hasText: name });
      await notice.waitFor();
      expect(await notice.innerText()).toContain(sentence);
      const box = await notice.boundingBox();
      expect(box?.y, `${name}: where it is seen`).toBeLessThan(small.viewport.height);
      await settled(page);
      expect([page.url(), await readTip(page)]).toEqual([link, tip]);
    }
    expect(problems).toEqual([]);
    await page.context().close();
  });
});
