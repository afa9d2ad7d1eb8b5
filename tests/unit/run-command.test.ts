import { spawn } from "node:child_process";
import { once } from "node:events";
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

test("a command ends with the process that runs it", { timeout: 20_000 }, async () => {
  const address = new URL("../../tools/run-command.mjs", import.meta.url).href;
  const waiting = [node, "--eval", "console.log('waits'); setInterval(() => {}, 1000)"];
  const script = `import { runCommand } from "${address}";
    await runCommand("waiting", ${JSON.stringify(waiting)}, { show: true });`;
  const outer = spawn(node, ["--input-type=module", "--eval", script], {
    stdio: ["ignore", "pipe", "inherit"],
  });
  const closed = once(outer, "close");
  for await (const text of outer.stdout) {
    if (String(text).includes("waits")) outer.kill("SIGTERM");
  }
  // The pipe is the command's too: it closes when both have ended.
  expect(await closed).toEqual([null, "SIGTERM"]);
});
