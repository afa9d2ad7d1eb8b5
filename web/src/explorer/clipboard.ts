/** What is put on the clipboard. */
import { say } from "../language/say.ts";
import type { Notices } from "./notices.ts";

/** Copies the link, and says what came of it. */
export async function copyLink(link: string, notices: Notices): Promise<void> {
  try {
    await navigator.clipboard.writeText(link);
    notices.add(say("The link is copied: it opens exactly this plant."));
  } catch {
    notices.add(say("Copying is not allowed here; the address bar holds the same link."), {
      tone: "problem",
    });
  }
}
