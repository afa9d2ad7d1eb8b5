import assert from "node:assert/strict";
import { test } from "node:test";
import { BoughError, check, grow, init } from "bough";
import { startEngine, startPool } from "bough/worker";

/** Takes some seconds. */
const large = { axis: { segments: 20_000, segmentLength: 1e-4 } };

test("before init, grow says what is missing", () => {
  assert.throws(() => grow({}), /call init\(\) and wait for it first/);
});

test("an init that fails says why, and may be called again", async () => {
  await assert.rejects(init("file:///nowhere/bough.wasm"), {
    name: "LoadError",
    message: /could not be read/,
  });
  await assert.rejects(init(new URL(import.meta.url)), { name: "LoadError", message: /is not WebAssembly/ });
  await Promise.all([init(), init(), init()]);
  assert.equal(grow({}).report.status, "converged");
});

test("bad params throw one error that lists every problem", () => {
  const bad = { axis: { segments: -1, colour: "green" } };
  assert.throws(() => grow(bad), BoughError);
  assert.deepEqual(
    check(bad).map(({ code }) => code),
    ["outOfRange", "unknownKey"],
  );
});

test("a pool answers every request in turn, and lets go of aborted ones", async () => {
  const pool = await startPool({ size: 2 });
  const aborter = new AbortController();
  const begun = pool.plant(large, null, { signal: aborter.signal, onProgress: () => aborter.abort() });
  const queued = [pool.plant(large, null, { signal: aborter.signal }), pool.plant({}), pool.plant({}, 3)];
  await assert.rejects(begun, { name: "AbortError" });
  const [aborted, ...grown] = await Promise.allSettled(queued);
  assert.equal(aborted.reason.name, "AbortError");
  assert.deepEqual(
    grown.map(({ value }) => value.report.steps),
    [40, 3],
  );
  pool.dispose();
});

test("a worker that dies rejects what it was at, and another one goes on", async () => {
  const engine = await startEngine({ worker: new URL("./dying-worker.js", import.meta.url) });
  assert.equal(engine.transport, "worker");
  await assert.rejects(engine.plant({}, 13), {
    name: "LostError",
    message: "The worker ended with exit code 7.",
  });
  assert.equal((await engine.plant({}, 12)).report.steps, 12);
  engine.dispose();
});

test("where no worker can start the engine computes in this thread, and says why", async () => {
  const engine = await startEngine({ worker: new URL("./missing.js", import.meta.url) });
  assert.equal(engine.transport, "thread");
  assert.match(engine.reason, /missing\.js/);
  assert.equal((await engine.plant({})).report.status, "converged");
});

test("engines that are not disposed of do not keep the process alive", async () => {
  const pool = await startPool({ size: 2 });
  assert.equal((await pool.plant({})).report.status, "converged");
});
