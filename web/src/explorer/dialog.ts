/** What opens over the page. Loaded when it is first wanted. */
import { html, render, type TemplateResult } from "lit";
import { say } from "../language/say.ts";
import { icon } from "./icons.ts";
import "../style/dialog.css";

/** Opens a dialog over the page; returns what closes it. */
export function openDialog(title: string, name: string, content: TemplateResult): () => void {
  const dialog = document.createElement("dialog");
  dialog.className = name;
  dialog.setAttribute("aria-labelledby", `${name}-title`);
  const close = () => dialog.close();
  // A click beside the dialog is one on the element itself: its content fills it.
  dialog.addEventListener("click", ({ target }) => target === dialog && close());
  dialog.addEventListener("close", () => dialog.remove());
  render(
    html`<div class="content">
      <div class="dialog-head">
        <h2 id="${name}-title">${title}</h2>
        <button type="button" class="tool" aria-label=${say("Close")} title=${say("Close")} @click=${close}>${icon("close")}</button>
      </div>
      ${content}
    </div>`,
    dialog,
  );
  document.body.append(dialog);
  dialog.showModal();
  return close;
}
