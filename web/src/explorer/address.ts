/** The address bar: it always holds the link to what is shown, and Back undoes. */
import { read, write } from "../params/link.ts";
import { sameState } from "../params/state.ts";
import type { Change, Store } from "../params/store.ts";

/** Browsers refuse more than about 100 changes of the address in 30 s. ms */
const pause = 400;

/** Each entry of the browser's history knows its number since the page was first opened. */
interface Entry {
  readonly bough: number;
}

export class Address {
  readonly #store: Store;
  /** Link to the state before the gesture that is going on. */
  #settled: string;
  #at: number;
  /** Whether the entry holds another link than that: it was written over, or came from elsewhere. */
  #isForeign = true;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #follows = false;
  /** Link to the plant that is pinned, or empty: every link carries it along. */
  #pin = new URLSearchParams(location.search).get("pin") ?? "";

  constructor(store: Store) {
    this.#store = store;
    this.#settled = this.#own;
    this.#at = entryNumber(history.state) ?? 0;
    history.replaceState({ bough: this.#at } satisfies Entry, "");
    store.subscribe((_, change) => this.#write(change));
    addEventListener("popstate", (event) => this.#follow(entryNumber(event.state)));
  }

  /** The complete link to what is shown. */
  get link(): string {
    return new URL(this.#own, location.href).href;
  }

  get pin(): string {
    return this.#pin;
  }

  set pin(link: string) {
    this.#pin = link;
    this.#settled = this.#own;
    this.#replace(this.#settled);
  }

  get #own(): string {
    return write(this.#store.state) + (this.#pin && `&pin=${encodeURIComponent(this.#pin)}`);
  }

  /** Undoes the last step: the same as the browser's Back. */
  undo(): void {
    this.#store.set({}, "settled");
    if (this.#store.canUndo) history.back();
  }

  /** Takes back the last undo: the same as the browser's Forward. */
  redo(): void {
    if (this.#store.canRedo) history.forward();
  }

  #write(change: Change): void {
    if (this.#follows) return;
    clearTimeout(this.#timer);
    if (change === "dragging") {
      this.#timer = setTimeout(() => this.#replace(this.#own), pause);
      return;
    }
    if (this.#isForeign) this.#replace(this.#settled);
    this.#isForeign = false;
    this.#settled = this.#own;
    this.#at++;
    history.pushState({ bough: this.#at } satisfies Entry, "", this.#settled);
  }

  #replace(link: string): void {
    this.#isForeign = true;
    history.replaceState({ bough: this.#at } satisfies Entry, "", link);
  }

  /** The browser went to an entry: so does the store, by its own memory where that reaches, else by the link. */
  #follow(number: number | undefined): void {
    if (number === undefined) return;
    clearTimeout(this.#timer);
    this.#follows = true;
    for (; this.#at > number && this.#store.canUndo; this.#at--) this.#store.undo();
    for (; this.#at < number && this.#store.canRedo; this.#at++) this.#store.redo();
    const { state } = read(location.search);
    // Links say less than states: a preset's age beyond a shorter axis is its last. What is redone must not be lost over that.
    const { state: own } = read(write(this.#store.state));
    if (!sameState(state, own)) this.#store.set(state, "settled");
    this.#at = number;
    this.#settled = this.#own;
    this.#isForeign = true;
    this.#follows = false;
  }
}

function entryNumber(state: unknown): number | undefined {
  const number = (state as Entry | null)?.bough;
  return typeof number === "number" ? number : undefined;
}
