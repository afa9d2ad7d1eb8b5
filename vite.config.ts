import { defineConfig } from "vite";
import { course } from "./tools/course/plugin.mjs";
import { leanThree } from "./tools/lean-three.mjs";

export default defineConfig({
  root: "web",
  publicDir: "../public",
  // Relative addresses: the site works in any folder of any host.
  base: "./",
  plugins: [leanThree(), course()],
  worker: { format: "es" },
  // tools/sizes.mjs holds the budgets, compressed; Vite's own limit is on the uncompressed chunk.
  build: { outDir: "../dist/site", emptyOutDir: true, chunkSizeWarningLimit: Number.POSITIVE_INFINITY },
});
