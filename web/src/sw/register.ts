// The page's side of the service worker (worker.ts): install it, once the first picture stands.

/** A page left open looks for a new version when it is looked at again, at most this often. */
const CHECK_EVERY_MS = 60 * 60 * 1000;

/**
 * Makes the site work without a network from the next visit on, and mends its copy when that has lost something. To be called once what the page is opened for is on the
 * screen: the copy for later must not compete with that.
 *
 * Does nothing on the development server, and nothing where the browser or the address (plain http) has no service
 * workers: the page works all the same, with a network.
 */
export async function registerOffline(): Promise<void> {
  if (!import.meta.env.PROD || !("serviceWorker" in navigator)) return;
  try {
    const registration = await navigator.serviceWorker.register(new URL("sw.js", document.baseURI), {
      updateViaCache: "none",
    });
    registration.active?.postMessage({ type: "pasu:idle" });
    let checked = Date.now();
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState !== "visible" || Date.now() - checked < CHECK_EVERY_MS) return;
      checked = Date.now();
      registration.update().catch(() => {
        // No network: ask again next time.
      });
    });
  } catch {
    // Private windows and locked-down browsers refuse service workers; the page works without.
  }
}
