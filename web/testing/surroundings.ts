// What a page provides, for tests without one: an address, a shelf and a place for files.

import type { Shelf } from "../src/state/storage";
import type { Surroundings } from "../src/work/keeper";

/** A shelf that holds what is in a map, and takes nothing more while it is full. */
export function shelfOf(map: Map<string, string>, full: () => boolean = () => false): Shelf {
  return {
    getItem: (key) => map.get(key) ?? null,
    setItem: (key, value) => {
      if (full()) throw new Error("the disk is full");
      map.set(key, value);
    },
    removeItem: (key) => void map.delete(key),
    key: (index) => [...map.keys()][index] ?? null,
    get length() {
      return map.size;
    },
  };
}

export class Page implements Surroundings {
  /** What follows the address, with its `#`. */
  hash = "";
  /** How often the address was written. */
  written = 0;
  readonly kept = new Map<string, string>();
  /** What this tab alone sees; it is one that has been here before. */
  readonly own = new Map([["pasu.tab", '"here"']]);
  readonly files: { readonly name: string; readonly text: Promise<string> }[] = [];
  /** A browser that stores nothing. */
  full = false;

  readonly shelf = shelfOf(this.kept, () => this.full);
  readonly tabShelf = shelfOf(this.own, () => this.full);
  /** The tabs that are open. */
  open = new Set<string>();
  readonly claim = async (tab: string) => {
    if (this.open.has(tab)) return false;
    this.open.add(tab);
    return true;
  };
  readonly address = () => "https://pasu.example/designer/";
  readonly fragment = () => this.hash;
  /** Browsers refuse after a hundred changes in half a minute. */
  refuses = false;
  readonly writeFragment = (link: string) => {
    if (this.refuses) return;
    this.hash = link === "" ? "" : `#${link}`;
    this.written += 1;
  };
  /** What waits until the page is idle; at once where a test does not hold it. */
  waiting: (() => void)[] | null = null;
  readonly whenIdle = (run: () => void) => {
    if (this.waiting) this.waiting.push(run);
    else run();
  };
  readonly download = (file: Blob, name: string) => {
    this.files.push({ name, text: file.text() });
  };
}
