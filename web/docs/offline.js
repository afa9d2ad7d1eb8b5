// Keeps the docs for readers without a network: what is newest on the server goes before, what was kept stands in for it.
// `kept` is written before this by the build: the name of the present docs, and their files.

self.addEventListener("install", (event) => {
  event.waitUntil(caches.open(kept.name).then((cache) => cache.addAll(kept.files)));
  self.skipWaiting();
});

self.addEventListener("activate", (event) => {
  const isOld = (name) => name.startsWith("bough-docs-") && name !== kept.name;
  const clean = async () => {
    for (const name of (await caches.keys()).filter(isOld)) await caches.delete(name);
    await self.clients.claim();
  };
  event.waitUntil(clean());
});

self.addEventListener("fetch", (event) => {
  if (event.request.method !== "GET" || !event.request.url.startsWith(self.registration.scope)) return;
  const fromHere = () => caches.match(event.request, { ignoreSearch: true, ignoreVary: true });
  event.respondWith(fetch(event.request).catch(async () => (await fromHere()) ?? Response.error()));
});
