/** The one place where the page's state lives. Views read it and speak back only by `set`. */
import { initialState, type State, sameState } from "./state.ts";

/** How a change came about: in the midst of a gesture, at its end, or through history. */
export type Change = "dragging" | "settled" | "undo" | "redo";

/** Called after every change. */
export type Listener = (state: State, change: Change) => void;

/** Most steps that can be undone. */
const MOST_STEPS = 200;

/** The state, its history, and who wants to know. No DOM. */
export class Store {
  #state: State;
  /** The state before the gesture that is going on; the same as the state between gestures. */
  #settled: State;
  #past: State[] = [];
  #future: State[] = [];
  readonly #listeners = new Set<Listener>();

  constructor(state: State = initialState) {
    this.#state = state;
    this.#settled = state;
  }

  /** The present state. */
  get state(): State {
    return this.#state;
  }

  /** Whether there is something to undo. */
  get canUndo(): boolean {
    return this.#past.length > 0 || !sameState(this.#state, this.#settled);
  }

  /** Whether there is something to redo. */
  get canRedo(): boolean {
    return this.#future.length > 0 && sameState(this.#state, this.#settled);
  }

  /** Changes the state. All changes while dragging, and the one that settles them, are undone as one step. */
  set(change: Partial<State>, how: "dragging" | "settled"): void {
    const state = { ...this.#state, ...change };
    const changes = !sameState(state, this.#state);
    if (changes) this.#state = state;
    const settles = how === "settled" && this.#settle();
    if (changes || settles) this.#tell(how);
  }

  /** Goes back to before the last step. */
  undo(): void {
    this.#settle();
    this.#travel(this.#past, this.#future, "undo");
  }

  /** Takes back the last undo. */
  redo(): void {
    this.#settle();
    this.#travel(this.#future, this.#past, "redo");
  }

  /** Calls the listener after every change; returns what ends that. */
  subscribe(listener: Listener): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  /** Ends a gesture; whether it left anything to undo. */
  #settle(): boolean {
    if (sameState(this.#state, this.#settled)) return false;
    this.#past = [...this.#past, this.#settled].slice(-MOST_STEPS);
    this.#future = [];
    this.#settled = this.#state;
    return true;
  }

  #travel(from: State[], to: State[], how: Change): void {
    const state = from.pop();
    if (!state) return;
    to.push(this.#state);
    this.#state = state;
    this.#settled = state;
    this.#tell(how);
  }

  #tell(how: Change): void {
    for (const listener of [...this.#listeners]) listener(this.#state, how);
  }
}
