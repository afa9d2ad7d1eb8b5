/** What all widgets of a page share: one press for their pictures, and one engine, which answers them in turn. */
import type { Engine } from "../engine/engine.ts";
import { EnginePool } from "../engine/pool.ts";
import { engineInThread } from "../engine/thread.ts";
import { load } from "../engine/wasm.ts";
import { Press } from "../scene/press.ts";
import { wasmSource } from "./source.ts";

let press: Press | null = null;
let engine: Engine | null = null;
let members = 0;

/** The press. It is there as long as a stage has it; throws when the browser has no WebGL 2. */
export function sharedPress(): Press {
  if (!press || press.isLost) press = new Press();
  return press;
}

/** Comes in; returns the engine, which is there until the last one has left. */
export function join(): Engine {
  members++;
  engine ??= new EnginePool(engineInThread(() => load(wasmSource)));
  return engine;
}

/** Goes out. */
export function leave(): void {
  if (--members > 0) return;
  engine?.dispose();
  engine = null;
}
