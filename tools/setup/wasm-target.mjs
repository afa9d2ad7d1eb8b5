// Which Rust toolchain compiles to wasm here. Two ways lead there, and either is enough:
//   rustup   the toolchain on the PATH has the target, or rustup downloads it;
//   debian   Debian's own Rust builds the target's standard library from source, where rustup cannot download.
// BOUGH_WASM=rustup or BOUGH_WASM=debian forces one of them.

import { Obstacle } from "../obstacle.mjs";
import { isDebian } from "./apt.mjs";
import { debianIsReady, debianToolchain, installDebianToolchain } from "./debian-toolchain.mjs";
import { addTarget, hasTarget, rustupToolchain } from "./rustup-toolchain.mjs";

/**
 * @typedef {object} Toolchain
 * @property {"rustup" | "debian"} name
 * @property {string} cargo
 * @property {readonly string[]} args what cargo needs besides the target
 * @property {NodeJS.ProcessEnv} env
 */

/** @returns {string | undefined} */
export function forcedWay() {
  const { BOUGH_WASM: forced } = process.env;
  if (forced && forced !== "rustup" && forced !== "debian") {
    throw new Obstacle(`BOUGH_WASM is “${forced}”; it may be rustup or debian.`);
  }
  return forced;
}

/** @returns {Promise<Toolchain>} */
export async function findToolchain() {
  switch (forcedWay()) {
    case "rustup":
      if (!hasTarget()) await addTarget();
      return rustupToolchain();
    case "debian":
      await installDebianToolchain();
      return debianToolchain();
    default:
      return findEitherToolchain();
  }
}

/** What is here already comes first; then rustup, as the ordinary way; then Debian. */
async function findEitherToolchain() {
  if (hasTarget()) return rustupToolchain();
  if (debianIsReady()) return debianToolchain();
  try {
    await addTarget();
    return rustupToolchain();
  } catch (error) {
    if (!isDebian() || !(error instanceof Obstacle)) throw error;
    console.log(`  ${error.message}\n  Debian's Rust will do instead.`);
    await installDebianToolchain();
    return debianToolchain();
  }
}
