/**
 * What every consumer does with the package that it installed; how it was imported is what differs. Grows every preset,
 * and one plant by each entry. What is returned is compared, line by line.
 */
import { fingerprint } from "./fingerprint.js";

/** Takes the three entries, and what startEngine and startPool need in this place. */
export async function consume({ bough, inline, worker, source, options }) {
  const lines = [];
  await bough.init(source);
  for (const [id, { params, step = Number.POSITIVE_INFINITY }] of Object.entries(bough.presets)) {
    lines.push(`${id} ${fingerprint(bough.history(params).at(step))}`);
  }
  const [[, { params, step = null }]] = Object.entries(bough.presets);
  await inline.init();
  lines.push(`inline ${fingerprint(inline.history(params).at(step ?? Number.POSITIVE_INFINITY))}`);
  const engine = await worker.startEngine(options);
  lines.push(`engine in ${engine.transport} ${fingerprint(await engine.plant(params, step))}`);
  engine.dispose();
  const pool = await worker.startPool({ ...options, size: 2 });
  const grown = await Promise.all([1, 2, 3].map(() => pool.plant(params, step)));
  lines.push(`pool in ${pool.transport} ${grown.map(fingerprint).join(" ")}`);
  const refused = await pool.plant({ axis: { segments: 0 } }).catch((error) => error);
  lines.push(`refused ${refused instanceof worker.BoughError} ${refused.issues[0].path}`);
  pool.dispose();
  return lines.join("\n");
}
