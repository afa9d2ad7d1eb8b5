/** A slider's gestures: by pointer, or by a key, however long it is held down. Each ends once, and is one step of history. */
import type { Entry } from "./entry.ts";

/** Sliders that are moved by a key which is still down. */
const held = new WeakSet<EventTarget>();

/**
 * Takes `input`, `change`, `pointerup`, `keydown`, `keyup` and `blur` of a slider, and says what they mean. A drag that ends
 * where it began is no change to the browser, but it ends: hence `pointerup`.
 */
export function slide(enter: (value: number, how: Entry["how"]) => void): (event: Event) => void {
  return (event) => {
    const slider = event.currentTarget as HTMLInputElement;
    const say = (how: Entry["how"]) => enter(slider.valueAsNumber, how);
    switch (event.type) {
      case "input":
        return say("dragging");
      case "keydown":
        if (/^(Arrow|Page|Home|End)/.test((event as KeyboardEvent).key)) held.add(slider);
        return;
      case "keyup":
      case "blur":
        return held.delete(slider) ? say("settled") : undefined;
      default:
        return held.has(slider) ? undefined : say("settled");
    }
  };
}
