import { grow, init } from "bough";
import { outlineOf } from "./outline.js";

await init();
const { polylines, report } = grow({ axis: { elevation: 75 }, growth: { thickening: "pipes" } });
document.querySelector("svg").innerHTML = `<path d="${outlineOf(polylines, 480, 360)}" fill="#80644b" />`;
document.querySelector("#report").textContent = `${report.status} after ${report.steps} growth steps`;
