/** Lets into the state only what a plant can be grown from; says of the rest what is wrong with it. */
import type { Engine } from "../engine/engine.ts";
import type { Entry } from "../form/entry.ts";
import { issueText } from "../form/issue.ts";
import { say } from "../language/say.ts";
import { parameterAt } from "../params/declaration.ts";
import type { Issue } from "../params/issue.ts";
import { defaults, type Params, valueAt, withValue } from "../params/params.ts";
import type { Store } from "../params/store.ts";

export class Intake {
  readonly #check: (params: unknown) => Promise<Issue[]>;
  readonly #store: Store;
  readonly #onChange: () => void;
  #issues: ReadonlyMap<string, Issue> = new Map();
  #pending = 0;

  /** `onChange` is told when an entry has been judged, or the issues are others. */
  constructor(engine: Engine, store: Store, onChange: () => void) {
    this.#check = (params) => engine.check(params);
    this.#store = store;
    this.#onChange = onChange;
  }

  /** What is wrong with the last entries, by the path of the control where it is said. */
  get issues(): ReadonlyMap<string, Issue> {
    return this.#issues;
  }

  /** Whether an entry is being checked. */
  get busy(): boolean {
    return this.#pending > 0;
  }

  /** Takes what a form entered: into the state, or among the issues. */
  async take(entry: Entry): Promise<void> {
    this.#pending++;
    try {
      const { path, value } = entry;
      this.#judge(entry, await this.#check(withValue(this.#store.state.params, path, value)));
    } finally {
      this.#pending--;
      this.#onChange();
    }
  }

  #judge({ path, value, how }: Entry, found: readonly Issue[]): void {
    const issues = new Map(this.#issues);
    issues.delete(path);
    for (const issue of found) issues.set(issue.path, issue);
    // Nothing that was entered may seem to be ignored: a conflict with another value is told here too.
    const [first] = found;
    if (first && !issues.has(path)) issues.set(path, first);
    this.#issues = issues;
    if (!first) this.#store.set({ params: withValue(this.#store.state.params, path, value) }, how);
  }

  /** What is wrong with anything that is given as params. */
  check(params: unknown): Promise<Issue[]> {
    return this.#check(params);
  }

  /** Takes issues that were found on the way. */
  show(found: readonly Issue[]): void {
    this.#put(new Map(found.map((issue) => [issue.path, issue])));
  }

  /** Forgets all issues: the values they were about are gone. */
  clear(): void {
    this.#put(new Map());
  }

  /** Puts the first state right, and says what was wrong. In the meantime another plate may have been chosen. */
  async open(): Promise<string[]> {
    const given = this.#store.state.params;
    const { params, sentences } = await this.repair(given);
    if (this.#store.state.params !== given) return this.open();
    this.#store.set({ params }, "settled");
    return sentences;
  }

  /** The params with every value that stands in the way of a plant at its default, and a sentence on each. */
  async repair(params: Params): Promise<{ params: Params; sentences: string[] }> {
    const issues = await this.#check(params);
    const [first] = issues;
    if (!first) return { params, sentences: [] };
    let repaired = params;
    for (const { path } of issues) {
      if (parameterAt(path)) repaired = withValue(repaired, path, valueAt(defaults, path));
    }
    const sentences = issues.map((issue) => say("{0} Its default is taken instead.", issueText(issue)));
    // Ranges are repaired already; a combination that is still refused gives way to the default plant.
    const rest = await this.#check(repaired);
    return { params: rest.length > 0 ? defaults : repaired, sentences };
  }

  #put(issues: ReadonlyMap<string, Issue>): void {
    if (issues.size === 0 && this.#issues.size === 0) return;
    this.#issues = issues;
    this.#onChange();
  }
}
