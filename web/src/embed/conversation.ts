/** Answers the page around: one message after the other, and nobody else. */
import type { BoughPlantElement, ErrorDetail } from "../element/element.ts";
import { Gate } from "./gate.ts";
import { type Ask, type Change, read } from "./message.ts";

/** Says something to whoever asked. */
type Answer = (message: Readonly<Record<string, unknown>>) => void;

export class Conversation {
  readonly #plant: BoughPlantElement;
  readonly #gate = new Gate();
  #last: Promise<void> = Promise.resolve();
  #follower: Answer | null = null;

  constructor(plant: BoughPlantElement) {
    this.#plant = plant;
    const follow = ({ detail }: HTMLElementEventMap["bough-change"]) => {
      if (!detail.moving) this.#follower?.(this.#state);
    };
    plant.addEventListener("bough-ready", follow);
    plant.addEventListener("bough-change", follow);
  }

  /** Takes a message; `answer` reaches its sender and nobody else. */
  hear(data: unknown, answer: Answer, now: number): void {
    const ask = read(data);
    if (!ask) return;
    const passes = this.#gate.pass(now);
    if (passes === false) return;
    const say: Answer = (message) =>
      answer({ bough: 1, ...(ask.id !== undefined && { id: ask.id }), ...message });
    if (passes === "last") say(failure("Too many messages: wait a second.", []));
    else if (ask.type === "error") say(failure(ask.message, []));
    else this.#take(ask, answer, say);
  }

  #take(ask: Ask, answer: Answer, say: Answer): void {
    if (ask.type === "get" && ask.follow !== undefined) {
      this.#follower = ask.follow ? (message) => answer({ bough: 1, ...message }) : null;
    }
    this.#last = this.#last.then(() => this.#respond(ask, say));
  }

  async #respond(ask: Ask, say: Answer): Promise<void> {
    try {
      if (ask.type === "set") await this.#change(ask.change);
      say(this.#state);
    } catch (error) {
      const { message, issues = [] } = error as Error & Partial<ErrorDetail>;
      say(failure(message, issues));
    }
  }

  /** Sets what is asked for, and waits for what comes of it. */
  async #change({ plays, ...properties }: Change): Promise<void> {
    const plant = this.#plant;
    if (Object.keys(properties).length > 0) {
      // What was under way before must not be taken for what comes of this.
      await plant.settled();
      const refusal = firstError(plant);
      Object.assign(plant, properties);
      await plant.settled();
      const detail = refusal();
      if (detail) throw Object.assign(new Error(detail.message), { issues: detail.issues });
    }
    if (plays === true) await plant.play();
    if (plays === false) plant.pause();
  }

  get #state(): Readonly<Record<string, unknown>> {
    const { link, params, step, plant } = this.#plant;
    return { type: "state", link, params, step, report: plant?.report ?? null };
  }
}

/** Listens for errors; what it returns ends that, and gives the first one. */
function firstError(plant: BoughPlantElement): () => ErrorDetail | null {
  let first: ErrorDetail | null = null;
  const listen = ({ detail }: HTMLElementEventMap["bough-error"]) => {
    first ??= detail;
  };
  plant.addEventListener("bough-error", listen);
  return () => {
    plant.removeEventListener("bough-error", listen);
    return first;
  };
}

function failure(message: string, issues: ErrorDetail["issues"]): Readonly<Record<string, unknown>> {
  return { type: "error", message, issues };
}
