// How much two pictures differ, and how much they may.

/**
 * Compared is what the renderer draws, without any text: fonts differ between machines. The software renderer draws the same
 * picture on one machine; another version of it may place an edge elsewhere in a pixel. So the pictures are made smaller,
 * three to four times, where an edge that moves by a tenth of a pixel changes a colour by at most 3 % of 255, that is 8, and
 * three such edges in one pixel by 24. A limb that is missing changes hundreds of pixels by 30 % and more, another
 * light or palette the mean. Of 255.
 */
export const limits = { most: 24, mean: 0.8 };

/**
 * A picture as numbers: red, green, blue and alpha of each pixel, 0 to 255.
 * @typedef {ArrayLike<number>} Colors
 */

/**
 * The largest difference in a colour of a pixel, and the mean of all.
 * @param {Colors} a
 * @param {Colors} b
 */
export function difference(a, b) {
  if (a.length !== b.length || a.length === 0) return { most: 255, mean: 255 };
  let [most, sum] = [0, 0];
  for (let at = 0; at < a.length; at++) {
    // Transparency is drawn on paper before.
    if (at % 4 === 3) continue;
    const one = Math.abs((a[at] ?? 0) - (b[at] ?? 0));
    most = Math.max(most, one);
    sum += one;
  }
  return { most, mean: sum / (0.75 * a.length) };
}

/** @param {{ most: number, mean: number }} difference */
export function isSame({ most, mean }) {
  return most <= limits.most && mean <= limits.mean;
}
