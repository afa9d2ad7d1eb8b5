/** Many plates, one stop for Tab: arrows go from one to the next, Home and End to the ends. */

/** Makes a plate the one that Tab leads to, among all plates of its set. */
export function makeStop(plate: HTMLElement): void {
  for (const one of platesAround(plate)) one.tabIndex = one === plate ? 0 : -1;
}

/** Takes `keydown` and `focusin` of what surrounds the plates. */
export function rove(event: Event): void {
  const plate = event.target instanceof HTMLElement ? event.target.closest<HTMLElement>(".plate") : null;
  if (!plate) return;
  if (!(event instanceof KeyboardEvent)) makeStop(plate);
  else if (!event.ctrlKey && !event.metaKey && !event.altKey) {
    const next = nextOf(plate, event.key);
    if (!next) return;
    event.preventDefault();
    next.focus();
    next.scrollIntoView({ block: "nearest", inline: "nearest" });
  }
}

function nextOf(plate: HTMLElement, key: string): HTMLElement | undefined {
  const plates = platesAround(plate);
  const at = plates.indexOf(plate);
  switch (key) {
    case "ArrowRight":
      return plates[at + 1];
    case "ArrowLeft":
      return plates[at - 1];
    case "Home":
      return plates[0];
    case "End":
      return plates.at(-1);
    case "ArrowDown":
      return nearest(plate, plates.slice(at + 1));
    case "ArrowUp":
      return nearest(plate, plates.slice(0, at).reverse());
    default:
      return undefined;
  }
}

/** Of the next other row the plate that is nearest across. */
function nearest(plate: HTMLElement, others: readonly HTMLElement[]): HTMLElement | undefined {
  const from = plate.getBoundingClientRect();
  const top = (one: HTMLElement) => one.getBoundingClientRect().top;
  const first = others.find((one) => top(one) !== from.top);
  const across = (one: HTMLElement) => Math.abs(one.getBoundingClientRect().left - from.left);
  return first && others.filter((one) => top(one) === top(first)).sort((a, b) => across(a) - across(b))[0];
}

function platesAround(plate: HTMLElement): HTMLElement[] {
  return [...(plate.closest("dialog, .gallery")?.querySelectorAll<HTMLElement>(".plate") ?? [])];
}
