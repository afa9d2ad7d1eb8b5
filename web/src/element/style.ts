/** The widget's looks. A constructed style sheet needs no permission of the page's policy, and reaches nothing outside. */

const sheetText = `
:host {
  --paper: var(--bough-paper, light-dark(#f7f5ee, #1a1e1a));
  --paper-lit: var(--bough-paper-lit, light-dark(#fefdfa, #2c332b));
  --paper-edge: var(--bough-paper-edge, light-dark(#efebe0, #151815));
  --ink: var(--bough-ink, light-dark(#2a2a25, #e9e6da));
  --quiet: var(--bough-quiet, light-dark(#65625a, #a9a598));
  --line: var(--bough-line, light-dark(#dfdacc, #343a33));
  --accent: var(--bough-accent, light-dark(#4a6a2f, #a9c77f));
  --wash: var(--bough-wash, light-dark(#e9eedf, #2a3325));
  --warning: light-dark(#9a3412, #f5b08a);
  --warning-wash: light-dark(#fbece2, #3a271d);
  --sans: var(--bough-font, system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif);
  --serif: "Iowan Old Style", "Palatino Linotype", Palatino, "URW Palladio L", Georgia, serif;
  display: block;
  container-type: inline-size;
}
:host([hidden]) { display: none; }
*, *::before, *::after { box-sizing: border-box; }
[hidden] { display: none !important; }

figure {
  display: flex;
  flex-direction: column;
  height: 100%;
  margin: 0;
  overflow: hidden;
  border: 1px solid var(--line);
  border-radius: var(--bough-radius, 0.5rem);
  background: var(--paper);
  color: var(--ink);
  font: 0.875rem/1.4 var(--sans);
  text-align: start;
}
[data-theme="light"] { color-scheme: light; }
[data-theme="dark"] { color-scheme: dark; }
.stage {
  position: relative;
  /* Where room is short the picture gives way, to the half of it. */
  flex: 1 99 auto;
  min-height: max(5rem, 50%);
  overflow: hidden;
  aspect-ratio: var(--bough-aspect, 3 / 2);
  background: radial-gradient(ellipse 75% 80% at 50% 46%, var(--paper-lit), var(--paper) 62%, var(--paper-edge));
}
.poster, .poster img, .sapling, ::slotted([slot="poster"]), .scene, .scene > *, .enter {
  position: absolute;
  inset: 0;
  width: 100%;
  height: 100%;
}
.poster img, ::slotted([slot="poster"]) { object-fit: contain; }
.sapling { padding: 18%; fill: none; stroke: var(--line); stroke-width: 3; stroke-linecap: round; }
.scene { direction: ltr; }
.picture { touch-action: pan-y; }
.picture:focus-visible { outline-offset: -3px; }
.active .picture { cursor: grab; }
.active .picture:active { cursor: grabbing; }
.enter {
  border: 0;
  padding: 0;
  background: none;
  color: inherit;
  font: inherit;
  cursor: pointer;
  touch-action: pan-y;
}
.enter span, .leave {
  position: absolute;
  inset-block-start: 0.6rem;
  inset-inline-end: 0.6rem;
  border: 1px solid var(--line);
  border-radius: 2rem;
  padding: 0.15rem 0.7rem;
  background: var(--paper);
  font-size: 0.8125rem;
}
.enter span { opacity: 0; }
.enter:hover span, .enter:focus-visible span, .idle .enter span { opacity: 1; }
.idle .enter span {
  inset: auto;
  left: 50%;
  top: 50%;
  translate: -50% -50%;
  padding: 0.45rem 1.1rem;
  font-size: 1rem;
}
@media (hover: none) { .enter span { opacity: 1; } }
.active .enter { display: none; }
.leave { color: inherit; font: inherit; font-size: 0.8125rem; cursor: pointer; }
figure:not(.active) .leave { display: none; }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
.enter:focus-visible { outline-offset: -4px; border-radius: 0.4rem; }
.message {
  position: absolute;
  inset-block-end: 0;
  inset-inline: 0;
  max-height: 100%;
  margin: 0;
  overflow: auto;
  padding: 0.5rem 0.8rem;
  background: var(--warning-wash);
  color: var(--warning);
  overflow-wrap: anywhere;
}
.message[data-tone="info"] { background: var(--paper); color: var(--quiet); }
.message:empty { display: none; }
figcaption { padding: 0.5rem 0.8rem; border-top: 1px solid var(--line); color: var(--quiet); }
.tone { position: absolute; visibility: hidden; color: light-dark(#020304, #040302); transition: color 1ms; }

.annotation {
  overflow: visible;
  pointer-events: none;
  fill: none;
  stroke: var(--quiet);
}
.annotation text { fill: var(--ink); stroke: none; font: 0.8125rem var(--sans); }
.annotation .angle { font: italic 1rem var(--serif); dominant-baseline: middle; }
.annotation :is(.ground-line, .horizontal) { opacity: 0.6; }
.annotation .rest-direction { stroke-dasharray: 5 4; }
.annotation .future { opacity: 0.75; stroke-dasharray: 0.1 5; stroke-linecap: round; stroke-width: 1.5; }
.annotation path.break { stroke: light-dark(#9a3412, #f5b08a); stroke-width: 2.5; }
.annotation text.break { fill: light-dark(#9a3412, #f5b08a); }
.annotation .scale-bar { stroke: var(--ink); stroke-width: 1.25; }
@media print {
  .enter, .leave { display: none; }
  figure { break-inside: avoid; }
}
@media (forced-colors: active) {
  .enter span, .leave { border-color: ButtonText; }
}
`;

let sheet: CSSStyleSheet | undefined;

/** The style sheet of all widgets. */
export function sheetOfWidgets(): CSSStyleSheet {
  sheet ??= sheetOf(sheetText);
  return sheet;
}

/** A style sheet made of its text. */
export function sheetOf(text: string): CSSStyleSheet {
  const made = new CSSStyleSheet();
  made.replaceSync(text);
  return made;
}
