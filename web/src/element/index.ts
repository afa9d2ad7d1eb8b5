/** `bough/element`: the widget for pages that have a bundler. */
export type { Issue, IssueCode } from "../params/issue.ts";
export type { Params, ParamsInput } from "../params/params.ts";
export type { Plant } from "../plant/plant.ts";
export { BoughPlantElement, define, type ErrorDetail, type PlantDetail } from "./element.ts";
