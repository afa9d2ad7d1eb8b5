// Version numbers as tools print them ("v20.19.1", "cargo 1.95.0 (f2d3ce0bd 2026-03-21)"), and which Node will do.

/**
 * @param {string} text
 * @returns {[major: number, minor: number] | undefined}
 */
export function parseVersion(text) {
  const match = /(\d+)\.(\d+)/.exec(text);
  return match ? [Number(match[1]), Number(match[2])] : undefined;
}

/**
 * @param {string} version
 * @param {string} least
 */
export function isAtLeast(version, least) {
  const [major, minor] = parseVersion(version) ?? [0, 0];
  const [leastMajor, leastMinor] = parseVersion(least) ?? [0, 0];
  return major > leastMajor || (major === leastMajor && minor >= leastMinor);
}

/**
 * Vite needs `require` of ES modules, which came to Node in 20.19 and 22.12; the odd line between them never got it.
 * @param {string} version
 */
export function nodeWillDo(version) {
  const [major = 0] = parseVersion(version) ?? [];
  return major === 20 ? isAtLeast(version, "20.19") : isAtLeast(version, "22.12");
}
