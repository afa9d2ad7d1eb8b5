/** Parts of the page that are loaded when they are first wanted. */
import { say } from "../language/say.ts";
import type { State } from "../params/state.ts";
import type { Actions } from "./model.ts";
import type { Notices } from "./notices.ts";
import type { Counter } from "./opening.ts";
import type { Desk } from "./take-away.ts";

export class Late {
  readonly #notices: Notices;

  constructor(notices: Notices) {
    this.#notices = notices;
  }

  /** Does something with a late part; says so if it cannot be loaded. */
  load(work: () => Promise<void>): void {
    work().catch((error: unknown) => {
      const reason = error instanceof Error ? error.message : String(error);
      this.#notices.add(say("A part of the page could not be loaded: reload it. ({0})", reason), {
        tone: "problem",
      });
    });
  }

  /** Opens the gallery; the plate that is shown is marked. */
  gallery(present: string | null, actions: Actions): void {
    this.load(async () => (await import("./plates.ts")).openGallery(present, actions));
  }

  /** Opens the list of keys. */
  keys(): void {
    this.load(async () => (await import("./keys.ts")).openKeys());
  }

  /** Opens what makes files of the plant. */
  takeAway(desk: Desk): void {
    this.load(async () => (await import("./take-away.ts")).openTakeAway(desk));
  }

  /** Opens a file that was dropped or chosen. */
  file(file: File, counter: Counter): void {
    this.load(async () => (await import("./opening.ts")).openFile(file, counter));
  }

  /** Opens what makes the snippet that shows the same in another page. */
  embed(state: State, title: string, picture: HTMLCanvasElement | null): void {
    this.load(async () => (await import("./embed.ts")).openEmbed(state, title, picture));
  }
}
