/**
 * Somebody who does anything: seeded random actions on whatever the page offers, and what must hold after each of them. New
 * controls are found by themselves: what can be clicked, typed into or moved is an action.
 */
import type { Browser, Page } from "playwright";
import { quantityText } from "../../web/src/form/quantity.ts";
import { measure } from "../../web/src/geometry/measure.ts";
import { history, init } from "../../web/src/package/node.ts";
import { read, write } from "../../web/src/params/link.ts";
import { stepsOf } from "../../web/src/params/params.ts";
import { randomFrom } from "../random.ts";
import { complaint } from "./chromium.ts";
import { paintNothing } from "./visit.ts";

/** What is typed: numbers of every kind, and what is no number. */
const texts = [
  ..."0 1 2 7 12 40 -1 -45 0.5 3,5 1e3 1e5 1e-9 1e999 -0 1e9 1/3".split(" "),
  "4 cm",
  "1 GPa",
  "",
  "abc",
  "NaN",
  "<img src=x onerror=alert(1)>",
  "9".repeat(400),
  "\u202e12\u0000",
];
const keys = [..."lcmvtg?,.+-0h".split(""), "Escape", "Control+z", "Control+y", "Tab", "Home"];
const travels = ["ArrowRight", "ArrowLeft", "PageUp", "PageDown", "Home", "End"];
const sizes = [
  [1280, 800],
  [390, 844],
  [320, 600],
  [700, 420],
] as const;

/** How long it may play before it is paused, a plant may take before it is cancelled, and everything before it hangs. ms */
const [playtime, patience, longest] = [300, 3000, 60_000];

interface Walker {
  readonly page: Page;
  readonly problems: string[];
  /** From 0 to 1, which it never is. */
  readonly random: () => number;
  readonly pick: <One>(many: readonly One[]) => One;
  readonly chance: (share: number) => boolean;
}

/** A walk: where its chances come from, how many actions it has, and whether the picture is painted on the way. */
export interface Way {
  readonly seed: number;
  readonly actions: number;
  readonly painted: boolean;
  /** Told how many actions it has done, every thousand of them. */
  readonly tell?: (line: string) => void;
}

/** Takes that many actions; throws with the last of them when something does not hold. Returns how often what was checked. */
export async function walk(browser: Browser, site: string, way: Way): Promise<string> {
  const { seed, actions, painted } = way;
  await init();
  const random = randomFrom(seed);
  const context = await browser.newContext({
    viewport: { width: 700, height: 420 },
    reducedMotion: "reduce",
  });
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  const page = await context.newPage();
  const problems = complaints(page);
  const walker: Walker = {
    page,
    problems,
    random,
    pick: (many) => many[Math.floor(random() * many.length)] as (typeof many)[number],
    chance: (share) => random() < share,
  };
  const done: string[] = [];
  const counts = { compared: 0, undone: 0, cancelled: 0 };
  try {
    if (!painted) await page.addInitScript(paintNothing);
    await page.goto(site);
    await rest(walker, counts);
    for (let action = 0; action < actions; action++) {
      const before = page.url();
      done.push(await act(walker));
      if (done.length % 1000 === 0) way.tell?.(`${done.length} of ${actions} actions`);
      await rest(walker, counts);
      if (problems.length > 0) throw new Error(problems[0]);
      if (walker.chance(0.2)) counts.compared += await comparePlant(page, counts.cancelled > 0);
      // After an undo the way back leads elsewhere.
      const wentBack = /^(key Control|back or forth)/.test(done.at(-1) ?? "");
      // What is pinned is in the address, and no step of the history.
      const changed = meaning(page.url()) !== meaning(before);
      if (changed && !wentBack && walker.chance(0.3))
        counts.undone += await undoAndRedo(walker, before, counts);
    }
  } catch (error) {
    const last = done.slice(-20).join("; ");
    throw new Error(`Seed ${seed}, action ${done.length} (${last}) at ${page.url()}: ${error}`, {
      cause: error,
    });
  } finally {
    await context.close();
  }
  const { compared, undone, cancelled } = counts;
  const how = painted ? "" : " without paint";
  return `seed ${seed}: ${done.length} actions${how}, plant and address compared ${compared} times, ${undone} undone and redone, ${cancelled} long ones cancelled: 0 broken`;
}

/** Whatever the page complains of. */
function complaints(page: Page): string[] {
  const found: string[] = [];
  page.on("console", (message) => {
    const said = complaint(message);
    if (said) found.push(said);
  });
  page.on("pageerror", (error) => found.push(`exception: ${error.stack}`));
  page.on("dialog", (dialog) => {
    found.push(`dialog: ${dialog.message()}`);
    void dialog.dismiss();
  });
  return found;
}

/** One action; returns what it was. */
async function act(walker: Walker): Promise<string> {
  const { page, random, pick, chance } = walker;
  if (chance(0.15)) {
    const key = pick(keys);
    await page.keyboard.press(key);
    // What is typed into a box would be entered when the box is left: a step of its own, in the midst of the next action.
    if (await page.evaluate(() => document.activeElement?.matches("input[type=text], textarea")))
      await page.keyboard.press("Enter");
    return `key ${key}`;
  }
  if (chance(0.05)) {
    const [width, height] = pick(sizes);
    await page.setViewportSize({ width, height });
    return `size ${width} × ${height}`;
  }
  if (chance(0.01)) {
    await page.reload();
    return "reload";
  }
  if (chance(0.05)) return drag(walker);
  const control = await page.evaluate(choose, random());
  return control ? use(walker, control) : "nothing to do";
}

/** What a control is, as far as its use depends on it. */
interface Control {
  readonly kind: string;
  readonly name: string;
  /** Whether it only takes a click, and had it. */
  readonly isClicked: boolean;
  /** Whether it goes back or forth in history. */
  readonly steps: boolean;
  /** How many options a choice has. */
  readonly options: number;
}

/**
 * Runs in the page: one of all that can be used now, in the dialog that is open, else on the page. What only takes a click gets
 * it at once; others are left in `chosen` of the window, for the keyboard.
 */
function choose(chance: number): Control | null {
  const within = [...document.querySelectorAll("dialog[open]")].at(-1) ?? document;
  const all = within.querySelectorAll<HTMLElement>(
    "button, input, select, summary, textarea, [tabindex='0']",
  );
  const usable = [...all].filter(
    (one) => one.checkVisibility() && !one.matches(":disabled, [type=file], [readonly], [inert] *"),
  );
  const one = usable[Math.floor(chance * usable.length)];
  if (!one) return null;
  const kind = one instanceof HTMLInputElement ? one.type : one.localName;
  const control = {
    kind,
    isClicked: !/^(range|select|text|textarea|search|number)$/.test(kind),
    name: one.getAttribute("aria-label") || one.id || one.textContent?.trim().slice(0, 30) || one.className,
    steps: one.matches(".masthead .actions > button:nth-of-type(-n + 2)"),
    options: one instanceof HTMLSelectElement ? one.options.length : 0,
  };
  Object.assign(window, { chosen: one });
  // What is drawn as SVG, like a plot that takes the keyboard, has no click() of its own.
  if (control.isClicked) one.dispatchEvent(new MouseEvent("click", { bubbles: true, cancelable: true }));
  return control;
}

async function use({ page, pick }: Walker, control: Control): Promise<string> {
  const { kind, name, isClicked, steps, options } = control;
  if (isClicked) return steps ? `back or forth by ${name}` : `click on ${name}`;
  const chosen = await page.evaluateHandle(() => (window as unknown as { chosen: HTMLElement }).chosen);
  const element = chosen.asElement();
  if (!element) throw new Error(`${name} is lost.`);
  try {
    if (kind === "range") {
      const key = pick(travels);
      await element.focus();
      await page.keyboard.press(key);
      // A key that is held down is one step of history; this one is let go.
      return `${key} on ${name}`;
    }
    if (kind === "select") {
      const index = pick(Array.from({ length: options }, (_, number) => number));
      await element.selectOption({ index });
      return `option ${index} of ${name}`;
    }
    const text = pick(kind === "number" ? texts.filter((one) => /^[-\d.]+$/.test(one)) : texts);
    await element.fill(text);
    await page.keyboard.press("Enter");
    return `“${text.slice(0, 30)}” into ${name}`;
  } finally {
    await element.dispose();
  }
}

/** Drags across the picture by the mouse: a branch bends, or the view turns. */
async function drag({ page, pick }: Walker): Promise<string> {
  const box = await page.locator("canvas.picture").boundingBox();
  if (!box || (await page.locator("dialog[open]").count()) > 0) return "no picture to drag on";
  const place = () =>
    [box.x + box.width * pick([0.2, 0.4, 0.6, 0.8]), box.y + box.height * pick([0.3, 0.5, 0.7])] as const;
  await page.mouse.move(...place());
  await page.mouse.down();
  await page.mouse.move(...place(), { steps: 3 });
  await page.mouse.up();
  return "drag";
}

/** Runs in the page: waits until all is at rest, at most so many ms; whether it is. */
async function comesToRest(longest: number): Promise<boolean> {
  for (const begin = performance.now(); performance.now() - begin < longest; ) {
    if (document.documentElement.dataset.settled === "true") return true;
    await new Promise((resolve) => setTimeout(resolve, 4));
  }
  return false;
}

/** Waits until all is at rest. What takes long is cancelled, what plays is paused, as a person would. */
async function rest({ page, problems }: Walker, counts: { cancelled: number }): Promise<void> {
  const begin = Date.now();
  for (let wait = playtime; Date.now() - begin < longest; wait = patience - playtime) {
    // Back over a reload is another document: what waits in the old one is lost with it.
    const rests = await page.evaluate(comesToRest, wait).catch(() => false);
    if (rests) return;
    const pressed = await page.evaluate(
      (mayCancel) => {
        const cancel = document.querySelector<HTMLElement>(".progress button");
        const play = document.querySelector<HTMLElement>(".play");
        const plays = /^(Pause|Anhalten|Pausa|暂停)$/.test(play?.ariaLabel ?? "");
        (mayCancel && cancel ? cancel : plays ? play : null)?.click();
        return mayCancel && cancel !== null;
      },
      Date.now() - begin >= patience,
    );
    counts.cancelled += Number(pressed);
  }
  const seen = await page.evaluate(unrest);
  const said = problems.join("; ") || "no complaint";
  throw new Error(`The page does not come to rest within ${longest / 1000} s (${said}): ${seen}`);
}

/** Runs in the page: what may be the reason that it does not come to rest. */
async function unrest(): Promise<string> {
  const frame = new Promise((resolve) => requestAnimationFrame(() => resolve(true)));
  const late = new Promise((resolve) => setTimeout(() => resolve(false), 2000));
  const text = (of: string) => [...document.querySelectorAll(of)].map((one) => one.textContent?.trim());
  return JSON.stringify({
    frames: await Promise.race([frame, late]),
    visible: document.visibilityState,
    play: document.querySelector(".play")?.ariaLabel,
    progress: text(".progress"),
    notices: text(".notice"),
  });
}

/**
 * The plant that is shown is that of the address, grown here; if the first was cancelled, there may be none. Returns 1 where
 * that could be compared.
 */
export async function comparePlant(page: Page, mayHaveNone = false): Promise<number> {
  const { state } = read(new URL(page.url()).search);
  const steps = stepsOf(state.params);
  // A plant in a hand is bent by it, one that is filmed passes through its ages, and what takes long was cancelled.
  const isElsewhere = await page.locator("[aria-pressed=true].hold, .holds, dialog[open]").count();
  if (steps > 500 || isElsewhere > 0) return 0;
  const shown = await page.locator(".readout dd").allInnerTexts();
  // As long as that is so, the page says it.
  const isSaid = mayHaveNone && (await page.locator(".notice").count()) > 0;
  if (shown.length === 0 && isSaid) return 0;
  const { report, ...plant } = history(state.params).at(state.step ?? steps);
  const { length } = measure({ report, ...plant });
  const language = await page.evaluate(() => document.documentElement.lang);
  const local = (text: string) => (/^(de|fr|es)/.test(language) ? text.replace(".", ",") : text);
  const expected = [quantityText(length, "m"), quantityText(report.gravityNumber, "")].map(local);
  const found = [shown[0]?.trim(), shown[2]?.trim().slice(0, expected[1]?.length)];
  if (found.join() !== expected.join()) {
    throw new Error(`The address says ${expected.join(", ")}, the page ${found.join(", ")}.`);
  }
  return 1;
}

/** What an address says, however it is written. */
function meaning(address: string): string {
  return write(read(new URL(address).search).state);
}

/** Undo leads back to the address before, redo to the one after. Returns 1 where there was something to undo. */
async function undoAndRedo(walker: Walker, before: string, counts: { cancelled: number }): Promise<number> {
  const { page } = walker;
  const after = page.url();
  // By their places: their names depend on the language.
  const button = (name: "Undo" | "Redo") =>
    page.locator(".masthead .actions > button").nth(name === "Undo" ? 0 : 1);
  if (await page.locator("dialog[open]").count()) return 0;
  if (!(await button("Undo").isEnabled())) return 0;
  const press = async (name: "Undo" | "Redo", address: string) => {
    if (!(await button(name).isEnabled()))
      throw new Error(`${name} of ${before} to ${after} is not offered.`);
    await button(name).evaluate((one: HTMLElement) => one.click());
    const leads = (url: URL) => meaning(url.href) === meaning(address);
    await page.waitForURL(leads, { timeout: 15_000, waitUntil: "commit" }).catch(async (error) => {
      const entry = await page.evaluate(() => JSON.stringify([window.history.state, window.history.length]));
      const offered = (await button(name).isEnabled()) ? "still offered" : "no longer offered";
      const from = name === "Undo" ? after : before;
      throw new Error(`${name} leads from ${from} not to ${address}, ${offered}, entry ${entry}`, {
        cause: error,
      });
    });
    await rest(walker, counts);
  };
  const cancelled = counts.cancelled;
  await press("Undo", before);
  // What is cancelled goes back to what was shown: another step.
  if (counts.cancelled > cancelled) return 0;
  await press("Redo", after);
  return 1;
}
