/** The page for hosts that allow only frames: one plant that fills it, and answers the page around. */
import { type BoughPlantElement, define } from "../element/element.ts";
import { Conversation } from "./conversation.ts";

const query = new URLSearchParams(location.search);
const plant = document.createElement("bough-plant") as BoughPlantElement;
plant.link = location.search;
plant.controls = query.get("ui") ?? "compact";
const preset = query.get("preset");
if (preset && /^[\w-]+$/.test(preset)) plant.poster = `presets/${preset}.webp`;
define();
document.body.append(plant);

if (parent !== window) {
  const conversation = new Conversation(plant);
  addEventListener("message", ({ data, source, origin }) => {
    if (source !== parent) return;
    // Pages from files and sandboxes have no origin that could be named; the answer still reaches nobody but them.
    const targetOrigin = origin === "null" ? "*" : origin;
    conversation.hear(data, (message) => parent.postMessage(message, targetOrigin), performance.now());
  });
  const announce = (message: object) => parent.postMessage(message, hostOrigin());
  announce({ bough: 1, type: "ready" });
  let told = 0;
  const tellHeight = () => {
    const height = plant.naturalHeight;
    if (height === told) return;
    told = height;
    announce({ bough: 1, type: "resize", height });
    announce({ subject: "lti.frameResize", height });
  };
  new ResizeObserver(tellHeight).observe(plant);
  plant.addEventListener("bough-ready", tellHeight);
}

/** Origin of the page around, as far as the browser tells it; what is said unasked holds nothing that is secret. */
function hostOrigin(): string {
  const [nearest] = location.ancestorOrigins ?? [];
  const origin = nearest ?? (document.referrer && new URL(document.referrer).origin);
  return origin && origin !== "null" ? origin : "*";
}
