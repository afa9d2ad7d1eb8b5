// The parts of the bench, in the order of its table.

import { costRows } from "./rows/cost.mjs";
import { growthRows, iterationRows, spaceRows, staticRows, treeRows } from "./rows/kernels.mjs";
import { meshRows } from "./rows/mesh.mjs";
import { pageRows, sizeRows } from "./rows/page.mjs";
import { peerRows } from "./rows/peers.mjs";
import { relaxationRows } from "./rows/relaxation.mjs";

/** @type {readonly { name: string, rows: (bench: import("./bench.mjs").Bench) => Promise<void> }[]} */
export const parts = [
  { name: "iteration", rows: iterationRows },
  { name: "space", rows: spaceRows },
  { name: "static", rows: staticRows },
  { name: "growth", rows: growthRows },
  { name: "cost", rows: costRows },
  { name: "trees", rows: treeRows },
  { name: "euler", rows: relaxationRows },
  { name: "peers", rows: peerRows },
  { name: "mesh", rows: meshRows },
  { name: "sizes", rows: sizeRows },
  { name: "page", rows: pageRows },
];
