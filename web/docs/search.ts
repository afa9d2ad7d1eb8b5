/** Search in the docs: the index is fetched when somebody wants it. Also keeps the docs for readers without a network. */
import MiniSearch, { type SearchResult } from "minisearch";

/** Most places that are listed. */
const mostFound = 12;

const box = document.querySelector<HTMLElement>(".search");
const input = box?.querySelector("input");
const found = box?.querySelector<HTMLElement>(".found");
const count = box?.querySelector<HTMLElement>(".count");
const list = box?.querySelector("ol");
const docs = box?.dataset.docs ?? "";
let index: Promise<MiniSearch> | undefined;

if (box && input && found && count && list) {
  box.hidden = false;
  input.addEventListener("focus", () => void load());
  input.addEventListener("input", () => void show(input.value, found, count, list));
  box.addEventListener("keydown", (event) => {
    if (event.key === "Escape") {
      input.value = "";
      found.hidden = true;
      input.focus();
    }
    // Enter goes to the first place, as its order promises.
    if (event.key === "Enter" && event.target === input) list.querySelector("a")?.click();
  });
}

if ("serviceWorker" in navigator && location.protocol !== "file:") {
  // Where a host does not allow it the docs are read as any page.
  navigator.serviceWorker.register(`${docs}offline.js`).catch(() => undefined);
}

function load(): Promise<MiniSearch> {
  index ??= fetch(`${docs}search.json`)
    .then((answer) => answer.json())
    .then(({ index: made, options }) => MiniSearch.loadJS(made, options));
  return index;
}

async function show(words: string, into: HTMLElement, said: HTMLElement, places: HTMLElement): Promise<void> {
  const results = words.trim() === "" ? [] : (await load()).search(words);
  // Somebody has typed on meanwhile.
  if (words !== input?.value) return;
  into.hidden = words.trim() === "";
  said.textContent =
    results.length === 0
      ? `Nothing has “${words}”.`
      : `${results.length} ${results.length === 1 ? "place" : "places"}`;
  places.replaceChildren(...results.slice(0, mostFound).map(item));
}

function item({ id, page, heading }: SearchResult): HTMLElement {
  const link = document.createElement("a");
  link.href = `${docs}${id}`;
  link.textContent = String(heading);
  const where = document.createElement("span");
  where.textContent = String(page);
  const line = document.createElement("li");
  line.append(link, where);
  return line;
}
