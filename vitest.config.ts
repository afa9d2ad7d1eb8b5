import { defineConfig } from "vitest/config";
import { BaseSequencer, type Reporter, type TestCase, type TestSpecification } from "vitest/node";

/** The file that takes longest begins first: begun last, it would run on alone while other cores have nothing to do. */
class LongestFirst extends BaseSequencer {
  override async sort(files: TestSpecification[]): Promise<TestSpecification[]> {
    const isLongest = ({ moduleId }: TestSpecification) => Number(moduleId.endsWith("walk.test.ts"));
    return (await super.sort(files)).toSorted((one, other) => isLongest(other) - isLongest(one));
  }
}

/** What fails once and passes at the second try says why it failed. */
const whyRetried: Reporter = {
  onTestCaseResult(test: TestCase) {
    if (!test.diagnostic()?.flaky) return;
    for (const { message } of test.result().errors ?? []) console.log(`Retried: ${test.name}: ${message}`);
  },
};

export default defineConfig({
  test: {
    reporters: ["default", whyRetried],
    sequence: { sequencer: LongestFirst },
    projects: [
      {
        test: {
          name: "unit",
          include: ["tests/{unit,contract}/**/*.test.ts", "tests/course/*.test.ts"],
          // Thousands of random cases take a second or two, and many more on a busy machine.
          testTimeout: 120_000,
        },
      },
      {
        test: {
          // What takes too long for every check: npm run soak.
          name: "soak",
          include: ["tests/{browser,element}/**/*.soak.ts"],
          globalSetup: "tests/browser/serve.ts",
          testTimeout: 3_600_000,
        },
      },
      {
        test: {
          name: "browser",
          include: ["tests/{browser,element}/**/*.test.ts", "tests/course/pages/*.test.ts"],
          globalSetup: "tests/browser/serve.ts",
          // WebGL is computed on the CPU here: two pages at a time, one waits while the other draws, and time enough for slow
          // machines.
          maxWorkers: 2,
          testTimeout: 120_000,
          hookTimeout: 120_000,
          // A page that was too slow is given another try, and said to be flaky; what fails twice fails.
          retry: 1,
        },
      },
    ],
  },
});
