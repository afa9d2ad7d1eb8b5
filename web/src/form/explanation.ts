/**
 * What a parameter does, the equation that it enters, and where it comes from, in the language that is spoken.
 * Loaded when the first help is opened.
 */
import { html, nothing, type TemplateResult } from "lit";
import { help } from "../../generated/help.ts";
import { dictionary, say } from "../language/say.ts";
import { drawn, equations } from "./equations.ts";

/** The help on the parameter with this path. */
export function explanationOf(path: string): TemplateResult {
  const equation = equations[path];
  return html`<p>${helpOf(path)}</p>
    ${equation ? html`<figure><figcaption>${say(equation.caption)}</figcaption><div>${drawn(equation)}</div></figure>` : nothing}
    <p><small>${sourceOf(path)}</small></p>`;
}

function helpOf(path: string): string {
  return dictionary()?.parameters[path]?.[1] ?? help[path]?.[0] ?? "";
}

/** Where a parameter comes from, as a sentence: "Section 3.4, figure 8." */
export function sourceOf(path: string): string {
  const source = help[path]?.[1] ?? "";
  const words = dictionary()?.sources ?? {};
  const text = words[source] ?? source.replace(/[a-z]+/g, (word) => words[word] ?? word);
  return `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;
}
