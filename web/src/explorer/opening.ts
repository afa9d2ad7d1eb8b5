/** Opens the document of a plant, or says in a sentence why that cannot be done: then nothing changes. Loaded when a file comes. */
import { largest, type Refusal, read } from "../export/document.ts";
import { issueText } from "../form/issue.ts";
import { quantity } from "../geometry/quantity.ts";
import { say } from "../language/say.ts";
import type { ParamsInput } from "../params/params.ts";
import { complete } from "../params/params.ts";
import type { Store } from "../params/store.ts";
import { isPicture } from "./files.ts";
import type { Intake } from "./intake.ts";
import type { Notices } from "./notices.ts";

/** Where a file is handed in. */
export interface Counter {
  readonly intake: Intake;
  readonly store: Store;
  readonly notices: Notices;
}

const refusals: Readonly<Record<Refusal, (name: string) => string>> = {
  notJson: (name) => say("{0} is not the file of a plant: it holds no JSON.", name),
  notAPlant: (name) => say("{0} holds JSON, but no plant.", name),
  newer: (name) => say("{0} was written by a newer Bough. Reload the page, and open it again.", name),
};

export async function openFile(file: File, { intake, store, notices }: Counter): Promise<void> {
  const refuse = (text: string) => notices.add(text, { tone: "problem", passes: true });
  const { name } = file;
  if (isPicture(file)) return refuse(say("{0} is a picture, not the file of a plant.", name));
  // Before it is read: it would not fit into memory.
  if (file.size > largest) {
    return refuse(
      say("{0} has {1}; the file of a plant is never as large as that.", name, quantity(file.size, "B")),
    );
  }
  const text = await file.text().catch(() => null);
  if (text === null) return refuse(say("{0} cannot be read.", name));
  const document = read(text);
  if (typeof document === "string") return refuse(refusals[document](name));
  const issues = await intake.check(document.params);
  if (issues.length > 0) {
    return refuse(
      say("No plant can be grown from {0}. {1}", name, issues.slice(0, 3).map(issueText).join(" ")),
    );
  }
  intake.clear();
  store.set({ ...document.state, params: complete(document.params as ParamsInput) }, "settled");
  notices.add(say("{0} is open; Undo brings back what was there.", name), { passes: false });
}
