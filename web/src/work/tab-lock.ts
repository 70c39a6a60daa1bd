/** A tab's name is held by a Web Lock, which the browser takes back from a page that is closed, reloaded or dies. */

import type { Claim } from "./seat";

export const claimTab: Claim = (tab, patience = 0) => {
  // Only pages of a secure context have them.
  const locks: LockManager | undefined = navigator.locks;
  if (!locks) return Promise.resolve(null);
  const options = patience > 0 ? { signal: AbortSignal.timeout(patience) } : { ifAvailable: true };
  return new Promise((settle) => {
    const hold = (lock: Lock | null) => {
      settle(lock !== null);
      // Never given back: the page has it as long as it lives.
      return lock === null ? null : new Promise<null>(() => {});
    };
    locks.request(`pasu.tab.${tab}`, options, hold).catch((error: unknown) => {
      settle(error instanceof DOMException && error.name === "TimeoutError" ? false : null);
    });
  });
};
