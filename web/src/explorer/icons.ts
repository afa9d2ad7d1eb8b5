/** The page's icons: strokes on a 20 x 20 grid, in the colour of the text around. */
import { html, type TemplateResult } from "lit";

const paths = {
  undo: "M7 4 3.5 7.5 7 11M4 7.5h7.5a4.5 4.5 0 0 1 0 9H8",
  redo: "M13 4l3.5 3.5L13 11M16 7.5H8.5a4.5 4.5 0 0 0 0 9H12",
  link: "M8.5 11.5a3.2 3.2 0 0 0 4.6 0l2.6-2.6a3.25 3.25 0 0 0-4.6-4.6l-1 1M11.5 8.5a3.2 3.2 0 0 0-4.6 0l-2.6 2.6a3.25 3.25 0 0 0 4.6 4.6l1-1",
  auto: "M10 3.5a6.5 6.5 0 1 0 0 13zM10 3.5a6.5 6.5 0 0 1 0 13",
  light:
    "M10 6.8a3.2 3.2 0 1 0 0 6.4 3.2 3.2 0 0 0 0-6.4M10 2v1.8M10 16.2V18M2 10h1.8M16.2 10H18M4.3 4.3l1.3 1.3M14.4 14.4l1.3 1.3M15.7 4.3l-1.3 1.3M5.6 14.4l-1.3 1.3",
  dark: "M16.2 12.2A6.7 6.7 0 0 1 7.8 3.8a6.7 6.7 0 1 0 8.4 8.4z",
  play: "M6.5 4.2v11.6l9-5.8z",
  pause: "M7 4.5v11M13 4.5v11",
  back: "M12.5 4.5 7 10l5.5 5.5M4.5 4.5v11",
  forward: "M7.5 4.5 13 10l-5.5 5.5M15.5 4.5v11",
  loads: "M10 3v8M6.8 8.2 10 11.4l3.2-3.2M4 16h12",
  hand: "M6 10.5V5.2a1.2 1.2 0 0 1 2.4 0V9V3.7a1.2 1.2 0 0 1 2.4 0V9V4.7a1.2 1.2 0 0 1 2.4 0V10V6.7a1.2 1.2 0 0 1 2.4 0v5.1a5 5 0 0 1-5 5c-2.3 0-3.5-1-4.6-2.9l-1.9-3.2a1.15 1.15 0 0 1 2-1.2z",
  keys: "M2.5 5.5h15v9h-15zM5.5 8.5h.01M8.5 8.5h.01M11.5 8.5h.01M14.5 8.5h.01M7 11.7h6",
  save: "M10 3v9M6.5 8.7 10 12.2l3.5-3.5M4 13.5V17h12v-3.5",
  language:
    "M10 2.8a7.2 7.2 0 1 0 0 14.4 7.2 7.2 0 0 0 0-14.4M2.8 10h14.4M10 2.8c2 2.2 3 4.6 3 7.2s-1 5-3 7.2c-2-2.2-3-4.6-3-7.2s1-5 3-7.2",
  embed: "M7 6 3 10l4 4M13 6l4 4-4 4",
  course: "M10 5.5C8 4 5.5 4 3 4.5v10.5c2.5-.5 5-.5 7 1 2-1.5 4.5-1.5 7-1V4.5c-2.5-.5-5-.5-7 1zV16",
  closer: "M10 5v10M5 10h10",
  farther: "M5 10h10",
  fit: "M3.5 7.5v-4h4M12.5 3.5h4v4M16.5 12.5v4h-4M7.5 16.5h-4v-4",
  close: "M5.5 5.5l9 9M14.5 5.5l-9 9",
} as const;

export type Icon = keyof typeof paths;

/** An icon; whatever it stands for must be said in words beside it. */
export function icon(name: Icon): TemplateResult {
  return html`<svg class="icon ${name}" viewBox="0 0 20 20" aria-hidden="true"><path d=${paths[name]} /></svg>`;
}
