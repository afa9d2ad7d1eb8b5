/** Where the analysis runs and where its wasm is: both beside the page. The build of the single file puts the wasm in here. */

/** Where the wasm is, for bundlers to see. */
export const analysisAddress = new URL("../../generated/bough-analysis.wasm", import.meta.url);

/** What the wasm can be loaded from. */
export async function analysisSource(): Promise<URL | ArrayBuffer> {
  return analysisAddress;
}

/** Opens the worker; null where there are none. */
export function openAnalysisWorker(): Worker | null {
  try {
    return new Worker(new URL("./analysis-port.ts", import.meta.url), {
      type: "module",
      name: "bough-study",
    });
  } catch {
    return null;
  }
}
