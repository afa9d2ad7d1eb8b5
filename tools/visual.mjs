// npm run visual: every preset in light and dark, wide and on a phone, compared with the pictures in tests/visual/golden.
// Those that differ are left in a folder of the system's for temporary files, to be looked at. With --update the pictures
// are made anew.

import { parseArgs } from "node:util";
import { orExplain } from "./obstacle.mjs";
import { setUpForTests } from "./setup.mjs";

await orExplain(async () => {
  const { update = false } = parseArgs({ options: { update: { type: "boolean" } } }).values;
  await setUpForTests();
  // Imported only now: they need the node packages.
  const { buildPlates, comparePlates, looks } = await import("./visual/plates.mjs");
  await buildPlates();
  for (const look of looks) console.log(await comparePlates(look, update));
});
