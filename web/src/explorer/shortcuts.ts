/** Keys that work everywhere on the page, except where they mean something already. */
import { say } from "../language/say.ts";
import type { Actions } from "./model.ts";

/** A key, and what it does. */
export interface Shortcut {
  /** As `KeyboardEvent.key` has it, in lower case. */
  readonly key: string;
  /** How the key is written in the list. */
  readonly sign: string;
  /** With Ctrl, or Cmd on a Mac. */
  readonly command?: boolean;
  name(): string;
  act(actions: Actions): void;
}

/** All of them, in the order of the list. */
export const shortcuts: readonly Shortcut[] = [
  {
    key: " ",
    sign: "Spacebar",
    name: () => say("Watch it grow, or pause"),
    act: (actions) => actions.togglePlay(),
  },
  { key: ",", sign: ",", name: () => say("One step younger"), act: (actions) => actions.age(-1) },
  { key: ".", sign: ".", name: () => say("One step older"), act: (actions) => actions.age(1) },
  {
    key: "l",
    sign: "L",
    name: () => say("Take the loads off, or put them on"),
    act: (actions) => actions.toggleLoads(),
  },
  {
    key: "h",
    sign: "H",
    name: () => say("Take hold of the tip, or let go"),
    act: (actions) => actions.toggleHold(),
  },
  { key: "c", sign: "C", name: () => say("Next colour"), act: (actions) => actions.next("color") },
  { key: "m", sign: "M", name: () => say("Limbs, or the model"), act: (actions) => actions.next("style") },
  { key: "v", sign: "V", name: () => say("Plane, or space"), act: (actions) => actions.next("view") },
  { key: "t", sign: "T", name: () => say("Theme"), act: (actions) => actions.next("theme") },
  { key: "+", sign: "+", name: () => say("Zoom in"), act: (actions) => actions.zoom(1.25) },
  { key: "-", sign: "−", name: () => say("Zoom out"), act: (actions) => actions.zoom(0.8) },
  { key: "0", sign: "0", name: () => say("Show the whole plant"), act: (actions) => actions.fit() },
  { key: "s", sign: "S", name: () => say("Take it away"), act: (actions) => actions.showTakeAway() },
  { key: "g", sign: "G", name: () => say("All plates"), act: (actions) => actions.showGallery() },
  { key: "?", sign: "?", name: () => say("This list"), act: (actions) => actions.showKeys() },
  { key: "z", sign: "Ctrl Z", command: true, name: () => say("Undo"), act: (actions) => actions.undo() },
  { key: "y", sign: "Ctrl Y", command: true, name: () => say("Redo"), act: (actions) => actions.redo() },
];

/** Where it is kept that single keys are unwanted: by people who speak to their computer, say. */
const storageKey = "bough-single-keys";

/** What was chosen on this visit: a browser that keeps nothing must still do as it is told. */
let chosen: boolean | null = null;

/** Whether keys without Ctrl are shortcuts. */
export function singleKeysAreOn(): boolean {
  if (chosen !== null) return chosen;
  try {
    return localStorage.getItem(storageKey) !== "off";
  } catch {
    return true;
  }
}

/** Turns them on or off, for good where the browser keeps such things. */
export function turnSingleKeys(on: boolean): void {
  chosen = on;
  try {
    localStorage.setItem(storageKey, on ? "on" : "off");
  } catch {
    // It will ask again next time.
  }
}

/** Calls the actions whose keys are pressed. */
export function listenToKeys(actions: Actions): void {
  addEventListener("keydown", (event) => {
    const shortcut = shortcutOf(event);
    if (!shortcut || event.defaultPrevented || isTaken(event)) return;
    if (!shortcut.command && !singleKeysAreOn()) return;
    event.preventDefault();
    shortcut.act(actions);
  });
}

function shortcutOf({ key, ctrlKey, metaKey, shiftKey, altKey }: KeyboardEvent): Shortcut | undefined {
  if (altKey) return undefined;
  const command = ctrlKey || metaKey;
  const pressed = command && shiftKey && key.toLowerCase() === "z" ? "y" : key.toLowerCase();
  return shortcuts.find((shortcut) => shortcut.key === pressed && (shortcut.command ?? false) === command);
}

/** Text fields take all keys; space presses the button that has the focus; an open dialog covers the page. */
function isTaken({ target, key }: KeyboardEvent): boolean {
  if (!(target instanceof Element)) return false;
  if (target.matches("input[type=text], select") || target.closest("dialog")) return true;
  return key === " " && target.matches("button, input, summary, a");
}
