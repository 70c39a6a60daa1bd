// The real solver for tests: its own client, and what its worker runs, at the two ends of a message channel.

import { readFile } from "node:fs/promises";
import init, { PasuError } from "pasu/drawing";
import { SolverClient } from "../src/solver/client";
import type { Ask, Request, SentAnswers } from "../src/solver/messages";
import { buffersOf, perform } from "../src/solver/perform";
import { channelled } from "./channelled";

type Answer = SentAnswers[Ask["kind"]];

const bytes = readFile(new URL("../../crates/pasu-wasm/pkg/pasu_drawing_bg.wasm", import.meta.url));
const module = bytes.then((found) => WebAssembly.compile(found));

/** A solver and what it was asked; `dispose` it at the end of the test. */
export function realSolver(): { readonly solver: SolverClient; readonly asked: Request[] } {
  const asked: Request[] = [];
  const kit = { init, PasuError, fault: "The solver could not be used" };
  const start = () => channelled<Request, Answer>(kit, module, perform, buffersOf, (request) => asked.push(request));
  return { solver: new SolverClient(start), asked };
}
