/** What of an address says how the pot is looked at; `viewed.ts` reads and writes it, and is fetched when there is some. */
export const VIEW_KEYS = ["view", "cut", "show", "map"] as const;
