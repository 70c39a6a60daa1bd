/** Starts the real worker. The page compiles the module, while it arrives and beside everything else that it loads. */

import type { Port } from "./client";
import type { Begin } from "./messages";

let compiled: Promise<WebAssembly.Module> | null = null;

/** A worker in a file of its own that the bundler finds by this very expression. A later one is given the same module. */
export function startWorker(): Port {
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
  const response = await fetch(new URL("../../../crates/pasu-wasm/pkg/pasu_drawing_bg.wasm", import.meta.url));
  const streams = response.headers.get("content-type")?.startsWith("application/wasm") === true;
  return streams ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
