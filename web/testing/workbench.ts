// A document with its surface, for tests of what follows both: the store, the real solver at once, the real maker in the hands of the test.

import type { Design } from "../src/document/types";
import { NEW_SESSION } from "../src/state/session";
import { Store } from "../src/state/store";
import { Surface } from "../src/work/surface";
import { settled } from "./held-worker";
import { realMaker } from "./real-maker";
import { realSolver } from "./real-solver";

export interface Options {
  /** What a drag's walls are said to take. */
  readonly took?: number;
}

/** The surface of this design stands, coarsely. */
export async function workbench(design: Design, { took }: Options = {}) {
  const store = new Store(design, NEW_SESSION);
  const { solver, worker: solving } = realSolver({ free: true });
  const { maker, worker: making } = realMaker(took === undefined ? {} : { took });
  const surface = new Surface(store, solver);
  surface.grid = () => ({ rows: 13, columns: 25 });
  surface.begin();
  surface.connect();
  /** Waits until the surface is that of the document. */
  const rests = async () => {
    while (surface.settled === null && surface.problem === null) await settled();
  };
  /** Waits until the solver has answered all that it was asked, and everything that follows from it has happened. */
  const solved = async () => {
    do await settled();
    while (solving.answered < solving.sent.length);
    await settled();
  };
  await rests();
  return { store, solver, solving, maker, making, surface, rests, solved };
}

export type Workbench = Awaited<ReturnType<typeof workbench>>;
