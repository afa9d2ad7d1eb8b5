// The folders that the tools read and write.

import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = dirname(dirname(fileURLToPath(import.meta.url)));
export const rustCore = join(root, "rust-core");
export const generated = join(root, "web", "generated");
export const site = join(root, "dist", "site");
export const packageFolder = join(root, "dist", "package");
