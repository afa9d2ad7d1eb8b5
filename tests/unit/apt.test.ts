import { expect, test } from "vitest";
import type { Obstacle } from "../../tools/obstacle.mjs";
import { aptInstall } from "../../tools/setup/apt.mjs";

test("who is not root is told the command instead of being failed by it", async () => {
  const refused = aptInstall("installing a browser", ["no-such-package", "nor-this"], false);
  await expect(refused).rejects.toMatchObject({
    message: "installing a browser takes root, to install Debian's packages no-such-package nor-this.",
    remedy: "sudo apt-get install no-such-package nor-this",
  } satisfies Partial<Obstacle>);
});
