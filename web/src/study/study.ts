/**
 * The study: why a plant has the shape that it has, how it compares, and what is measured on it and fitted to. A part of the
 * page that is loaded after the first plant.
 */
import { html, render, type TemplateResult } from "lit";
import { Analyst } from "../engine/analyst.ts";
import { language } from "../language/say.ts";
import { Comparison } from "./comparison.ts";
import type { Desk, Section, Sight } from "./desk.ts";
import { Measuring } from "./measuring.ts";
import { Overlay } from "./overlay.ts";
import { Why } from "./why.ts";
import { words } from "./words.ts";
import "../style/study.css";

export class Study {
  readonly #host: HTMLElement;
  readonly #measuring: Measuring;
  readonly #sections: readonly Section[];
  readonly #overlay: Overlay | null;
  #sight: Sight | null = null;
  #renders = false;
  /** In which all is said. */
  #language = language();

  /** Lives in an element of the page that is its own. */
  constructor(host: HTMLElement, desk: Desk) {
    this.#host = host;
    const analyst = new Analyst();
    const onChange = () => this.#refresh();
    const comparison = new Comparison(desk, onChange);
    this.#measuring = new Measuring(desk, analyst, onChange);
    this.#sections = [new Why(desk, analyst, () => comparison.pinned, onChange), comparison, this.#measuring];
    this.#overlay = desk.stage ? new Overlay(desk.stage, this.#sections) : null;
    this.#refresh();
  }

  /** There is something new to look at. */
  show(sight: Sight): void {
    const isSame = this.#sight?.shape === sight.shape && this.#sight.rests === sight.rests;
    if (isSame && this.#language === language()) return;
    this.#sight = sight;
    this.#language = language();
    for (const section of this.#sections) section.see(sight);
    this.#refresh();
  }

  /** Takes a photo to trace over; false where there is no picture to lay it on. */
  take(photo: File): boolean {
    return this.#measuring.take(photo);
  }

  #refresh(): void {
    this.#overlay?.refresh();
    if (this.#renders) return;
    this.#renders = true;
    queueMicrotask(() => {
      this.#renders = false;
      render(this.#page(), this.#host);
    });
  }

  #page(): TemplateResult {
    return html`<section class="groups" aria-labelledby="study-title">
      <h2 id="study-title">${words.title}</h2>
      ${this.#sections.map(
        (
          section,
        ) => html`<details class="group ${section.name}" ?open=${section.open} @toggle=${(event: Event) => this.#toggle(section, event)}>
          <summary>${section.title}</summary>
          ${section.open && this.#sight ? section.render() : ""}
        </details>`,
      )}
    </section>`;
  }

  #toggle(section: Section, { target, currentTarget }: Event): void {
    // Those within it toggle too.
    if (target !== currentTarget) return;
    section.open = (target as HTMLDetailsElement).open;
    if (section.open && this.#sight) section.see(this.#sight);
    this.#refresh();
  }
}
