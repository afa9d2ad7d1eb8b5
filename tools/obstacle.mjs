// What a person can mend: one clear sentence and the command that mends it, instead of a stack trace.

export class Obstacle extends Error {
  /**
   * @param {string} sentence what is in the way
   * @param {{ remedy?: string | undefined, output?: string }} [more] the command that mends it; what the failed command printed
   */
  constructor(sentence, { remedy = "", output = "" } = {}) {
    super(sentence);
    this.name = "Obstacle";
    this.remedy = remedy;
    this.output = output;
  }
}

/**
 * Runs the work; an obstacle ends the process with its sentence and exit code 1. Other errors are ours and keep their stack.
 * @param {() => Promise<void>} work
 */
export async function orExplain(work) {
  try {
    await work();
  } catch (error) {
    if (!(error instanceof Obstacle)) throw error;
    if (error.output) console.error(error.output.trimEnd());
    console.error(`\n✗ ${error.message}`);
    if (error.remedy) console.error(`  This mends it:  ${error.remedy}`);
    process.exit(1);
  }
}
