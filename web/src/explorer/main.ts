/** Where the page begins. */
import { startEngine } from "../engine/engine.ts";
import { Explorer } from "./explorer.ts";
import { trustOwnScripts } from "./trust.ts";

trustOwnScripts();
const root = document.querySelector<HTMLElement>("#page");
if (root) void new Explorer(root).start(startEngine);
