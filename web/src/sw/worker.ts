// The service worker: keeps one complete copy of the site so that the designer opens without a network.
//
// A version is installed whole or not at all. A new version takes over at once, but only for pages loaded after it:
// every file with a changing content has that content's hash in its name, so a page that is already open goes on
// finding its own files in the previous copy, which is kept for that purpose.
//
// Browsers and people empty caches. What is missing from the copy of this version is put back when it is fetched, and the
// rest when a page says that it has time for that.

/** Filled in by the build: the files of the site, relative to this script: of every browser, and of those with SIMD and without besides. */
declare const __PASU_PRECACHE__: { readonly all: string[]; readonly simd: string[]; readonly scalar: string[] };
/** Filled in by the build: a hash over all of them. */
declare const __PASU_VERSION__: string;

const SITE = __PASU_PRECACHE__;
const worker = self as unknown as ServiceWorkerGlobalScope;
const { scope } = worker.registration;
const PREFIX = `pasu:${scope}:`;
const CURRENT = PREFIX + __PASU_VERSION__;

/** Whether the engine has 128-bit SIMD, asked with the very module that the package asks with (`crates/pasu-wasm/js/wrapper.js`). */
const HAS_SIMD = WebAssembly.validate(
  // biome-ignore format: bytes
  Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11),
);

/** The addresses of the files that this browser can use. */
const FILES: ReadonlySet<string> = new Set(
  [...SITE.all, ...(HAS_SIMD ? SITE.simd : SITE.scalar)].map((path) => new URL(path, scope).href),
);

/** The page itself, whose name says nothing of its version. */
const PAGE = new URL("./", scope).href;

worker.addEventListener("install", (event) => {
  event.waitUntil(install());
});

worker.addEventListener("activate", (event) => {
  event.waitUntil(activate());
});

worker.addEventListener("message", (event) => {
  if (isIdle(event.data)) event.waitUntil(complete());
});

worker.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(scope)) return;
  event.respondWith(answer(request, (later) => event.waitUntil(later)));
});

async function install(): Promise<void> {
  const fresh = !(await caches.has(CURRENT));
  const cache = await caches.open(CURRENT);
  try {
    // The browser's own cache may hold a page of the previous version under the same name.
    await cache.addAll([...FILES].map((address) => new Request(address, { cache: "no-cache" })));
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

/** From this version's copy, then from the previous one, then from the network, which then mends the copy. */
async function answer(request: Request, later: (work: Promise<unknown>) => void): Promise<Response> {
  const address = addressOf(request);
  const current = await caches.open(CURRENT);
  const kept = (await current.match(address, { ignoreVary: true })) ?? (await previousMatch(address));
  if (kept !== undefined) return kept;
  const response = await fetch(request);
  if (FILES.has(address)) later(keep(address, response.clone()));
  return response;
}

/** What a file is kept as: a page ignores its query, and files do not have one. */
function addressOf({ url, mode }: Request): string {
  const address = new URL(url);
  address.hash = "";
  if (mode === "navigate") address.search = "";
  return address.pathname.endsWith("/index.html") ? new URL("./", address).href : address.href;
}

async function previousMatch(address: string): Promise<Response | undefined> {
  for (const name of await caches.keys()) {
    if (!name.startsWith(PREFIX) || name === CURRENT) continue;
    const response = await (await caches.open(name)).match(address, { ignoreVary: true });
    if (response !== undefined) return response;
  }
  return undefined;
}

/** Fetches what is missing. What cannot be had now is asked for again by the next page. */
async function complete(): Promise<void> {
  const cache = await caches.open(CURRENT);
  const there = new Set((await cache.keys()).map(({ url }) => url));
  for (const address of FILES) {
    if (there.has(address)) continue;
    try {
      await keep(address, await fetch(address, { cache: "no-cache" }));
    } catch {
      // No network.
    }
  }
}

/** Puts a file into this version's copy, if it is one of this version: the host may have a newer one by now. */
async function keep(address: string, response: Response): Promise<void> {
  if (!response.ok || response.redirected) return;
  if (address === PAGE && !(await isOurs(response.clone()))) return;
  await (await caches.open(CURRENT)).put(address, response);
}

/** Whether a page asks for files of this version alone. */
async function isOurs(page: Response): Promise<boolean> {
  const asked = (await page.text()).match(/\.\/assets\/[\w.-]+/g) ?? [];
  const known = [...SITE.all, ...SITE.simd];
  return asked.length > 0 && asked.every((path) => known.includes(path));
}

function isIdle(data: unknown): boolean {
  return typeof data === "object" && data !== null && "type" in data && data.type === "pasu:idle";
}
