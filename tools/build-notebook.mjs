// The code of the notebook's widget: one module with everything inside, as anywidget loads it from anywhere.

import { join } from "node:path";
import { wholeWidget } from "./build-widget.mjs";
import { bundle } from "./bundle.mjs";
import { root } from "./paths.mjs";

export async function buildNotebook() {
  await bundle({
    root: join(root, "web"),
    plugins: wholeWidget(),
    build: {
      outDir: join(root, "python", "src", "bough_plant", "static"),
      emptyOutDir: true,
      chunkSizeWarningLimit: Number.POSITIVE_INFINITY,
      lib: {
        entry: join(root, "web", "src", "notebook", "main.ts"),
        formats: ["es"],
        fileName: () => "plant.js",
      },
      rollupOptions: { output: { codeSplitting: false } },
    },
  });
}
