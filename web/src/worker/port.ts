/** What the page sees of a worker, and how what was asked of one ends. */

import type { Refusal } from "../document/types";

export type Outcome<T> =
  | { readonly state: "done"; readonly value: T }
  | { readonly state: "refused"; readonly refusal: Refusal }
  | { readonly state: "superseded" };

/** A worker's answer to the request of this number; `broken` says that its module trapped and is of no more use. */
export type Reply<Answer> =
  | { readonly id: number; readonly ok: true; readonly answer: Answer }
  | { readonly id: number; readonly ok: false; readonly refusal: Refusal; readonly broken: boolean };

/** How far the work on the request of this number is, from 0 to 1: said before its answer, or never. */
export interface Told {
  readonly id: number;
  readonly done: number;
}

/** The part of the Worker interface that is used, so that tests need no browser. */
export interface Port<Request, Answer> {
  postMessage(message: Request, transfer: Transferable[]): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<Reply<Answer> | Told>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

/** The compiled package, the first thing that a worker is told; null when it has to fetch it by itself. */
export interface Begin {
  readonly module: WebAssembly.Module | null;
  /** Where that module is which has what this one leaves out, if not beside the worker's file. */
  readonly whole?: string;
}
