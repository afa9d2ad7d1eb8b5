/** The control of one parameter, of native elements, made from its declaration. */
import type { Entry } from "../form/entry.ts";
import { quantityText, unitText } from "../form/quantity.ts";
import { travelOf } from "../form/travel.ts";
import { nameOf } from "../form/words.ts";
import type { Parameter, Value, Vector } from "../params/declaration.ts";
import { element } from "./face.ts";

/** Is told what is entered. */
export type Enter = (value: Value, how: Entry["how"]) => void;

/** A control, and what shows a value in it. */
export interface Dial {
  readonly element: HTMLElement;
  show(value: Value): void;
}

/** Makes the control of a parameter. */
export function dialOf(parameter: Parameter, enter: Enter): Dial {
  switch (parameter.kind) {
    case "choice":
      return choiceOf(
        parameter.label,
        (parameter.options ?? []).map((option) => [option, nameOf(option)]),
        (value) => enter(value, "settled"),
      );
    case "flag":
      return flagOf(parameter, enter);
    case "vector":
      return vectorOf(parameter, enter);
    default:
      return sliderOf(parameter, enter);
  }
}

/** A choice among named options. */
export function choiceOf(
  label: string,
  options: readonly (readonly [name: string, text: string])[],
  enter: (name: string) => void,
): Dial {
  const select = element("select");
  select.append(...options.map(([value, text]) => element("option", { value }, text)));
  select.addEventListener("change", () => enter(select.value));
  return {
    element: element("label", { class: "dial" }, element("span", {}, label), select),
    show: (value) => {
      select.value = String(value);
    },
  };
}

/** A slider with its reading; also for the age. */
export function rangeOf(
  label: string,
  range: Readonly<Record<"min" | "max" | "step", string>>,
  enter: (position: number, how: Entry["how"]) => void,
): { element: HTMLElement; input: HTMLInputElement; output: HTMLOutputElement } {
  const input = element("input", { type: "range", ...range });
  const output = element("output", { "aria-hidden": "true" });
  const tell = (how: Entry["how"]) => () => enter(input.valueAsNumber, how);
  input.addEventListener("input", tell("dragging"));
  input.addEventListener("change", tell("settled"));
  // A drag that ends where it began is no change to the browser, but it ends.
  input.addEventListener("pointerup", tell("settled"));
  const name = element("span", {}, label);
  // The slider first: a label belongs to the first control in it, and an output counts as one.
  return { element: element("label", { class: "dial" }, name, input, output), input, output };
}

function sliderOf(parameter: Parameter, enter: Enter): Dial {
  const { label, unit } = parameter;
  const travel = travelOf(parameter);
  const range = { min: `${travel.min}`, max: `${travel.max}`, step: `${travel.step}` };
  // A value that lies between the slider's steps, or past its ends, is had again where it was shown.
  let [kept, keptAt] = [Number.NaN, Number.NaN];
  const slider = rangeOf(label, range, (position, how) =>
    enter(position === keptAt ? kept : travel.value(position), how),
  );
  return {
    element: slider.element,
    show: (value) => {
      const number = Number(value);
      const text = quantityText(number, unit);
      slider.input.value = String(travel.position(number));
      const position = slider.input.valueAsNumber;
      if (travel.value(position) !== number) [kept, keptAt] = [number, position];
      else if (position === keptAt) keptAt = Number.NaN;
      slider.input.setAttribute("aria-valuetext", text);
      slider.output.textContent = text;
    },
  };
}

function flagOf({ label }: Parameter, enter: Enter): Dial {
  const input = element("input", { type: "checkbox" });
  input.addEventListener("change", () => enter(input.checked, "settled"));
  return {
    element: element("label", { class: "dial" }, element("span", {}, label), input),
    show: (value) => {
      input.checked = value === true;
    },
  };
}

function vectorOf({ label, unit, min, max }: Parameter, enter: Enter): Dial {
  const inputs = ["x", "y", "z"].map((axis) =>
    element("input", {
      type: "number",
      step: "any",
      min: `${min}`,
      max: `${max}`,
      "aria-label": `${label}, ${axis}`,
    }),
  );
  for (const input of inputs) {
    input.addEventListener("change", () =>
      enter(inputs.map(({ valueAsNumber }) => valueAsNumber || 0) as Vector, "settled"),
    );
  }
  const name = element("span", {}, unit ? `${label}, ${unitText(unit)}` : label);
  return {
    element: element("div", { class: "dial vector" }, name, ...inputs),
    show: (value) => {
      inputs.forEach((input, k) => {
        input.value = String((value as Vector)[k]);
      });
    },
  };
}
