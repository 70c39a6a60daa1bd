// The real solver for tests: its client, before what its worker runs.

import { readFile } from "node:fs/promises";
import init, { PasuError, widen } from "pasu/drawing";
import { SolverClient } from "../src/solver/client";
import type { Ask, Request, SentAnswers } from "../src/solver/messages";
import { buffersOf, fetchPatchwork, perform } from "../src/solver/perform";
import { HeldWorker } from "./held-worker";

type Worker = HeldWorker<Request, SentAnswers[Ask["kind"]]>;

const bytes = readFile(new URL("../../crates/pasu-wasm/pkg/pasu_drawing_bg.wasm", import.meta.url));
const module = bytes.then((found) => WebAssembly.compile(found));

/** A solver whose worker waits to be told, or is free to answer at once. */
export function realSolver({ free = false, wider = widen } = {}): {
  readonly solver: SolverClient;
  readonly worker: Worker;
} {
  const both = async (source?: string) => {
    await Promise.all([wider(source), fetchPatchwork()]);
  };
  const kit = { init, PasuError, fault: "solver-unusable", widen: both };
  const worker: Worker = new HeldWorker(kit, module, perform, buffersOf);
  worker.free = free;
  return { solver: new SolverClient(worker.start), worker };
}
