/** Bough off the main thread: promises, progress, abort signals. `init` is not needed here. */
export { startEngine, startPool } from "../engine/engine.ts";
export * from "./worker-api.ts";
