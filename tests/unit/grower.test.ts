/** Who wants plants is told what came of it, in an order in which the last word is the one that holds. */
import { expect, it } from "vitest";
import type { Engine } from "../../web/src/engine/engine.ts";
import { Grower } from "../../web/src/engine/grower.ts";
import { defaults } from "../../web/src/params/params.ts";

/** On a slow machine the sentence on a failure was taken back by the end of the progress, and nothing was left to read. */
it.each([0, 250])("a failure after %i ms is told after the progress has ended", async (delay) => {
  const engine = {
    plant: () =>
      new Promise((_, reject) => {
        setTimeout(() => reject(new Error("forbidden")), delay);
      }),
  } as unknown as Engine;
  const told: string[] = [];
  await new Promise<void>((resolve) => {
    const grower = new Grower(engine, {
      onPlant: () => told.push("plant"),
      onIssues: () => told.push("issues"),
      onFailure: ({ message }) => told.push(message),
      onProgress: (share) => told.push(share === null ? "over" : "growing"),
      onRest: resolve,
    });
    grower.want(defaults, null);
  });
  expect(told).toEqual(delay === 0 ? ["forbidden"] : ["growing", "over", "forbidden"]);
});
