// What the page hears of the service worker (worker.ts): that a new version is ready. From its first moment, because another tab may be the one that installs it.

/** `then` is called when a newer version than the one on the screen has been installed; the next load of the page shows it, so all the page has to do is say so. */
export function onNewVersion(then: () => void): void {
  if (!import.meta.env.PROD || !("serviceWorker" in navigator)) return;
  navigator.serviceWorker.addEventListener("message", ({ data }: MessageEvent<unknown>) => {
    if (typeof data === "object" && data !== null && "type" in data && data.type === "pasu:new-version") then();
  });
}
