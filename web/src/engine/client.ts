/** The engine as promises, over whatever carries requests to a session and its replies back. */
import { type Vector, version } from "../params/declaration.ts";
import { allIssues, examined } from "../params/examination.ts";
import { BoughError, type Issue } from "../params/issue.ts";
import type { Params, ParamsInput } from "../params/params.ts";
import type { Plant } from "../plant/plant.ts";
import type { Engine, PlantOptions } from "./engine.ts";
import { CoreError, LoadError, LostError } from "./failure.ts";
import type { Grip, Reply, Request } from "./protocol.ts";
import { milliseconds } from "./stint.ts";

/** A way to a session. */
export interface Line {
  send(request: Request): void;
  close(): void;
  /** Told whether anything waits for a reply: only then must the process stay alive. */
  keepAlive?(isAwaited: boolean): void;
}

/** Opens a way to a fresh session. `onLoss` is told why when the session dies. */
export type Connect = (onReply: (reply: Reply) => void, onLoss: (reason: string) => void) => Line;

/**
 * How long a session may be silent after it was told to drop its work, ms. It looks for messages after every slice; one
 * that does not is inside a growth step which takes too long, and only ending its thread ends that.
 */
const PATIENCE = 1000;

type Result = Extract<Reply, { kind: "issues" | "shape" | "held" }>;

/** A request that waits for its reply. */
interface Waiting {
  request: Exclude<Request, { kind: "cancel" }>;
  onProgress: ((share: number) => void) | undefined;
  resolve(result: Result): void;
  reject(reason: unknown): void;
}

/** An engine on a session that is opened with the first request, and opened anew after a loss. */
export class Client implements Engine {
  readonly transport: Engine["transport"];
  readonly reason: string | null;
  readonly #connect: Connect;
  #line: Line | undefined;
  #hasAnswered = false;
  #isDisposed = false;
  #lastId = 0;
  #newest: number | undefined;
  #silence: ReturnType<typeof setTimeout> | undefined;
  readonly #waiting = new Map<number, Waiting>();

  constructor(transport: Engine["transport"], connect: Connect, reason: string | null = null) {
    this.transport = transport;
    this.reason = reason;
    this.#connect = connect;
  }

  async check(params: unknown): Promise<Issue[]> {
    const examination = examined(params);
    const id = ++this.#lastId;
    const reply = await this.#ask({ kind: "check", id, flat: examination.flat });
    return allIssues(examination, reply.kind === "issues" ? reply.issues : []);
  }

  async plant(params: ParamsInput, step: number | null = null, options: PlantOptions = {}): Promise<Plant> {
    const { deadline } = options;
    const wanted = deadline === undefined ? { step } : { step, deadline: milliseconds(deadline) };
    const { reply, params: whole } = await this.#grow(params, wanted, options);
    if (reply.kind !== "shape") throw new CoreError("The session answered another question.");
    return { ...reply.shape, params: whole, version };
  }

  async hold(
    params: ParamsInput,
    step: number | null,
    segment: number,
    place: Vector,
    options: PlantOptions = {},
  ): Promise<Plant | null> {
    const { reply, params: whole } = await this.#grow(params, { step, grip: { segment, place } }, options);
    if (reply.kind !== "held") throw new CoreError("The session answered another question.");
    if (!reply.held) return null;
    const { shape, force } = reply.held;
    const loads = { ...whole.loads, forces: [{ segment, force }] };
    return { ...shape, params: { ...whole, loads }, version };
  }

  /** Asks for a plant; nothing but the newest such request is answered. */
  async #grow(
    params: ParamsInput,
    wanted: { step: number | null; grip?: Grip; deadline?: number },
    { signal, onProgress }: PlantOptions,
  ): Promise<{ reply: Exclude<Result, { kind: "issues" }>; params: Params }> {
    signal?.throwIfAborted();
    this.#drop(aborted("A newer request took its place."));
    const examination = examined(params);
    if (examination.issues.length > 0) throw new BoughError(await this.check(params));
    const id = ++this.#lastId;
    this.#newest = id;
    const cancel = () => {
      if (this.#newest !== id) return;
      this.#drop(signal?.reason);
      this.#line?.send({ kind: "cancel", id });
    };
    signal?.addEventListener("abort", cancel);
    try {
      const reply = await this.#ask({ kind: "plant", id, flat: examination.flat, ...wanted }, onProgress);
      if (reply.kind === "issues") throw new BoughError(allIssues(examination, reply.issues));
      return { reply, params: examination.params };
    } finally {
      signal?.removeEventListener("abort", cancel);
    }
  }

  dispose(): void {
    this.#isDisposed = true;
    this.#fail(aborted("The engine was disposed of."));
  }

  #ask(request: Waiting["request"], onProgress?: Waiting["onProgress"]): Promise<Result> {
    return new Promise((resolve, reject) => {
      if (this.#isDisposed) throw aborted("The engine was disposed of.");
      this.#waiting.set(request.id, { request, onProgress, resolve, reject });
      try {
        this.#open().send(request);
        this.#line?.keepAlive?.(true);
      } catch (error) {
        this.#fail(new LostError(`The engine could not be started. ${error}`, { cause: error }));
      }
    });
  }

  #open(): Line {
    if (this.#line) return this.#line;
    this.#hasAnswered = false;
    const line = this.#connect(
      (reply) => this.#line === line && this.#take(reply),
      (reason) => this.#line === line && this.#fail(new LostError(reason)),
    );
    this.#line = line;
    return line;
  }

  #take(reply: Reply): void {
    const { kind, id } = reply;
    const waiting = this.#waiting.get(id);
    this.#hasAnswered = true;
    // What a dropped request still says is no sign that the session listens.
    if (waiting || kind === "cancelled") clearTimeout(this.#silence);
    if (!waiting || kind === "cancelled") return;
    if (kind === "progress") {
      waiting.onProgress?.(reply.share);
      return;
    }
    this.#settle(id);
    if (kind === "failed") waiting.reject(failure(reply));
    else waiting.resolve(reply);
  }

  #settle(id: number): void {
    this.#waiting.delete(id);
    if (this.#newest === id) this.#newest = undefined;
    if (this.#waiting.size === 0) this.#line?.keepAlive?.(false);
  }

  /** Rejects the plant that is being waited for; the session is told by the request that follows. */
  #drop(reason: unknown): void {
    const id = this.#newest;
    if (id === undefined) return;
    this.#waiting.get(id)?.reject(reason);
    this.#settle(id);
    // A session that never answered may still be downloading the wasm: that may take its time.
    if (this.transport === "worker" && this.#hasAnswered) {
      clearTimeout(this.#silence);
      this.#silence = setTimeout(() => this.#restart(), PATIENCE);
    }
  }

  /** Ends a session that does not listen, and asks a fresh one for what is still wanted. */
  #restart(): void {
    this.#hangUp();
    for (const { request } of this.#waiting.values()) this.#open().send(request);
    this.#line?.keepAlive?.(true);
  }

  #fail(reason: unknown): void {
    this.#hangUp();
    const all = [...this.#waiting.values()];
    this.#waiting.clear();
    this.#newest = undefined;
    for (const { reject } of all) reject(reason);
  }

  #hangUp(): void {
    clearTimeout(this.#silence);
    this.#line?.close();
    this.#line = undefined;
  }
}

/** The error that broke the session's work, here. */
function failure({ name, message }: Extract<Reply, { kind: "failed" }>): Error {
  if (name === "LoadError") return new LoadError(message);
  if (name === "CoreError") return new CoreError(message);
  return new Error(message);
}

function aborted(message: string): DOMException {
  return new DOMException(message, "AbortError");
}
