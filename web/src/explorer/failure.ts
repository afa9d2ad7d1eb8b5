/** Why there is no plant, in the language that is spoken. */
import { CoreError, LoadError, LostError } from "../engine/failure.ts";
import { dictionary, say } from "../language/say.ts";

/** The sentence on an error. What it says itself is English, and for those who look into it: it stands behind. */
export function failureText(error: unknown): string {
  const own = error instanceof Error ? error.message : String(error);
  if (!dictionary()) return own;
  return [sentenceOn(error), own].filter(Boolean).join(" ");
}

function sentenceOn(error: unknown): string {
  if (error instanceof LoadError)
    return say("The part that computes (WebAssembly) could not be loaded, or is forbidden here.");
  if (error instanceof CoreError)
    return say("The computation broke off: the memory ran out, or this is a fault of Bough.");
  if (error instanceof LostError) return say("The worker that computes has died.");
  return "";
}
