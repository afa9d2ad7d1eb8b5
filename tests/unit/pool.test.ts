import { describe, expect, test, vi } from "vitest";
import type { Engine } from "../../web/src/engine/engine.ts";
import { LostError } from "../../web/src/engine/failure.ts";
import { EnginePool, startPoolOn } from "../../web/src/engine/pool.ts";
import type { Host } from "../../web/src/engine/start.ts";
import type { Plant } from "../../web/src/plant/plant.ts";

/** An engine that is at one plant at a time, and finishes it when the test says so. */
class FakeEngine implements Engine {
  readonly transport: Engine["transport"] = "worker";
  readonly reason = null;
  readonly asked: (number | null)[] = [];
  isDisposed = false;
  #working: PromiseWithResolvers<Plant> | undefined;

  async check() {
    return [];
  }
  plant(_: object, step: number | null = null, { signal }: { signal?: AbortSignal } = {}): Promise<Plant> {
    if (this.#working) throw new Error("One plant at a time.");
    this.asked.push(step);
    const working = withResolvers<Plant>();
    this.#working = working;
    signal?.addEventListener("abort", () => this.fail(signal.reason));
    return working.promise;
  }
  hold = vi.fn(async () => null);
  finish(): void {
    const step = this.asked.at(-1);
    this.#working?.resolve({ report: { steps: step } } as Plant);
    this.#working = undefined;
  }
  fail(reason: unknown): void {
    this.#working?.reject(reason);
    this.#working = undefined;
  }
  dispose(): void {
    this.isDisposed = true;
    this.fail(new DOMException("The engine was disposed of.", "AbortError"));
  }
}

interface PromiseWithResolvers<Value> {
  promise: Promise<Value>;
  resolve(value: Value): void;
  reject(reason: unknown): void;
}

function withResolvers<Value>(): PromiseWithResolvers<Value> {
  let parts: Omit<PromiseWithResolvers<Value>, "promise"> | undefined;
  const promise = new Promise<Value>((resolve, reject) => {
    parts = { resolve, reject };
  });
  return Object.assign({ promise }, parts) as PromiseWithResolvers<Value>;
}

function pool(size = 2) {
  const [first = new FakeEngine(), ...others] = Array.from({ length: size }, () => new FakeEngine());
  return { pool: new EnginePool(first, ...others), engines: [first, ...others] };
}

/** Lets promises that are settled be heard of. */
const turn = () => new Promise((resolve) => setTimeout(resolve));

describe("a pool", () => {
  test("gives every engine one plant, and the others a place in the queue", async () => {
    const { pool: two, engines } = pool();
    const plants = [1, 2, 3, 4].map((step) => two.plant({}, step));
    await turn();
    expect(engines.map(({ asked }) => asked)).toEqual([[1], [2]]);
    engines[1]?.finish();
    await turn();
    expect(engines.map(({ asked }) => asked)).toEqual([[1], [2, 3]]);
    engines[0]?.finish();
    await turn();
    expect(engines.map(({ asked }) => asked)).toEqual([
      [1, 4],
      [2, 3],
    ]);
    for (const engine of engines) engine.finish();
    expect((await Promise.all(plants)).map(({ report }) => report.steps)).toEqual([1, 2, 3, 4]);
  });

  test("asks no engine that it does not need", async () => {
    const { pool: three, engines } = pool(3);
    for (const step of [1, 2, 3]) {
      const plant = three.plant({}, step);
      await turn();
      engines[0]?.finish();
      await plant;
    }
    expect(engines.map(({ asked }) => asked)).toEqual([[1, 2, 3], [], []]);
  });

  test("lets an aborted request leave the queue, and one that had begun free its engine", async () => {
    const { pool: one, engines } = pool(1);
    const aborter = new AbortController();
    const { signal } = aborter;
    const requests = [one.plant({}, 1, { signal }), one.plant({}, 2, { signal }), one.plant({}, 3)];
    await turn();
    aborter.abort();
    const [begun, queued] = await Promise.allSettled(requests.slice(0, 2));
    for (const aborted of [begun, queued]) expect(aborted).toMatchObject({ reason: { name: "AbortError" } });
    await turn();
    expect(engines[0]?.asked).toEqual([1, 3]);
    engines[0]?.finish();
    expect((await requests[2])?.report.steps).toBe(3);
    await expect(one.plant({}, 4, { signal })).rejects.toMatchObject({ name: "AbortError" });
  });

  test("passes on an engine that was lost with the plant it was at: it starts anew", async () => {
    const { pool: one, engines } = pool(1);
    const lost = one.plant({}, 1);
    const next = one.plant({}, 2);
    await turn();
    engines[0]?.fail(new LostError("The worker failed."));
    await expect(lost).rejects.toThrow("The worker failed.");
    await turn();
    engines[0]?.finish();
    expect((await next).report.steps).toBe(2);
  });

  test("that was disposed of rejects everything, begun, queued and to come", async () => {
    const { pool: one, engines } = pool(1);
    const requests = [one.plant({}, 1), one.plant({}, 2)];
    await turn();
    one.dispose();
    requests.push(one.plant({}, 3));
    for (const { status, ...rest } of await Promise.allSettled(requests)) {
      expect([status, rest]).toMatchObject(["rejected", { reason: { name: "AbortError" } }]);
    }
    expect(engines[0]).toMatchObject({ isDisposed: true, asked: [1] });
  });
});

describe("starting a pool", () => {
  const host = (first: () => Promise<never[]>): Host => ({
    workerEngine: () => Object.assign(new FakeEngine(), { check: first }),
    threadEngine: ({ reason = null }) => Object.assign(new FakeEngine(), { transport: "thread", reason }),
    read: (source) => source,
    cores: () => 8,
  });
  const good = host(async () => []);

  test("leaves one processor to the caller, unless a size is given", async () => {
    expect((await startPoolOn(good, {})).size).toBe(7);
    expect((await startPoolOn({ ...good, cores: () => 1 }, {})).size).toBe(1);
    expect((await startPoolOn(good, { size: 3 })).size).toBe(3);
  });

  test("is one engine in this thread where no worker can start, and says why", async () => {
    const strict = host(() => Promise.reject(new LostError("Workers are refused.")));
    const found = await startPoolOn(strict, { size: 4 });
    expect(found).toMatchObject({ size: 1, transport: "thread", reason: "Workers are refused." });
    expect(await startPoolOn(good, { worker: false })).toMatchObject({
      size: 1,
      transport: "thread",
      reason: null,
    });
  });

  test("rejects when the wasm is not there, whoever finds out", async () => {
    await expect(
      startPoolOn(
        host(() => Promise.reject(new Error("404"))),
        {},
      ),
    ).rejects.toThrow("404");
    const wasm = new TextEncoder().encode("<!doctype html>");
    await expect(startPoolOn(good, { wasm })).rejects.toMatchObject({ name: "LoadError" });
  });

  test.each([0, -1, 1.5, Number.NaN])("of size %s is refused", async (size) => {
    await expect(startPoolOn(good, { size })).rejects.toThrow("a whole number from 1 on");
  });
});
