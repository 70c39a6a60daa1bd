// The real maker for tests: its client, before what its worker runs.

import { readFile } from "node:fs/promises";
import init, { PasuError } from "pasu";
import { type Later, MakerClient } from "../src/maker/client";
import type { Answers, Kind, Request } from "../src/maker/messages";
import { buffersOf, perform } from "../src/maker/perform";
import { HeldWorker } from "./held-worker";

type Worker = HeldWorker<Request, Answers[Kind]>;

const bytes = readFile(new URL("../../crates/pasu-wasm/pkg/pasu_bg.wasm", import.meta.url));
const module = bytes.then((found) => WebAssembly.compile(found));

interface Options {
  /** Whether the worker answers at once; it waits to be told otherwise. */
  readonly free?: boolean;
  /** What a drag's walls are said to take, in milliseconds, on another machine than this. */
  readonly took?: number;
}

/** A maker whose patience has no end: no clock runs. */
export function realMaker({ free = false, took }: Options = {}): {
  readonly maker: MakerClient;
  readonly worker: Worker;
} {
  const kit = { init, PasuError, fault: "maker-unusable" };
  const paced = (request: Request, tell: (done: number) => void): Answers[Kind] => {
    const answer = perform(request, tell);
    const quick = took !== undefined && answer !== null && "solid" in answer;
    return quick ? { ...answer, took } : answer;
  };
  const worker: Worker = new HeldWorker(kit, module, paced, buffersOf);
  worker.free = free;
  const never: Later = () => () => {};
  return { maker: new MakerClient(worker.start, never), worker };
}
