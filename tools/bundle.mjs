// Vite, with nothing taken from the configuration of the site.

/** @param {import("vite").InlineConfig} config */
export async function bundle(config) {
  const { build } = await import("vite");
  const { NODE_ENV: before } = process.env;
  try {
    await build({ configFile: false, publicDir: false, logLevel: "error", ...config });
  } finally {
    // Vite leaves “production” there, and npm would then install no development dependencies.
    if (before === undefined) delete process.env.NODE_ENV;
    else process.env.NODE_ENV = before;
  }
}
