// What a page provides, for tests without one: an address, a shelf and a place for files.

import type { Surroundings } from "../src/work/keeper";

export class Page implements Surroundings {
  /** What follows the address, with its `#`. */
  hash = "";
  /** How often the address was written. */
  written = 0;
  readonly kept = new Map<string, string>();
  readonly files: { readonly name: string; readonly text: Promise<string> }[] = [];
  /** A browser that stores nothing. */
  full = false;

  readonly shelf = {
    getItem: (key: string) => this.kept.get(key) ?? null,
    setItem: (key: string, value: string) => {
      if (this.full) throw new Error("the disk is full");
      this.kept.set(key, value);
    },
  };
  readonly address = () => "https://pasu.example/designer/";
  readonly fragment = () => this.hash;
  readonly writeFragment = (link: string) => {
    this.hash = `#${link}`;
    this.written += 1;
  };
  readonly download = (file: Blob, name: string) => {
    this.files.push({ name, text: file.text() });
  };
}
