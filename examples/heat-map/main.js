import { sweep } from "bough/worker";

const canvas = document.querySelector("canvas");
const report = document.querySelector("#report");
const { width, height } = canvas;

const gravity = Array.from({ length: width }, (_, i) => (20 * i) / (width - 1));
// The first row of the picture is the stiffest wood.
const youngsModulus = Array.from({ length: height }, (_, i) => 10 ** (10 - (2 * i) / (height - 1)));
const { rows, columns, problems } = await sweep(
  { axis: { elevation: 45 } },
  { "material.youngsModulus": youngsModulus, "loads.gravity": gravity },
  { onProgress: (share) => (report.textContent = `${Math.round(100 * share)} %`) },
);

/** Cividis, by Nunez, Anderton & Renslow (2018): even in lightness, the same for colour-blind eyes. */
const colors = ["#002051", "#3c4d6e", "#7f7c75", "#bbaf71", "#fdea45"].map((css) =>
  [1, 3, 5].map((at) => Number.parseInt(css.slice(at, at + 2), 16)),
);

const pen = canvas.getContext("2d");
const picture = pen.createImageData(width, height);
for (let row = 0; row < rows; row++) {
  const place = (0.5 + (0.5 * columns.tipY[row]) / columns.length[row]) * (colors.length - 1);
  const below = Math.min(Math.floor(place), colors.length - 2);
  for (let k = 0; k < 3; k++) {
    picture.data[4 * row + k] =
      colors[below][k] + (place - below) * (colors[below + 1][k] - colors[below][k]);
  }
  picture.data[4 * row + 3] = 255;
}
pen.putImageData(picture, 0, 0);
report.textContent = `${rows} plants, ${problems.length} problems`;
