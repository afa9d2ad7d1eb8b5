import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { Gate } from "../../web/src/embed/gate.ts";
import { read } from "../../web/src/embed/message.ts";

describe("a message to an embedded plant", () => {
  it.each([
    [{ bough: 1, type: "get" }, { type: "get" }],
    [
      { bough: 1, type: "get", id: "a", follow: true },
      { type: "get", id: "a", follow: true },
    ],
    [
      { bough: 1, type: "set", id: 7, params: { loads: { gravity: 3 } }, step: null },
      { type: "set", id: 7, change: { params: { loads: { gravity: 3 } }, step: null } },
    ],
  ])("%j is understood", (message, ask) => {
    expect(read(message)).toEqual(ask);
  });

  it.each([
    null,
    undefined,
    7,
    "get",
    [],
    {},
    { type: "get" },
    { subject: "lti.frameResize" },
    new Map([["bough", 1]]),
  ])("%j is none: silence", (message) => {
    expect(read(message)).toBeNull();
  });

  it.each([
    [{ bough: 2, type: "get" }, "Only version 1"],
    [{ bough: 1 }, "type must be get or set"],
    [{ bough: 1, type: "ready" }, "type must be get or set"],
    [{ bough: 1, type: "get", id: {} }, "id must be"],
    [{ bough: 1, type: "get", id: "x".repeat(101) }, "id must be"],
    [{ bough: 1, type: "get", params: {} }, "params is not known"],
    [{ bough: 1, type: "get", follow: 1 }, "follow must be"],
    [{ bough: 1, type: "set", innerHTML: "<b>" }, "There is no innerHTML to set"],
    [{ bough: 1, type: "set", constructor: 1 }, "There is no constructor to set"],
    [{ bough: 1, type: "set", preset: 8 }, "preset must be a text"],
    [{ bough: 1, type: "set", link: "x".repeat(10_001) }, "link must be a text"],
    [{ bough: 1, type: "set", params: [1] }, "params must be an object"],
    [{ bough: 1, type: "set", step: "4" }, "step must be a number"],
    [{ bough: 1, type: "set", plays: 1 }, "plays must be true or false"],
  ])("%j is refused in a sentence", (message, sentence) => {
    expect(read(message)).toMatchObject({ type: "error", issues: [] });
    expect(read(message)).toHaveProperty("message", expect.stringContaining(sentence));
  });

  it("names the id in a refusal, if that much can be read", () => {
    expect(read({ bough: 1, type: "sit", id: 3 })).toHaveProperty("id", 3);
    expect(read({ bough: 1, type: "sit", id: [] })).not.toHaveProperty("id");
  });

  it("never throws, and lets nothing through but what can be set, over 10,000 messages of any kind", () => {
    const near = fc.record(
      {
        bough: fc.oneof(fc.constant(1), fc.anything()),
        type: fc.oneof(fc.constantFrom("get", "set"), fc.anything()),
        id: fc.anything(),
        params: fc.anything(),
        step: fc.anything(),
        preset: fc.anything(),
        plays: fc.anything(),
        follow: fc.anything(),
      },
      { requiredKeys: [] },
    );
    const settable = "link preset params step view color drawing theme controls plays".split(" ");
    fc.assert(
      fc.property(fc.oneof(near, fc.anything(), fc.dictionary(fc.string(), fc.anything())), (message) => {
        const ask = read(message);
        if (ask?.type === "set") expect(settable).toEqual(expect.arrayContaining(Object.keys(ask.change)));
      }),
      { numRuns: 10_000 },
    );
  });
});

describe("a flood of messages", () => {
  it("is told of once, held off, and forgiven after a pause", () => {
    const gate = new Gate();
    const passes = Array.from({ length: 1000 }, (_, k) => gate.pass(k / 10));
    expect(passes.filter((one) => one === true).length).toBeLessThan(70);
    expect(passes.filter((one) => one === "last")).toHaveLength(1);
    expect(gate.pass(200)).toBe(false);
    expect(gate.pass(3000)).toBe(true);
  });

  it("is not what a slider sends", () => {
    const gate = new Gate();
    const passes = Array.from({ length: 1000 }, (_, k) => gate.pass(40 * k));
    expect(passes.every((one) => one === true)).toBe(true);
  });
});
