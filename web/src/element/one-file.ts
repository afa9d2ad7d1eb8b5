/** `bough-widget.js`: defines the element, under the tag that the script's address may name: `bough-widget.js?tag=my-plant`. */
import { define } from "./element.ts";

const { currentScript } = document;
const address = currentScript instanceof HTMLScriptElement ? currentScript.src : "";
define(new URLSearchParams(address.split("?")[1]).get("tag") ?? undefined);
