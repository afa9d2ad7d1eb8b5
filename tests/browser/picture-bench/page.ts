/** Runs in the browser: a stage without the explorer, for tests of what the picture itself can do. */
import { threadEngine } from "../../../web/src/engine/engine.ts";
import type { ParamsInput } from "../../../web/src/params/params.ts";
import type { Plant } from "../../../web/src/plant/plant.ts";
import { type Drawn, type Showing, Stage } from "../../../web/src/scene/stage.ts";
import "../../../web/src/style/page.css";

export interface Bench {
  readonly stage: Stage;
  /** What was grown last. */
  plant: Plant | null;
  /** What the last picture told. */
  last: Drawn | null;
  /** Grows a plant and shows it; resolves when it is drawn and at rest. */
  show(params: ParamsInput, how?: Partial<Showing>): Promise<void>;
  /** Resolves when nothing moves any more. */
  rest(): Promise<void>;
}

declare global {
  interface Window {
    bench: Bench;
  }
}

const host = document.querySelector<HTMLElement>(".stage");
if (!host) throw new Error("The page has no stage.");
const stage = new Stage(host);
const engine = threadEngine();

window.bench = {
  stage,
  plant: null,
  last: null,
  async show(params, how = {}) {
    const plant = await engine.plant(params);
    this.plant = plant;
    stage.show(plant, {
      grown: plant,
      view: "plane",
      color: "bark",
      style: "limb",
      tone: "light",
      settled: true,
      passage: 0,
      ...how,
    });
    await this.rest();
  },
  async rest() {
    do await new Promise((resolve) => requestAnimationFrame(resolve));
    while (stage.moving);
  },
};
document.addEventListener("bough-drawn", (event) => {
  window.bench.last = (event as CustomEvent<Drawn>).detail;
});
