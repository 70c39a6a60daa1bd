/** Starts a worker whose file may lie elsewhere than the page: of another origin browsers start none, but modules that are imported may be of any. */

import type { Refusal } from "../document/types";

/**
 * What starts in the worker's place, and imports it. What comes before the module is there is given to it then. It is no module itself: of a page without
 * an origin (a sandboxed frame) browsers start no modules that are made of text.
 */
const BOOTSTRAP = (address: string) => `const early = [];
onmessage = (event) => early.push(event);
import(${JSON.stringify(address)}).then(
  () => {
    onmessage = null;
    for (const { data } of early) dispatchEvent(new MessageEvent("message", { data }));
  },
  (error) => setTimeout(() => { throw error; }),
);`;

/** @throws a refusal where the policy of the page forbids it, as one that requires trusted types does */
export function startAnywhere(address: URL): Worker {
  try {
    return started(address);
  } catch (cause) {
    const refusal: Refusal = { code: "solver-stopped", path: "", message: "" };
    throw Object.assign(new Error("the page allows no worker", { cause }), refusal);
  }
}

function started(address: URL): Worker {
  if (address.origin === globalThis.origin) return new Worker(address, { type: "module" });
  const text = new Blob([BOOTSTRAP(address.href)], { type: "text/javascript" });
  const place = URL.createObjectURL(text);
  const worker = new Worker(place);
  // The browser has read it by the time that the worker says anything.
  const forget = () => URL.revokeObjectURL(place);
  worker.addEventListener("message", forget, { once: true });
  worker.addEventListener("error", forget, { once: true });
  return worker;
}
