/** Work that can wait until the page has nothing else to do. */

/** Where a browser does not say when that is, and at most: in milliseconds. */
const LATEST = 500;

const waiting = new Set<() => void>();

/** Runs something then, or at once when the page is left or goes out of sight, from where it may never come back. */
export function whenIdle(run: () => void): void {
  waiting.add(run);
  const later = globalThis.requestIdleCallback ?? ((then: () => void) => setTimeout(then, LATEST));
  later(() => done(run), { timeout: LATEST });
}

function done(run: () => void): void {
  if (waiting.delete(run)) run();
}

for (const event of ["pagehide", "visibilitychange"]) globalThis.addEventListener?.(event, () => waiting.forEach(done));
