/** Grows plants on request, in slices short enough that its thread stays responsive. */
import { check, History } from "./core.ts";
import { type Answer, buffersOf, type Request } from "./protocol.ts";
import { Stint } from "./stint.ts";
import { nextTurn } from "./turn.ts";

/** How long one slice should take, ms: two of them fit into a frame of 60 Hz. */
const SLICE = 8;

/** Stepped segments in the first slice of a plant: 0.1 ms by Newton, 10 ms by Euler. */
const FIRST_BUDGET = 500;

type PlantRequest = Extract<Request, { kind: "plant" }>;

/** Keeps the history of the plant that was asked for last, so that going to another age of it is quick. */
export class Session {
  readonly #load: () => Promise<void>;
  readonly #answer: Answer;
  #history: History | undefined;
  #grown = "";
  #newest: number | undefined;
  #budget = FIRST_BUDGET;

  /** `load` makes the core ready; it may be called again after a failure. */
  constructor(load: () => Promise<void>, answer: Answer) {
    this.#load = load;
    this.#answer = answer;
  }

  /** Takes a request; the replies go to `answer`. Never rejects. */
  async receive(request: Request): Promise<void> {
    const { kind, id } = request;
    if (kind === "plant") this.#newest = id;
    if (kind === "cancel") return this.#cancel(id);
    try {
      await this.#load();
      if (kind === "plant") await this.#grow(request);
      else this.#answer({ kind: "issues", id, issues: check(request.flat) }, []);
    } catch (error) {
      const { name, message } = error instanceof Error ? error : new Error(String(error));
      this.#answer({ kind: "failed", id, name, message }, []);
    }
  }

  /** Gives the memory back. */
  close(): void {
    this.#newest = undefined;
    this.#history?.free();
    this.#history = undefined;
  }

  #cancel(id: number): void {
    if (this.#newest === id) this.#newest = undefined;
    this.#answer({ kind: "cancelled", id }, []);
  }

  async #grow(request: PlantRequest): Promise<void> {
    const { id, flat, step, grip, deadline } = request;
    if (this.#newest !== id) return;
    const issues = check(flat);
    if (issues.length > 0) return this.#answer({ kind: "issues", id, issues }, []);
    const history = this.#historyOf(flat);
    const wanted = Math.min(step ?? history.steps, history.steps);
    const stint = deadline === undefined ? null : new Stint(deadline);
    while (stint ? stint.go(history, wanted) === "onTheWay" : !this.#slice(history, wanted)) {
      // A step costs its number of segments; along one axis the work grows with the square of the steps.
      this.#answer({ kind: "progress", id, share: (history.step / wanted) ** 2 }, []);
      await nextTurn();
      if (this.#newest !== id) return;
    }
    if (grip) {
      const held = history.hold(grip.segment, grip.place);
      return this.#answer({ kind: "held", id, held }, held ? buffersOf(held.shape) : []);
    }
    const shape = history.shape();
    this.#answer({ kind: "shape", id, shape }, buffersOf(shape));
  }

  #historyOf(flat: Float64Array): History {
    const grown = flat.join();
    if (this.#history && this.#grown === grown) return this.#history;
    this.#history?.free();
    this.#history = undefined;
    this.#history = new History(flat);
    this.#grown = grown;
    this.#budget = FIRST_BUDGET;
    return this.#history;
  }

  /** Grows for about the time of one slice, and learns how much work that is. */
  #slice(history: History, step: number): boolean {
    const start = performance.now();
    const isThere = history.seek(step, this.#budget);
    const took = performance.now() - start;
    if (!isThere) this.#budget *= Math.min(Math.max(SLICE / took, 0.1), 4);
    return isThere;
  }
}
