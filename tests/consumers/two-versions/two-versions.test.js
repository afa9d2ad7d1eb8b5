import assert from "node:assert/strict";
import { test } from "node:test";
import * as bough from "bough";
import { startEngine } from "bough/worker";
import * as next from "bough-next";
import { startEngine as startNext } from "bough-next/worker";

test("two versions live side by side, each with its own core", async () => {
  assert.notEqual(bough.version, next.version);
  await bough.init();
  assert.throws(() => next.grow({}), /call init\(\)/);
  await next.init();
  const ages = bough.history({ axis: { segments: 30 } });
  for (const { grow, version } of [bough, next]) {
    const plant = grow({ axis: { segments: 20 } });
    assert.equal(plant.version, version);
    assert.equal(plant.report.status, "converged");
  }
  assert.equal(ages.at(30).report.steps, 30);
});

test("their errors are told by name, not by class", () => {
  for (const { grow, BoughError } of [bough, next]) {
    assert.throws(() => grow({ leaves: 1 }), BoughError);
    assert.throws(() => grow({ leaves: 1 }), { name: "BoughError" });
  }
  assert.notEqual(bough.BoughError, next.BoughError);
});

test("so do their workers", async () => {
  const engines = [await startEngine(), await startNext()];
  const plants = await Promise.all(engines.map((engine) => engine.plant({})));
  assert.deepEqual(
    plants.map(({ version }) => version),
    [bough.version, next.version],
  );
  for (const engine of engines) engine.dispose();
});
