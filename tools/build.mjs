// npm run build: set-up, then the site in dist/site, the npm package in dist/package, and the notebook's widget in python/.

import { buildNotebook } from "./build-notebook.mjs";
import { buildPackage } from "./build-package.mjs";
import { buildSite } from "./build-site.mjs";
import { orExplain } from "./obstacle.mjs";
import { setUp } from "./setup.mjs";

await orExplain(async () => {
  await setUp();
  await buildSite();
  await buildPackage();
  await buildNotebook();
});
