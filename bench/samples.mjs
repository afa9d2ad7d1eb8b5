// Samples that can be compared: contenders take turns, so that whatever else the machine does meets all of them.

/**
 * @typedef {object} Contender
 * @property {(rounds: number) => Promise<number>} time seconds that so many rounds take
 *
 * @typedef {object} Effort
 * @property {number} repeats samples of each contender
 * @property {number} least seconds that a sample takes at least: shorter ones say more of the clock than of the work
 */

/**
 * Seconds a round of each contender, sample by sample: the i-th samples of all were taken next to each other.
 * @param {readonly Contender[]} contenders
 * @param {Effort} effort
 * @returns {Promise<number[][]>}
 */
export async function interleaved(contenders, { repeats, least }) {
  const rounds = [];
  for (const contender of contenders) rounds.push(await enough(contender, least));
  const samples = contenders.map(() => /** @type {number[]} */ ([]));
  for (let repeat = 0; repeat < repeats; repeat++) {
    for (const [i, { time }] of contenders.entries()) {
      const count = rounds[i] ?? 1;
      samples[i]?.push((await time(count)) / count);
    }
  }
  return samples;
}

/** Of a sample: so long code runs first, until it is compiled for speed. */
const warmUp = 5;

/**
 * How many rounds fill a sample.
 * @param {Contender} contender
 * @param {number} least
 */
async function enough({ time }, least) {
  let rounds = 1;
  let ran = 0;
  for (;;) {
    const seconds = await time(rounds);
    ran += seconds;
    if (seconds < least)
      rounds *= Math.ceil(Math.min(10, Math.max(2, (1.2 * least) / Math.max(seconds, 1e-9))));
    else if (ran >= warmUp * least) return rounds;
  }
}

/** @param {readonly number[]} samples */
export function summary(samples) {
  const sorted = samples.toSorted((a, b) => a - b);
  const middle = sorted.length >> 1;
  const [before = 0, at = 0] = [sorted[middle - 1], sorted[middle]];
  return {
    median: sorted.length % 2 === 1 ? at : (before + at) / 2,
    min: sorted[0] ?? Number.NaN,
    max: sorted.at(-1) ?? Number.NaN,
  };
}

/**
 * Sample by sample; a contender that was timed once is compared with all samples of the other.
 * @param {readonly number[]} samples
 * @param {readonly number[]} others
 */
export function ratios(samples, others) {
  const count = Math.max(samples.length, others.length);
  const at = (/** @type {readonly number[]} */ list, /** @type {number} */ i) =>
    list[i % list.length] ?? Number.NaN;
  return Array.from({ length: count }, (_, i) => at(samples, i) / at(others, i));
}
