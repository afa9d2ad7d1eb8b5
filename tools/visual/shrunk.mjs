// Pictures made smaller, in a page of the browser that took them.

/**
 * @typedef {object} Shrinking
 * @property {string} picture in base64, in any format that the browser knows
 * @property {readonly [number, number] | null} size wanted width and height; null is `by` times smaller than it is
 * @property {number} by
 * @property {string} [paper] what it lies on, if it is transparent
 * @property {"image/png" | "image/webp"} [type] what it becomes: PNG as it is, WebP with some loss
 */

/**
 * Runs in a page. The colours are those of the encoded picture: what is lost in that is lost in both that are compared.
 * @param {Shrinking} what
 */
export async function shrunk({ picture, size, by, paper, type = "image/png" }) {
  const image = new Image();
  image.src = `data:;base64,${picture}`;
  await image.decode();
  const [width, height] = size ?? [Math.round(image.width / by), Math.round(image.height / by)];
  const canvas = new OffscreenCanvas(width, height);
  const pen = canvas.getContext("2d");
  if (!pen) throw new Error("There is no pen.");
  if (paper !== undefined) {
    pen.fillStyle = paper;
    pen.fillRect(0, 0, width, height);
  }
  pen.imageSmoothingQuality = "high";
  pen.drawImage(image, 0, 0, width, height);
  const encoded = await canvas.convertToBlob({ type, quality: 0.9 });
  pen.drawImage(await createImageBitmap(encoded), 0, 0);
  let text = "";
  for (const byte of new Uint8Array(await encoded.arrayBuffer())) text += String.fromCharCode(byte);
  const colors = [...pen.getImageData(0, 0, width, height).data];
  return { size: /** @type {[number, number]} */ ([width, height]), picture: btoa(text), colors };
}
