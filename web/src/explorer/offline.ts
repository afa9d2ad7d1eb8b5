/** Keeps the page for times without a network. Loaded last. */

/** Has the browser keep every file of the page, where it can: not from a file, and not while the page is being developed. */
export async function keepOffline(): Promise<void> {
  if (!import.meta.env.PROD || !("serviceWorker" in navigator) || !location.protocol.startsWith("http"))
    return;
  // Without it, in a private window say, the page just needs its network.
  await navigator.serviceWorker.register("service-worker.js").catch(() => undefined);
}
