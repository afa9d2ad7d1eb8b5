// Keeps the files of one version of Bough, and answers with them. A newer version is fetched beside it, and takes over once
// no page of the old one is open: a page never mixes two. Everything else, the pages for frames say, goes to the network.

const cacheName = "bough-page-VERSION";
const files = "FILES";
const kept = new Set(files.map((file) => new URL(file, self.registration.scope).href));

self.addEventListener("install", (event) => {
  // What the browser has already is not fetched again: names are of what is in the files.
  const requests = files.map(
    (file) => new Request(file, { cache: file.startsWith("assets/") ? "default" : "no-cache" }),
  );
  event.waitUntil(caches.open(cacheName).then((cache) => cache.addAll(requests)));
});

self.addEventListener("activate", (event) => {
  const drop = async () => {
    const names = await caches.keys();
    const old = names.filter((name) => name.startsWith("bough-page-") && name !== cacheName);
    await Promise.all(old.map((name) => caches.delete(name)));
  };
  event.waitUntil(drop());
});

self.addEventListener("fetch", (event) => {
  const { request } = event;
  const address = new URL(request.url);
  // The page is the same whatever its link says.
  address.search = "";
  address.hash = "";
  if (request.method !== "GET" || !kept.has(address.href)) return;
  const answer = async () => {
    const cache = await caches.open(cacheName);
    return (await cache.match(address.href)) ?? fetch(request);
  };
  event.respondWith(answer());
});
