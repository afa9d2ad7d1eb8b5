import {
  BoughError,
  check,
  grow,
  history,
  type Issue,
  init,
  type ParamsInput,
  type Plant,
  presets,
  relaxation,
} from "bough";
import { grow as growInline } from "bough/inline";
import { type Engine, startEngine, startPool } from "bough/worker";

await init();
await init(new Uint8Array());
await init(fetch("bough.wasm"));
// @ts-expect-error a number is no source
await init(1);

const params: ParamsInput = { axis: { segments: 20 }, solver: { method: "newton" } };
const plant: Plant = grow(params);
const points: Float64Array = plant.polylines.points;
const parents: Int32Array = plant.segments.parent;
const stable: boolean | null = plant.report.stable;
const same: Plant = growInline(plant.params);
for (const age of history(presets["figure-13a"]?.params ?? {})) age satisfies Plant;
const angles: Float64Array = relaxation(params, 3).angle;
// @ts-expect-error there is no such parameter
grow({ axis: { segment: 20 } });
// @ts-expect-error there is no such method
grow({ solver: { method: "guess" } });

try {
  grow({});
} catch (error) {
  if (error instanceof BoughError) error.issues satisfies readonly Issue[];
}
const issues: Issue[] = check("anything");

const engine: Engine = await startEngine({ worker: false });
const later: Plant = await engine.plant({}, 7, {
  signal: AbortSignal.timeout(1),
  onProgress: (share: number) => share,
});
const pool = await startPool({ size: 4, wasm: new URL("https://example.org/bough.wasm") });
const size: number = pool.size;

export { angles, issues, later, parents, points, same, size, stable };
