// Servers for consumers in browsers: a folder as it lies there, or the consumer's own command.

import { spawn } from "node:child_process";
import { createReadStream, readFileSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { Obstacle } from "../obstacle.mjs";

/** @type {Record<string, string>} */
const types = {
  ".css": "text/css",
  ".html": "text/html",
  ".js": "text/javascript",
  ".json": "application/json",
  ".wasm": "application/wasm",
};

/**
 * @typedef {object} Server
 * @property {string} address
 * @property {() => void} close
 */

/**
 * Serves the files of a folder, as any static host would.
 * @param {string} folder
 * @returns {Promise<Server>}
 */
export function serveFolder(folder) {
  const server = createServer(({ url = "/" }, response) => {
    const path = normalize(decodeURIComponent(new URL(url, "http://localhost").pathname));
    const file = join(folder, path.endsWith("/") ? `${path}index.html` : path);
    if (!statSync(file, { throwIfNoEntry: false })?.isFile()) {
      response.writeHead(404).end();
      return;
    }
    response.setHeader("content-type", types[extname(file)] ?? "application/octet-stream");
    createReadStream(file).pipe(response);
  });
  return new Promise((resolve) => {
    server.listen(0, "127.0.0.1", () => {
      const place = server.address();
      const port = typeof place === "object" ? place?.port : "";
      resolve({ address: `http://127.0.0.1:${port}/`, close: () => server.close() });
    });
  });
}

/**
 * Runs the script "serve" of a consumer's package.json, without a shell in between: what is started can be ended.
 * @param {string} folder
 * @returns {Promise<Server>}
 */
export function serveBy(folder) {
  const [command = "", ...args] = manifest(folder).scripts.serve.split(" ");
  const { bin } = manifest(join(folder, "node_modules", command));
  const script = join(folder, "node_modules", command, typeof bin === "string" ? bin : bin[command]);
  const child = spawn(process.execPath, [script, ...args], {
    cwd: folder,
    env: { ...process.env, NO_COLOR: "1" },
  });
  const close = () => void child.kill();
  return new Promise((resolve, reject) => {
    let output = "";
    const fail = (/** @type {string} */ how) => {
      close();
      reject(new Obstacle(`${command} ${how}.`, { output }));
    };
    const timer = setTimeout(() => fail("did not say its address within a minute"), 60_000);
    child.on("exit", (code) => fail(`ended with exit code ${code}`));
    for (const stream of [child.stdout, child.stderr]) {
      stream.setEncoding("utf8").on("data", (text) => {
        output += text;
        const [address] = /http:\/\/127\.0\.0\.1:\d+/.exec(output) ?? [];
        if (!address) return;
        clearTimeout(timer);
        child.removeAllListeners("exit");
        resolve({ address: `${address}/`, close });
      });
    }
  });
}

/** @param {string} folder */
function manifest(folder) {
  return JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
}
