// A worker in the hands of a test: what it runs is the real thing, and messages are cloned as between threads, but it does the next request only when it is told to.

import type { Begin, Port, Reply, Told } from "../src/worker/port";
import { type Package, serve } from "../src/worker/serve";

export class HeldWorker<Request extends { readonly id: number }, Answer> {
  /** Everything that was asked, of ended workers too. */
  readonly sent: Request[] = [];
  /** How much of it was answered. */
  answered = 0;
  /** Whether requests are done as they come. */
  free = false;
  readonly #kit: Package;
  readonly #module: Promise<WebAssembly.Module>;
  readonly #perform: (request: Request, tell: (done: number) => void) => Answer;
  readonly #buffersOf: (answer: Answer) => Transferable[];
  readonly #waiting: (() => Promise<void>)[] = [];

  constructor(
    kit: Package,
    module: Promise<WebAssembly.Module>,
    perform: (request: Request, tell: (done: number) => void) => Answer,
    buffersOf: (answer: Answer) => Transferable[],
  ) {
    this.#kit = kit;
    this.#module = module;
    this.#perform = perform;
    this.#buffersOf = buffersOf;
  }

  /** The last thing that was asked. */
  get last(): Request {
    const last = this.sent.at(-1);
    if (!last) throw new Error("nothing was asked");
    return last;
  }

  /** Does the oldest request; over once the page has heard and everything that follows from it has happened. */
  async answer(): Promise<void> {
    const next = this.#waiting.shift();
    if (!next) throw new Error("nothing waits to be answered");
    await next();
  }

  /** Does everything, until nothing is asked any more. */
  async finish(): Promise<void> {
    do {
      await this.#waiting.shift()?.();
      await settled();
    } while (this.#waiting.length > 0);
  }

  /** Starts one of these, as a client does. */
  readonly start = (): Port<Request, Answer> => {
    let told: (message: Request | Begin) => void = () => {};
    let heard: () => void = () => {};
    let ended = false;
    const reply = (data: Reply<Answer> | Told, transfer: Transferable[]) => {
      const message = new MessageEvent("message", { data: structuredClone(data, { transfer }) });
      if ("done" in data) {
        if (!ended) port.onmessage?.(message);
        return;
      }
      this.answered += 1;
      if (!ended) port.onmessage?.(message);
      heard();
    };
    serve<Request, Answer>(
      {
        addEventListener: (_, listener) => {
          told = (data) => listener(new MessageEvent("message", { data }));
        },
        postMessage: (message, { transfer }) => reply(message, transfer),
      },
      this.#kit,
      this.#perform,
      this.#buffersOf,
    );
    void this.#module.then((module) => told({ module }));
    const port: Port<Request, Answer> = {
      postMessage: (message, transfer) => {
        const request = structuredClone(message, { transfer });
        this.sent.push(request);
        const work = async () => {
          if (ended) return;
          await new Promise<void>((resolve) => {
            heard = resolve;
            told(request);
          });
          await settled();
        };
        if (this.free) void work();
        else this.#waiting.push(work);
      },
      terminate: () => {
        ended = true;
      },
      onmessage: null,
      onerror: null,
    };
    return port;
  };
}

/** Everything that was to happen at once has happened. */
export function settled(): Promise<void> {
  return new Promise((resolve) => setImmediate(resolve));
}
