export { presets } from "bough";
