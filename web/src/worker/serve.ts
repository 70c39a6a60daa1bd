/** The worker's side: answers one request after the other, once its module is there. */

import type { Refusal } from "../document/types";
import type { Begin, Reply, Told } from "./port";

/** The part of a worker's scope, or of a message port, that is used. */
export interface Scope<Request, Answer> {
  addEventListener(type: "message", listener: (event: MessageEvent<Request | Begin>) => void): void;
  postMessage(message: Reply<Answer> | Told, options: { readonly transfer: Transferable[] }): void;
}

/** The package that answers, as far as this needs it: how it begins, and how it says no. */
export interface Package {
  readonly init: (module?: WebAssembly.Module) => Promise<void>;
  readonly PasuError: new (...parameters: never[]) => Refusal;
  /** The code of a fault that is none of the design's. */
  readonly fault: string;
  /** Loads what the package leaves out; something has come that takes it. */
  readonly widen?: (source?: string) => Promise<void>;
}

/** `perform` answers or throws, and may say how far it is; the buffers of what it answers travel, they are not copied. */
export function serve<Request extends { readonly id: number }, Answer>(
  scope: Scope<Request, Answer>,
  { init, PasuError, fault, widen }: Package,
  perform: (request: Request, tell: (done: number) => void) => Answer,
  buffersOf: (answer: Answer) => Transferable[],
): void {
  let whole: string | undefined;
  let begin: (ready: Promise<void>) => void;
  let ready = new Promise<void>((resolve) => {
    begin = resolve;
  });

  scope.addEventListener("message", ({ data }) => {
    if ("module" in data) {
      whole = data.whole;
      begin(data.module ? init(data.module) : init());
    } else {
      void respond(data);
    }
  });

  async function respond(request: Request): Promise<void> {
    const { id } = request;
    try {
      const answer = await answered(request);
      scope.postMessage({ id, ok: true, answer }, { transfer: buffersOf(answer) });
    } catch (error) {
      const broken = error instanceof WebAssembly.RuntimeError;
      scope.postMessage({ id, ok: false, refusal: refusalOf(error), broken }, { transfer: [] });
    }
  }

  async function answered(request: Request): Promise<Answer> {
    const run = () => perform(request, (done) => scope.postMessage({ id: request.id, done }, { transfer: [] }));
    await ready;
    try {
      return run();
    } catch (error) {
      if (!widen || !isLeftOut(error)) throw error;
    }
    const wider = widen(whole);
    // What is asked meanwhile waits, and goes on with what there is where it could not be had.
    ready = wider.catch(() => {});
    await wider;
    return run();
  }

  function isLeftOut(error: unknown): boolean {
    if (!(error instanceof PasuError)) return false;
    const { what } = error.args ?? {};
    return what === "left-out";
  }

  function refusalOf(error: unknown): Refusal {
    if (error instanceof PasuError) {
      const { code, path, message, args = {} } = error;
      return { code, path, message, args };
    }
    return { code: fault, path: "", message: error instanceof Error ? error.message : String(error) };
  }
}
