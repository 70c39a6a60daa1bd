/** Starts workers with a module that the page compiles, while it arrives and beside everything else that it loads. */

import type { Begin } from "./port";

/** Modules that a worker asks for only in some browsers, or for some designs: where its own file is no guide to them, because a bundler has put it elsewhere. */
export interface Others {
  /** For engines of before 2023. */
  readonly scalar: URL;
  readonly whole?: URL;
}

/** What gives a new worker its module: fetched and compiled for the first one, and the same for every later one. */
export function boot(address: URL, others?: Others): (worker: Worker) => Worker {
  let compiled: Promise<WebAssembly.Module> | null = null;
  const whole = others?.whole ? { whole: others.whole.href } : {};
  return (worker) => {
    const begin = (module: Begin["module"]) => worker.postMessage({ module, ...whole } satisfies Begin);
    compiled ??= compile(address).catch((error) => {
      if (others && error instanceof WebAssembly.CompileError) return compile(others.scalar);
      throw error;
    });
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
