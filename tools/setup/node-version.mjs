// Is this Node new enough?

import { Obstacle } from "../obstacle.mjs";
import { nodeWillDo } from "./versions.mjs";

export function requireNode(version = process.version) {
  if (nodeWillDo(version)) return;
  throw new Obstacle(`Bough needs Node 20.19 or later, or 22.12 or later; this is Node ${version}.`, {
    remedy: "nvm install 22   (or an installer from https://nodejs.org)",
  });
}
