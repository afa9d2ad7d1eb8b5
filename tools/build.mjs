// npm run build: set-up, then the site in dist/site and the npm package in dist/package.

import { buildPackage } from "./build-package.mjs";
import { buildSite } from "./build-site.mjs";
import { orExplain } from "./obstacle.mjs";
import { setUp } from "./setup.mjs";

await orExplain(async () => {
  await setUp();
  await buildSite();
  await buildPackage();
});
