// The course in Vite: its pages are made when the site is built, and anew at each visit while somebody writes at them.

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { stylesheet } from "../stylesheet.mjs";
import { builtScripts, courseFolder, coursePages } from "./pages.mjs";

const sources = ["element/module.ts", "course/main.ts"];
const sourceScripts = sources.map((file) => `<script type="module" src="/src/${file}"></script>`).join("\n");

/** @returns {import("vite").Plugin} */
export function course() {
  return {
    name: "bough-course",
    configureServer: ({ middlewares, transformIndexHtml }) => {
      middlewares.use("/course", async ({ url = "/" }, response, next) => {
        const name = new URL(url, "http://course").pathname.slice(1) || "index.html";
        const html = name.endsWith(".html") ? coursePages(sourceScripts).get(name) : undefined;
        if (html === undefined) return next();
        response.setHeader("content-type", "text/html");
        response.end(await transformIndexHtml(`/course/${name}`, html));
      });
    },
    generateBundle() {
      const emit = (/** @type {string} */ file, /** @type {string | Uint8Array} */ source) =>
        this.emitFile({ type: "asset", fileName: `course/${file}`, source });
      for (const [file, html] of coursePages(builtScripts)) emit(file, html);
      emit("course.css", stylesheet(join(courseFolder, "course.css")));
      for (const poster of readdirSync(join(courseFolder, "posters"))) {
        emit(`posters/${poster}`, readFileSync(join(courseFolder, "posters", poster)));
      }
    },
  };
}
