/** Screenshots as pixels. */
import type { Page } from "playwright";

/** A screenshot of the whole page, at one pixel a CSS px. */
export class Pixels {
  readonly #width: number;
  readonly #data: Uint8Array;

  private constructor(width: number, data: Uint8Array) {
    this.#width = width;
    this.#data = data;
  }

  /** Takes a screenshot; another page of the same browser decodes it, so that this one stays as it is. */
  static async of(page: Page): Promise<Pixels> {
    const png = (await page.screenshot()).toString("base64");
    const decoder = await page.context().newPage();
    const { width, data } = await decoder.evaluate(decode, png);
    await decoder.close();
    return new Pixels(width, Buffer.from(data, "base64"));
  }

  /** Red, green and blue, 0 to 255. */
  at(x: number, y: number): [number, number, number] {
    const at = 4 * (Math.round(y) * this.#width + Math.round(x));
    return [this.#data[at] ?? 0, this.#data[at + 1] ?? 0, this.#data[at + 2] ?? 0];
  }

  /** The largest difference in any colour of any pixel left of `x`. */
  difference(other: Pixels, x: number): number {
    let largest = 0;
    for (let at = 0; at < this.#data.length; at++) {
      if (Math.floor(at / 4) % this.#width >= x) continue;
      largest = Math.max(largest, Math.abs((this.#data[at] ?? 0) - (other.#data[at] ?? 0)));
    }
    return largest;
  }

  /** Share of wood within a radius: limbs are coloured (green or brown), paper, ground and shadow are nearly grey. */
  wood(x: number, y: number, radius: number): number {
    let [wood, all] = [0, 0];
    for (let dy = -radius; dy <= radius; dy++) {
      for (let dx = -radius; dx <= radius; dx++) {
        if (Math.hypot(dx, dy) > radius) continue;
        const [red, green, blue] = this.at(x + dx, y + dy);
        all++;
        if (Math.max(red, green) - blue > 28) wood++;
      }
    }
    return wood / all;
  }
}

/** Runs in a page. */
async function decode(png: string): Promise<{ width: number; data: string }> {
  const image = new Image();
  image.src = `data:image/png;base64,${png}`;
  await image.decode();
  const { width, height } = image;
  const pen = new OffscreenCanvas(width, height).getContext("2d");
  pen?.drawImage(image, 0, 0);
  const bytes = pen?.getImageData(0, 0, width, height).data ?? new Uint8ClampedArray();
  let text = "";
  for (let at = 0; at < bytes.length; at += 0x8000) {
    text += String.fromCharCode(...bytes.subarray(at, at + 0x8000));
  }
  return { width, data: btoa(text) };
}
