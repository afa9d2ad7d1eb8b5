/** The plant in a notebook: what Python sets is shown, and what is shown comes back to Python. For anywidget. */
import { type BoughPlantElement, define } from "../element/element.ts";
import { measure } from "../geometry/measure.ts";

/** What anywidget hands over: the model that Python shares, and a place in the page. */
interface Cell {
  readonly model: {
    get(trait: string): unknown;
    set(trait: string, value: unknown): void;
    save_changes(): void;
    on(event: string, act: () => void): void;
    off(event: string, act: () => void): void;
  };
  readonly el: HTMLElement;
}

/** Traits that the element has as properties of the same name; null and None leave one as it usually is. */
const traits = ["preset", "params", "step", "view", "color", "drawing", "controls", "theme", "alt"] as const;

define();

function render({ model, el }: Cell): () => void {
  const plant = document.createElement("bough-plant") as BoughPlantElement;
  const set = (trait: (typeof traits)[number]) => Reflect.set(plant, trait, model.get(trait));
  const setFields = () => {
    plant.fields = (model.get("fields") as string[]).join(" ") || null;
  };
  const listeners = new Map<string, () => void>([
    ["fields", setFields],
    ...traits.map((trait) => [trait, () => set(trait)] as const),
  ]);
  for (const [trait, listener] of listeners) {
    if (trait === "fields" || model.get(trait) !== null) listener();
    model.on(`change:${trait}`, listener);
  }
  const tell = (changes: Readonly<Record<string, unknown>>) => {
    for (const [trait, value] of Object.entries(changes)) model.set(trait, value);
    model.save_changes();
  };
  for (const event of ["bough-ready", "bough-change"] as const) {
    plant.addEventListener(event, ({ detail }) => {
      if (detail.moving) return;
      const { report, params } = detail.plant;
      tell({
        shown: { link: plant.link, params, step: detail.step, report, tip: measure(detail.plant).tip },
        problem: "",
      });
    });
  }
  plant.addEventListener("bough-error", ({ detail }) => tell({ problem: detail.message }));
  el.append(plant);
  return () => {
    for (const [trait, listener] of listeners) model.off(`change:${trait}`, listener);
    plant.remove();
  };
}

export default { render };
