/** Studies a plant beside the engine that grows it: in a worker, or in this thread where none can start. */
import { parameterAt } from "../params/declaration.ts";
import { flatten, type Params } from "../params/params.ts";
import type { Place, Sensitivity } from "../plant/sensitivity.ts";
import type { Way } from "../plant/way.ts";
import { answer, type Finding, type Question } from "./analysis.ts";
import { openAnalysisWorker } from "./analysis-place.ts";

/** A reply of the worker. */
interface Reply {
  readonly id: number;
  readonly finding?: Finding;
  readonly problem?: string;
}

interface Waiting {
  resolve(finding: Finding): void;
  reject(reason: unknown): void;
}

export class Analyst {
  readonly #open: () => Worker | null;
  /** Null once it is known that there is none to be had. */
  #worker: Worker | null | undefined;
  #hasAnswered = false;
  #lastId = 0;
  readonly #waiting = new Map<number, Waiting & { question: Question }>();

  /** `open` opens the worker; null where there are none, as in a page from a file. */
  constructor(open: () => Worker | null = openAnalysisWorker) {
    this.#open = open;
  }

  /** The plant's points at a growth step and their derivatives; null where there are none for this plant. */
  async sensitivity(params: Params, step: number, places: readonly Place[]): Promise<Sensitivity | null> {
    const wanted = places.map(({ path, part }) => (parameterAt(path)?.offset ?? Number.NaN) + part);
    const numbers = await this.#ask({ kind: "sensitivity", flat: flatten(params), step, wanted });
    if (!(numbers instanceof Float64Array)) throw new Error("The worker answered another question.");
    if (numbers.length === 0) return null;
    const size = numbers.length / (1 + places.length);
    const run = (at: number) => numbers.slice(at * size, (at + 1) * size);
    const slopes = places.map((_, at) => run(at + 1));
    return { points: run(0), slopes: slopes.map((slope) => (Number.isNaN(slope[0]) ? null : slope)) };
  }

  /** A way to rest in a growth step: the paper's relaxation, or Newton's iterations. */
  async way(params: Params, step: number, by: "euler" | "newton"): Promise<Way> {
    const question = { kind: "way", flat: flatten(params), step, byNewton: by === "newton" } as const;
    const found = await this.#ask(question);
    if (found instanceof Float64Array) throw new Error("The worker answered another question.");
    return found;
  }

  /** Gives up all that is being computed. */
  cancel(): void {
    if (this.#waiting.size === 0) return;
    this.#worker?.terminate();
    this.#worker = undefined;
    const given = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const { reject } of given) reject(new DOMException("It was cancelled.", "AbortError"));
  }

  #ask(question: Question): Promise<Finding> {
    if (this.#worker === undefined) this.#start();
    const worker = this.#worker;
    if (!worker) return answer(question);
    const id = ++this.#lastId;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { question, resolve, reject });
      worker.postMessage({ id, question });
    });
  }

  #start(): void {
    const worker = this.#open();
    this.#worker = worker;
    worker?.addEventListener("message", ({ data }: MessageEvent<Reply>) => this.#take(data));
    worker?.addEventListener("error", (event) => {
      event.preventDefault();
      this.#lose(event.message);
    });
  }

  #take({ id, finding, problem }: Reply): void {
    this.#hasAnswered = true;
    const waiting = this.#waiting.get(id);
    this.#waiting.delete(id);
    if (finding) waiting?.resolve(finding);
    else waiting?.reject(new Error(problem));
  }

  /** A worker that never answered will not start here: this thread does its work. One that died is followed by another. */
  #lose(reason: string): void {
    this.#worker?.terminate();
    this.#worker = this.#hasAnswered ? undefined : null;
    const given = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const { question, resolve, reject } of given) {
      if (this.#worker === null) answer(question).then(resolve, reject);
      else reject(new Error(`The worker failed: ${reason}`));
    }
  }
}
