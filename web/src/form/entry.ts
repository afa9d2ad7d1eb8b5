/** What a form says when a person has entered something. */
import type { Value } from "../params/declaration.ts";

/** The detail of the event `bough-enter`, which bubbles. */
export interface Entry {
  /** The parameter's path. */
  readonly path: string;
  /** What was entered: a value of the parameter, not yet checked; a text that cannot be read stays a text. */
  readonly value: Value;
  /** Whether the gesture still goes on. */
  readonly how: "dragging" | "settled";
}

declare global {
  interface HTMLElementEventMap {
    "bough-enter": CustomEvent<Entry>;
  }
}
