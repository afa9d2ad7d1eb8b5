// Is there a cargo, and is it new enough for the core?

import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { Obstacle } from "../obstacle.mjs";
import { rustCore } from "../paths.mjs";
import { lastLine } from "../run-command.mjs";
import { isAtLeast } from "./versions.mjs";

export function requireRust() {
  const cargo = spawnSync("cargo", ["--version"], { encoding: "utf8" });
  if (cargo.error) {
    throw new Obstacle("Bough's core is written in Rust, and there is no cargo on the PATH.", {
      remedy:
        process.platform === "win32"
          ? "winget install Rustlang.Rustup"
          : "curl --proto '=https' --tlsv1.2 -sSf https://sh.rustup.rs | sh   (then open a new terminal)",
    });
  }
  if (cargo.status !== 0) {
    throw new Obstacle(`cargo does not run: ${lastLine(cargo.stderr)}`, { remedy: "rustup default stable" });
  }
  const least = leastRust();
  if (!isAtLeast(cargo.stdout, least)) {
    throw new Obstacle(`Bough's core needs Rust ${least} or later; this is ${cargo.stdout.trim()}.`, {
      remedy: "rustup update stable",
    });
  }
}

/** The one place that names it is the workspace's `rust-version`. */
export function leastRust() {
  const manifest = readFileSync(join(rustCore, "Cargo.toml"), "utf8");
  return /^rust-version = "([\d.]+)"/m.exec(manifest)?.[1] ?? "0.0";
}
