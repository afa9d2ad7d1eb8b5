/** What is computed about a plant beyond its shape, over a wasm of its own that is loaded when it is wanted. */
import * as glue from "../../generated/bough-analysis.js";
import type { Status } from "../plant/plant.ts";
import type { Way } from "../plant/way.ts";
import { analysisSource } from "./analysis-place.ts";
import { compiled, type Source } from "./wasm.ts";

/** What is asked. Params are in flat form, and have passed `check`. */
export type Question =
  | { kind: "sensitivity"; flat: Float64Array; step: number; wanted: number[] }
  | { kind: "way"; flat: Float64Array; step: number; byNewton: boolean };

/** What is answered: to "sensitivity" the points and then the derivatives, run after run; nothing if there are none. */
export type Finding = Float64Array | Way;

let loading: Promise<unknown> | undefined;

/** Makes the wasm ready. Only the first call asks for the source; after a failure the next one does so again. */
export function loadAnalysis(source: () => Source | PromiseLike<Source> = analysisSource): Promise<unknown> {
  loading ??= Promise.resolve(source())
    .then(compiled)
    .then((module) => glue.default({ module_or_path: module as WebAssembly.Module }))
    .catch((error: unknown) => {
      loading = undefined;
      throw error;
    });
  return loading;
}

/** Answers a question. Throws a sentence where that is not possible. */
export async function answer(question: Question): Promise<Finding> {
  await loadAnalysis();
  try {
    if (question.kind === "sensitivity") {
      return glue.sensitivity(question.flat, question.step, Uint32Array.from(question.wanted));
    }
    return way(new glue.Way(question.flat, question.step, question.byNewton));
  } catch (error) {
    if (!(error instanceof WebAssembly.RuntimeError)) throw error;
    // A trap leaves the memory in disorder.
    glue.__wbg_reset_state();
    throw new Error(`The computation broke off (${error.message}).`, { cause: error });
  }
}

function way(found: glue.Way): Way {
  const [segments = 0, steps = 0, led = 0] = found.figures();
  const arrays = { time: found.time(), angle: found.angle(), residuals: found.residuals() };
  const status = found.status as Status;
  found.free();
  return { segments, ...arrays, status, steps, isLed: led === 1 };
}
