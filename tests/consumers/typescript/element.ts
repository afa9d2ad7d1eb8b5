import { type BoughPlantElement, define, type ErrorDetail, type PlantDetail } from "bough/element";

define("my-plant");

const plant: BoughPlantElement = document.createElement("bough-plant");
plant.preset = "figure-13a";
plant.params = { loads: { gravity: 3 } };
plant.step = null;
// @ts-expect-error there is no such parameter
plant.params = { loads: { weight: 3 } };

plant.addEventListener("bough-change", ({ detail }) => detail satisfies PlantDetail);
plant.addEventListener("bough-error", ({ detail }) => detail satisfies ErrorDetail);
const status: "converged" | "maxIterations" | "nonFinite" | "budget" | undefined = plant.plant?.report.status;
const picture: Promise<Blob> = plant.toBlob();
// @ts-expect-error what is shown cannot be set
plant.plant = null;

export { picture, status };
