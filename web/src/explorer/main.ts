/** Where the page begins. */
import { startEngine } from "../engine/engine.ts";
import { begin } from "./begin.ts";
import { trustOwnScripts } from "./trust.ts";

trustOwnScripts();
void begin(startEngine);
