// Serves the built site on a free port while the browser tests run; they read its address by inject("site").

import { existsSync } from "node:fs";
import { join } from "node:path";
import { preview } from "vite";
import type { TestProject } from "vitest/node";
import { site } from "../../tools/paths.mjs";

declare module "vitest" {
  interface ProvidedContext {
    site: string;
  }
}

export default async function serve(project: TestProject): Promise<() => Promise<void>> {
  if (!existsSync(join(site, "index.html")))
    throw new Error("There is no built site; `npm run build` makes it.");
  const server = await preview({ preview: { host: "127.0.0.1", port: 0 }, logLevel: "error" });
  const address = server.resolvedUrls?.local[0];
  if (!address) throw new Error("The preview server has no address.");
  project.provide("site", address);
  return () => server.close();
}
