import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { Client } from "../../web/src/engine/client.ts";
import type { Shape } from "../../web/src/engine/core.ts";
import { LostError } from "../../web/src/engine/failure.ts";
import type { Reply, Request } from "../../web/src/engine/protocol.ts";
import { complete, flatten } from "../../web/src/params/params.ts";

/** The sessions that a client opened; each keeps what it was sent and replies when the test says so. */
class FakeSession {
  static opened: FakeSession[] = [];
  readonly sent: Request[] = [];
  isOpen = true;
  readonly reply: (reply: Reply) => void;
  readonly die: (reason: string) => void;

  constructor(reply: (reply: Reply) => void, die: (reason: string) => void) {
    this.reply = reply;
    this.die = die;
    FakeSession.opened.push(this);
  }
  send(request: Request): void {
    this.sent.push(request);
  }
  close(): void {
    this.isOpen = false;
  }
  /** Replies to the last request. */
  finish(reply: Partial<Reply>): void {
    this.reply({ id: this.sent.at(-1)?.id ?? -1, ...reply } as Reply);
  }
}

const shape = { report: { steps: 40 } } as Shape;
const rangeIssue = { code: "outOfRange", path: "axis.segments", value: -1, message: "Too few." } as const;

function fakeEngine(transport: "worker" | "thread" = "worker") {
  return new Client(transport, (reply, die) => new FakeSession(reply, die));
}

function session(index = -1): FakeSession {
  const found = FakeSession.opened.at(index);
  if (!found) throw new Error("No session was opened.");
  return found;
}

beforeEach(() => {
  FakeSession.opened = [];
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

describe("a plant", () => {
  test("is asked for in flat form, and comes with its complete params and the version", async () => {
    const engine = fakeEngine();
    const plant = engine.plant({ loads: { gravity: 3 } }, 7);
    const params = complete({ loads: { gravity: 3 } });
    expect(session().sent).toEqual([{ kind: "plant", id: 1, flat: flatten(params), step: 7 }]);
    session().finish({ kind: "shape", shape });
    expect(await plant).toEqual({ ...shape, params, version: expect.stringMatching(/^\d+\.\d+\.\d+/) });
  });

  test("tells its progress", async () => {
    const onProgress = vi.fn();
    const plant = fakeEngine().plant({}, null, { onProgress });
    session().finish({ kind: "progress", share: 0.25 });
    session().finish({ kind: "shape", shape });
    await plant;
    expect(onProgress.mock.calls).toEqual([[0.25]]);
  });

  test("rejects with all that is wrong, what the structure shows and what the core finds", async () => {
    const plant = fakeEngine().plant({ axis: { segments: -1 }, leaves: 3 } as object);
    await vi.waitFor(() => expect(session().sent).toMatchObject([{ kind: "check" }]));
    session().finish({ kind: "issues", issues: [rangeIssue] });
    await expect(plant).rejects.toMatchObject({
      name: "BoughError",
      issues: [rangeIssue, { code: "unknownKey", path: "leaves", value: 3 }],
    });
  });

  test("rejects with what the core finds", async () => {
    const plant = fakeEngine().plant({ axis: { segments: -1 } });
    session().finish({ kind: "issues", issues: [rangeIssue] });
    await expect(plant).rejects.toMatchObject({
      name: "BoughError",
      message: "Too few.",
      issues: [rangeIssue],
    });
  });

  test("rejects with the sentence of a failure, and the next request is answered", async () => {
    const engine = fakeEngine();
    const plant = engine.plant({});
    session().finish({ kind: "failed", message: "The computation broke off." });
    await expect(plant).rejects.toThrow("The computation broke off.");
    const next = engine.plant({});
    session().finish({ kind: "shape", shape });
    expect(await next).toMatchObject(shape);
    expect(FakeSession.opened).toHaveLength(1);
  });
});

describe("the newest request wins", () => {
  test("an older one rejects at once, and what its session still says is ignored", async () => {
    const engine = fakeEngine();
    const older = engine.plant({});
    const newer = engine.plant({}, 3);
    await expect(older).rejects.toMatchObject({ name: "AbortError" });
    session().reply({ kind: "shape", id: 1, shape: { report: { steps: 1 } } as Shape });
    session().reply({ kind: "shape", id: 2, shape });
    expect(await newer).toMatchObject(shape);
  });

  test("checks do not compete", async () => {
    const engine = fakeEngine();
    const checked = engine.check({});
    const plant = engine.plant({});
    session().reply({ kind: "issues", id: 1, issues: [] });
    session().reply({ kind: "shape", id: 2, shape });
    expect(await checked).toEqual([]);
    expect(await plant).toMatchObject(shape);
  });
});

describe("an abort signal", () => {
  test("ends the request, and tells the session", async () => {
    const { signal, abort } = controller();
    const plant = fakeEngine().plant({}, null, { signal });
    abort();
    await expect(plant).rejects.toMatchObject({ name: "AbortError" });
    expect(session().sent.at(-1)).toEqual({ kind: "cancel", id: 1 });
  });

  test("that is already aborted asks for nothing", async () => {
    const { signal, abort } = controller();
    abort();
    await expect(fakeEngine().plant({}, null, { signal })).rejects.toMatchObject({ name: "AbortError" });
    expect(FakeSession.opened).toEqual([]);
  });

  test("that comes too late changes nothing", async () => {
    const { signal, abort } = controller();
    const engine = fakeEngine();
    const plant = engine.plant({}, null, { signal });
    session().finish({ kind: "shape", shape });
    await plant;
    abort();
    expect(session().sent).toHaveLength(1);
  });
});

describe("a session that dies", () => {
  test("rejects what is pending with the reason, and the next request opens another", async () => {
    const engine = fakeEngine();
    const pending = [engine.check({}), engine.plant({})];
    session().die("The worker failed.");
    for (const promise of pending) await expect(promise).rejects.toThrow(new LostError("The worker failed."));
    const next = engine.plant({});
    expect(FakeSession.opened).toHaveLength(2);
    session().finish({ kind: "shape", shape });
    expect(await next).toMatchObject(shape);
  });

  test("says nothing any more", async () => {
    const engine = fakeEngine();
    const first = engine.check({});
    session().die("Gone.");
    await expect(first).rejects.toThrow("Gone.");
    const next = engine.check({});
    session(0).reply({ kind: "issues", id: 2, issues: [rangeIssue] });
    session(0).die("Gone again.");
    session(1).reply({ kind: "issues", id: 2, issues: [] });
    expect(await next).toEqual([]);
  });

  test("or never starts rejects with a sentence", async () => {
    const engine = new Client("worker", () => {
      throw new Error("Workers are refused.");
    });
    await expect(engine.check({})).rejects.toThrow(
      /^The engine could not be started\. .*Workers are refused\./,
    );
  });
});

describe("a session that does not listen", () => {
  test("is ended, and a fresh one is asked for what is still wanted", async () => {
    const engine = fakeEngine();
    await answered(engine);
    const older = engine.plant({});
    const newer = engine.plant({}, 3);
    await expect(older).rejects.toMatchObject({ name: "AbortError" });
    // What the dropped request says is no answer to the newer one.
    session().reply({ kind: "progress", id: 2, share: 0.1 });
    vi.advanceTimersByTime(1000);
    expect(FakeSession.opened.map(({ isOpen }) => isOpen)).toEqual([false, true]);
    expect(session().sent).toMatchObject([{ kind: "plant", id: 3, step: 3 }]);
    session().finish({ kind: "shape", shape });
    expect(await newer).toMatchObject(shape);
  });

  test("but answers in time is kept", async () => {
    const engine = fakeEngine();
    await answered(engine);
    const { signal, abort } = controller();
    const plant = engine.plant({}, null, { signal });
    abort();
    await expect(plant).rejects.toMatchObject({ name: "AbortError" });
    session().reply({ kind: "cancelled", id: 2 });
    vi.advanceTimersByTime(10_000);
    expect(FakeSession.opened.map(({ isOpen }) => isOpen)).toEqual([true]);
  });

  test("because it is still being loaded is given all the time it needs", async () => {
    const engine = fakeEngine();
    const older = engine.plant({});
    const newer = engine.plant({});
    await expect(older).rejects.toMatchObject({ name: "AbortError" });
    vi.advanceTimersByTime(100_000);
    expect(FakeSession.opened).toHaveLength(1);
    session().finish({ kind: "shape", shape });
    expect(await newer).toMatchObject(shape);
  });

  test("in this thread cannot be ended", async () => {
    const engine = fakeEngine("thread");
    await answered(engine);
    const older = engine.plant({});
    void engine.plant({}).catch(() => undefined);
    await expect(older).rejects.toMatchObject({ name: "AbortError" });
    vi.advanceTimersByTime(100_000);
    expect(session().isOpen).toBe(true);
  });
});

test("an engine that was disposed of rejects everything, pending and to come", async () => {
  const engine = fakeEngine();
  const pending = engine.plant({});
  engine.dispose();
  await expect(pending).rejects.toMatchObject({ name: "AbortError" });
  await expect(engine.check({})).rejects.toMatchObject({ name: "AbortError" });
  expect(FakeSession.opened.map(({ isOpen }) => isOpen)).toEqual([false]);
});

async function answered(engine: Client): Promise<void> {
  const checked = engine.check({});
  session().finish({ kind: "issues", issues: [] });
  await checked;
}

function controller() {
  const aborter = new AbortController();
  return { signal: aborter.signal, abort: () => aborter.abort() };
}
