/** What can go wrong besides bad params. Each says in a sentence what happened. */

/** The wasm could not be loaded, or something else came instead of it. */
export class LoadError extends Error {
  override readonly name = "LoadError";
}

/** The core broke off in the midst of a computation: the memory ran out, or it is a fault of Bough. */
export class CoreError extends Error {
  override readonly name = "CoreError";
}

/** The worker cannot be reached: it never started, or it died. The next request starts another. */
export class LostError extends Error {
  override readonly name = "LostError";
}
