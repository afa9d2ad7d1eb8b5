// The paper's way to equilibrium, over Newton's, on the same rod to the same residual.

import { kernels } from "../hosts.mjs";
import { interleaved } from "../samples.mjs";
import { digits } from "../table.mjs";
import { timer } from "./kernels.mjs";

/** @param {import("../bench.mjs").Bench} bench */
export async function relaxationRows({ table, effort, hosts, quick }) {
  table.heading("The paper's Euler relaxation (equations 12 to 20), native, same rod, residual 1e-6");
  const [native] = hosts;
  /** @type {{ size: number, seconds: number } | undefined} */
  let last;
  for (const size of quick ? [20] : [20, 100]) {
    const newton = timer(native, kernels.solve, size);
    const own = timer(native, kernels.relaxation, size);
    const [ours = [], relaxed = []] = await interleaved([newton, own], effort);
    const over = [{ name: "Newton", samples: ours }];
    const what = `rod of ${size}`;
    const steps = `${own.found.iterations} steps`;
    table.row({ what, who: "each joint its own damping", samples: relaxed, unit: "s", over, note: steps });
    // Half a minute at 100: once will do.
    await native.prepare(kernels.paper, size);
    const { seconds, iterations } = await native.run(1);
    const paper = { who: "one damping for all joints", samples: [seconds], unit: "s", over };
    table.row({ what, ...paper, note: `${iterations} steps` });
    last = { size, seconds };
  }
  if (!last || quick) return;
  const hours = (last.seconds * (1000 / last.size) ** 4) / 3600;
  const note = `about ${digits(hours)} hours, estimated: steps grow like n^3, work like n^4`;
  table.row({ what: "rod of 1000", who: "one damping for all joints", note });
}
