// A worker without a thread of its own: the two sides speak by messages that are cloned, as a page and its worker do.

import type { Port } from "../src/worker/port";
import { type Package, serve } from "../src/worker/serve";

/** The page's end. `heard` is told of every request that arrives. */
export function channelled<Request extends { readonly id: number }, Answer>(
  kit: Package,
  module: Promise<WebAssembly.Module>,
  perform: (request: Request) => Answer,
  buffersOf: (answer: Answer) => Transferable[],
  heard: (request: Request) => void,
): Port<Request, Answer> {
  const { port1, port2 } = new MessageChannel();
  const answer = (request: Request) => {
    heard(request);
    return perform(request);
  };
  serve<Request, Answer>(port2, kit, answer, buffersOf);
  port2.start();
  void module.then((compiled) => port1.postMessage({ module: compiled }));
  const port: Port<Request, Answer> = {
    postMessage: (message, transfer) => port1.postMessage(message, transfer),
    terminate: () => port1.close(),
    onmessage: null,
    onerror: null,
  };
  port1.onmessage = (event) => port.onmessage?.(event);
  return port;
}
