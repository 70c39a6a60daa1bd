/** What of an address says how the pot is looked at; `viewed.ts` reads and writes it, and is fetched when there is some. */
export const VIEW_KEYS = ["view", "cut", "show", "map"] as const;

/** Whether the query of an address says any of it. */
export function saysView(search: string): boolean {
  const said = new URLSearchParams(search);
  return VIEW_KEYS.some((key) => said.has(key));
}
