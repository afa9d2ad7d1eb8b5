import { parentPort } from "node:worker_threads";

parentPort.on("message", ({ step }) => {
  if (step === 13) process.exit(7);
});
