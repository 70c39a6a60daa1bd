/** Pots on the screen come first: those that are only near it wait until each of these has its picture, or will have none. */

const coming = new Set<object>();
let waiting: (() => void)[] = [];

/** A pot on the screen is to have a picture. */
export function comes(pot: object): void {
  coming.add(pot);
}

/** It has its picture, or will have none here. */
export function came(pot: object): void {
  if (!coming.delete(pot) || coming.size > 0) return;
  const all = waiting;
  waiting = [];
  for (const begin of all) begin();
}

/** Whether there are others to wait for; then `begin` is called after them. */
export function waitsForThoseSeen(begin: () => void): boolean {
  if (coming.size === 0) return false;
  waiting.push(begin);
  return true;
}
