/** Work that can wait until the page has nothing else to do. */

/** Where a browser does not tell, and at most. */
const [SOON, LATEST] = [200, 2000];

/** Runs something then, or at once when the page is left or goes out of sight, from where it may never come back. */
export function whenIdle(run: () => void): void {
  const leave = new AbortController();
  const once = () => {
    if (leave.signal.aborted) return;
    leave.abort();
    run();
  };
  for (const event of ["pagehide", "visibilitychange"]) addEventListener(event, once, leave);
  if ("requestIdleCallback" in globalThis) requestIdleCallback(once, { timeout: LATEST });
  else setTimeout(once, SOON);
}
