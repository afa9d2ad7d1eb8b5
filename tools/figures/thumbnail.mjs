// A plant so small that it can stand on a button, on nothing, so that it fits light and dark.

const size = { width: 192, height: 128 };
/** Bytes. */
const most = 4000;

/**
 * @param {import("playwright").Browser} browser
 * @param {Buffer} plant PNG without a background
 * @returns {Promise<Buffer>} WebP
 */
export async function makeThumbnail(browser, plant) {
  const page = await browser.newPage();
  const encoded = await page.evaluate(shrink, { png: plant.toString("base64"), size, most });
  await page.close();
  return Buffer.from(encoded, "base64");
}

/**
 * Runs in a page: crops the picture closely around what stands in it, and scales it.
 * @param {{ png: string, size: { width: number, height: number }, most: number }} what
 */
async function shrink({ png, size, most }) {
  /** Alpha of what certainly lies on the ground, and of what certainly does not. */
  const [ground, wood] = [180, 220];
  const image = new Image();
  image.src = `data:image/png;base64,${png}`;
  await image.decode();
  const { width, height } = image;
  const whole = new OffscreenCanvas(width, height).getContext("2d");
  if (!whole) throw new Error("The browser draws no pictures.");
  whole.drawImage(image, 0, 0);
  const pixels = whole.getImageData(0, 0, width, height);
  const { data } = pixels;
  const box = { left: width, top: height, right: 0, bottom: 0 };
  for (let at = 0; at < width * height; at++) {
    // The soil and the shadow on it are not opaque; what is left out of the picture spares a button from their grey.
    const alpha = Math.min(1, Math.max(0, ((data[4 * at + 3] ?? 0) - ground) / (wood - ground)));
    data[4 * at + 3] = 255 * alpha;
    if (alpha < 0.9) continue;
    box.left = Math.min(box.left, at % width);
    box.right = Math.max(box.right, at % width);
    box.top = Math.min(box.top, Math.floor(at / width));
    box.bottom = Math.max(box.bottom, Math.floor(at / width));
  }
  whole.putImageData(pixels, 0, 0);
  const margin = 1.12;
  const scale = Math.min(
    size.width / (margin * (box.right - box.left)),
    size.height / (margin * (box.bottom - box.top)),
    0.8,
  );
  const canvas = new OffscreenCanvas(size.width, size.height);
  const pen = canvas.getContext("2d");
  if (pen) {
    pen.imageSmoothingQuality = "high";
    const middle = { x: (box.left + box.right) / 2, y: (box.top + box.bottom) / 2 };
    pen.translate(size.width / 2 - scale * middle.x, size.height / 2 - scale * middle.y);
    pen.scale(scale, scale);
    pen.drawImage(whole.canvas, 0, 0);
  }
  for (let quality = 0.8; ; quality -= 0.1) {
    const blob = await canvas.convertToBlob({ type: "image/webp", quality });
    if (blob.size > most && quality > 0.2) continue;
    return btoa(String.fromCharCode(...new Uint8Array(await blob.arrayBuffer())));
  }
}
