// The service worker: keeps one complete copy of the site so that the designer opens without a network.
//
// A version is installed whole or not at all. A new version takes over at once, but only for pages loaded after it:
// every file with a changing content has that content's hash in its name, so a page that is already open goes on
// finding its own files in the previous copy, which is kept for that purpose.

/** Filled in by the build: every file of the site, relative to this script. */
declare const __PASU_PRECACHE__: string[];
/** Filled in by the build: a hash over all of them. */
declare const __PASU_VERSION__: string;

const worker = self as unknown as ServiceWorkerGlobalScope;
const PREFIX = `pasu:${worker.registration.scope}:`;
const CURRENT = PREFIX + __PASU_VERSION__;

worker.addEventListener("install", (event) => {
  event.waitUntil(install());
});

worker.addEventListener("activate", (event) => {
  event.waitUntil(activate());
});

worker.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(worker.registration.scope)) return;
  event.respondWith(answer(request));
});

async function install(): Promise<void> {
  const fresh = !(await caches.has(CURRENT));
  const cache = await caches.open(CURRENT);
  try {
    // The browser's own cache may hold a page of the previous version under the same name.
    await cache.addAll(__PASU_PRECACHE__.map((path) => new Request(path, { cache: "no-cache" })));
  } catch (error) {
    if (fresh) await caches.delete(CURRENT);
    throw error;
  }
  await worker.skipWaiting();
}

async function activate(): Promise<void> {
  const others = (await caches.keys()).filter((key) => key.startsWith(PREFIX) && key !== CURRENT);
  // Names come in the order of creation; the last of the others is what pages that are open now were loaded from.
  const previous = others.at(-1);
  await Promise.all(others.filter((key) => key !== previous).map((key) => caches.delete(key)));
  await worker.clients.claim();
  if (previous === undefined) return;
  for (const client of await worker.clients.matchAll({ type: "window" })) {
    client.postMessage({ type: "pasu:new-version", version: __PASU_VERSION__ });
  }
}

/** From this version's copy, then from the previous one, then from the network. */
async function answer(request: Request): Promise<Response> {
  // The page ignores its query; files do not have one.
  const options: CacheQueryOptions = { ignoreSearch: request.mode === "navigate", ignoreVary: true };
  const url = new URL(request.url);
  const key = url.pathname.endsWith("/index.html") ? new URL("./", url).href : request;
  const current = await caches.open(CURRENT);
  const kept = (await current.match(key, options)) ?? (await previousMatch(key, options));
  return kept ?? fetch(request);
}

async function previousMatch(key: string | Request, options: CacheQueryOptions): Promise<Response | undefined> {
  for (const name of await caches.keys()) {
    if (!name.startsWith(PREFIX) || name === CURRENT) continue;
    const response = await (await caches.open(name)).match(key, options);
    if (response !== undefined) return response;
  }
  return undefined;
}
