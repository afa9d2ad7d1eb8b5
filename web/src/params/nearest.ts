/** Which name was meant? */

/** The candidate with the fewest typing errors, ignoring case, if it is near enough to be meant. */
export function nearest(word: string, candidates: readonly string[]): string | undefined {
  let best: string | undefined;
  let fewest = Math.max(2, Math.floor(word.length / 3)) + 1;
  for (const candidate of candidates) {
    // A name cannot be near when the lengths are not; this also bounds the work for absurdly long words.
    if (Math.abs(candidate.length - word.length) >= fewest) continue;
    const errors = distance(word.toLowerCase(), candidate.toLowerCase());
    if (errors < fewest && errors < candidate.length) [best, fewest] = [candidate, errors];
  }
  return best;
}

/** How many letters must be added, dropped or changed to make one word of the other (Levenshtein). */
function distance(from: string, to: string): number {
  let row = Array.from({ length: to.length + 1 }, (_, column) => column);
  for (const [index, letter] of [...from].entries()) {
    const next = [index + 1];
    for (let column = 1; column <= to.length; column++) {
      const changed = (row[column - 1] ?? 0) + (letter === to[column - 1] ? 0 : 1);
      next.push(Math.min(changed, (row[column] ?? 0) + 1, (next[column - 1] ?? 0) + 1));
    }
    row = next;
  }
  return row[to.length] ?? 0;
}
