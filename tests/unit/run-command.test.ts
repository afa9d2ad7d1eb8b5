import { expect, test } from "vitest";
import { runCommand } from "../../tools/run-command.mjs";

const node = process.execPath;

test("what a command printed comes back", async () => {
  expect(await runCommand("speaking", [node, "--print", "6 * 7"])).toBe("42\n");
});

test("a failed command keeps its output and says how it ended", async () => {
  const failed = runCommand("failing", [node, "--eval", "console.error('why'); process.exit(3)"]);
  await expect(failed).rejects.toMatchObject({
    output: "why\n",
    message: expect.stringContaining("exit code 3"),
  });
});

test("a command that does not exist fails with its name", async () => {
  await expect(runCommand("trying", ["no-such-command"])).rejects.toThrow("no-such-command");
});

test("a command beyond its time limit is ended", async () => {
  const slow = runCommand("waiting", [node, "--eval", "setTimeout(() => {}, 60000)"], { limit: 0.2 });
  await expect(slow).rejects.toThrow("took longer than 0.2 s");
});
