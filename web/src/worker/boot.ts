/** Starts workers with a module that the page compiles, while it arrives and beside everything else that it loads. */

import type { Begin } from "./port";

/** What gives a new worker its module: fetched and compiled for the first one, and the same for every later one. */
export function boot(address: URL): (worker: Worker) => Worker {
  let compiled: Promise<WebAssembly.Module> | null = null;
  return (worker) => {
    const begin = (module: Begin["module"]) => worker.postMessage({ module } satisfies Begin);
    compiled ??= compile(address);
    compiled.then(begin, () => {
      compiled = null;
      begin(null);
    });
    return worker;
  };
}

/** Hosts that name another type than `application/wasm` cost the streaming, not the page. */
async function compile(address: URL): Promise<WebAssembly.Module> {
  const response = await fetch(address);
  const streams = response.headers.get("content-type")?.startsWith("application/wasm") === true;
  return streams ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
