// Prints how far a branch reaches out, for some gravities and ways of thickening, as CSV.

import { sweep } from "bough/worker";

const { rows, axes, columns, status } = await sweep(
  { axis: { segments: 40, elevation: 60 } },
  { "growth.thickening": ["none", "pipes"], "loads.gravity": [0, 1.62, 3.72, 9.81] },
);
const wanted = ["reach", "height", "baseMoment"];
console.log(["thickening", "gravity", "status", ...wanted].join(","));
for (let row = 0; row < rows; row++) {
  const measures = wanted.map((name) => columns[name][row].toPrecision(6));
  console.log(
    [axes["growth.thickening"][row], axes["loads.gravity"][row], status[row], ...measures].join(","),
  );
}
