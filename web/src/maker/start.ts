/** Starts the maker's worker. The whole module is fetched and compiled by the first and given to every later one. */

import type { Port } from "./client";
import type { Begin } from "./messages";

let compiled: Promise<WebAssembly.Module> | null = null;

export function startMaker(): Port {
  const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
  const begin = (module: Begin["module"]) => worker.postMessage({ module } satisfies Begin);
  compiled ??= compile();
  compiled.then(begin, () => {
    compiled = null;
    begin(null);
  });
  return worker;
}

/** Hosts that name another type than `application/wasm` cost the streaming, not the page. */
async function compile(): Promise<WebAssembly.Module> {
  const response = await fetch(new URL("../../../crates/pasu-wasm/pkg/pasu_bg.wasm", import.meta.url));
  const streams = response.headers.get("content-type")?.startsWith("application/wasm") === true;
  return streams ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
