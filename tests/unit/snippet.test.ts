import { describe, expect, it } from "vitest";
import { frameAddress, snippet, type Wishes } from "../../web/src/explorer/snippet.ts";
import { read } from "../../web/src/params/link.ts";
import { complete } from "../../web/src/params/params.ts";
import { initialState, presetState, type State } from "../../web/src/params/state.ts";

const site = "https://plants.example/bough/?v=1&g=2";
const wishes: Wishes = {
  form: "iframe",
  width: 640,
  height: 420,
  theme: "dark",
  controls: "compact",
  poster: false,
  title: "A branch",
};
const lunar: State = {
  ...initialState,
  ...presetState("figure-13a"),
  params: complete({ ...presetState("figure-13a").params, loads: { gravity: 1.62 } }),
  color: "moment",
};

describe("for an LMS", () => {
  it("is a frame with a link under it, as such hosts leave it in place", () => {
    expect(snippet(initialState, site, wishes)).toBe(
      `<iframe src="https://plants.example/bough/embed.html?v=1&amp;theme=dark&amp;ui=compact" width="640" height="420" title="A branch" allowfullscreen loading="lazy"></iframe>\n` +
        `<p><a href="https://plants.example/bough/?v=1">A branch</a></p>`,
    );
    expect(snippet(lunar, site, wishes)).not.toMatch(/script|style|aspect-ratio/);
  });

  it("shows exactly the state", () => {
    const { state } = read(new URL(frameAddress(lunar, site, wishes)).search);
    expect(state).toEqual({ ...lunar, theme: "dark" });
  });
});

describe("for one's own page", () => {
  it("names the preset, what differs from it as JSON that stays readable, and how it is looked at", () => {
    const text = snippet(lunar, site, { ...wishes, form: "element", poster: true });
    expect(text).toContain(`<script async src="https://plants.example/bough/bough-widget.js"></script>`);
    expect(text).toContain(`preset="figure-13a" params='{"loads":{"gravity":1.62}}' color="moment"`);
    expect(text).toContain(
      `controls="compact" theme="dark" poster="plant.webp" loading="click" alt="A branch"`,
    );
    expect(text).toContain("width: 640px; max-width: 100%; height: 420px");
  });

  it("says no more than is needed", () => {
    const text = snippet(initialState, site, { ...wishes, form: "element" });
    for (const word of ["preset", "params", "step", "view", "color", "drawing", "poster"]) {
      expect(text).not.toContain(`${word}=`);
    }
  });

  it("names another age, full age where the preset is younger, and the model", () => {
    const form = "element";
    expect(snippet({ ...initialState, step: 7 }, site, { ...wishes, form })).toContain(`step="7"`);
    expect(snippet({ ...lunar, step: null, style: "model" }, site, { ...wishes, form })).toMatch(
      /step="full" .*drawing="model"/,
    );
  });
});

it.each(["iframe", "element"] as const)("no title breaks out of the %s", (form) => {
  const title = `"><script>alert('1')</script> & it's`;
  const text = snippet(initialState, site, { ...wishes, form, title });
  expect(text).not.toContain("<script>alert");
  expect(text.match(/<\/?[a-z-]+/g)).toEqual(
    form === "iframe"
      ? ["<iframe", "</iframe", "<p", "<a", "</a", "</p"]
      : ["<script", "</script", "<bough-plant", "</bough-plant"],
  );
});
