// Pasu for Node, where fetch() does not read files.

import { readFile } from "node:fs/promises";
import load from "./pasu.js";

export * from "./pasu.js";

export default function init(source) {
  return load(source ?? (() => readFile(new URL("./pasu_bg.wasm", import.meta.url))));
}
