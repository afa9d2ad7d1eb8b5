import { defineConfig } from "vite";
import { course } from "./tools/course/plugin.mjs";
import { developmentStyles } from "./tools/development-styles.mjs";
import { leanThree } from "./tools/lean-three.mjs";
import { offline } from "./tools/offline.mjs";

export default defineConfig({
  root: "web",
  publicDir: "../public",
  // Relative addresses: the site works in any folder of any host.
  base: "./",
  plugins: [leanThree(), course(), offline(), developmentStyles()],
  worker: { format: "es" },
  // tools/sizes.mjs holds the budgets, compressed; Vite's own limit is on the uncompressed chunk.
  build: {
    outDir: "../dist/site",
    emptyOutDir: true,
    chunkSizeWarningLimit: Number.POSITIVE_INFINITY,
    rolldownOptions: {
      // What comes first comes in one file: cut up by what late parts share with it, it would be larger by 4 kB.
      output: { codeSplitting: { groups: [{ name: "first", tags: ["$initial"] }] } },
    },
  },
});
