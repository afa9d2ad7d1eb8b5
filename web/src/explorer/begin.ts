/** Opens the page in its element, in its language. */
import type { Engine } from "../engine/engine.ts";
import { speak } from "../language/load.ts";
import { read } from "../params/link.ts";
import { Explorer } from "./explorer.ts";

export async function begin(startEngine: () => Promise<Engine>): Promise<void> {
  const root = document.querySelector<HTMLElement>("#page");
  if (!root) return;
  // The page says it, if its language cannot be loaded.
  await speak(read(location.search).state.lang).catch(() => false);
  await new Explorer(root).start(startEngine);
}
