/** The analysis in a worker of its own: plants go on growing while it works. */
import { answer, type Question } from "./analysis.ts";

self.addEventListener("message", async ({ data }: MessageEvent<{ id: number; question: Question }>) => {
  const { id, question } = data;
  try {
    self.postMessage({ id, finding: await answer(question) });
  } catch (error) {
    self.postMessage({ id, problem: error instanceof Error ? error.message : String(error) });
  }
});
