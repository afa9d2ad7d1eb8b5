// Vite, with nothing taken from the configuration of the site.

/**
 * What was built: for builds that write no files.
 * @param {import("vite").InlineConfig} config
 */
export async function bundle(config) {
  const { build } = await import("vite");
  const { NODE_ENV: before } = process.env;
  // Whoever asks, the tests say: libraries bring other code along where it is not production.
  process.env.NODE_ENV = "production";
  try {
    return await build({ configFile: false, publicDir: false, logLevel: "error", ...config });
  } finally {
    // npm would install no development dependencies there.
    if (before === undefined) delete process.env.NODE_ENV;
    else process.env.NODE_ENV = before;
  }
}
