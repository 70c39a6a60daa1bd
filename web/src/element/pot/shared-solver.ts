/** One solver for all elements of a page: started with the first, ended with the last. A page that has one of its own lends it. */

import { SolverClient } from "../../solver/client";
import { startWorker } from "../../solver/start-anywhere";

let lent: SolverClient | null = null;
let own: SolverClient | null = null;
let users = 0;

/** A share in the solver, to be given back. */
export interface SolverShare {
  readonly solver: SolverClient;
  leave(): void;
}

export function shareSolver(): SolverShare {
  if (lent) return { solver: lent, leave: () => {} };
  own ??= new SolverClient(startWorker);
  users += 1;
  let left = false;
  return {
    solver: own,
    leave() {
      if (left) return;
      left = true;
      users -= 1;
      if (users > 0) return;
      own?.dispose();
      own = null;
    },
  };
}

/** Has elements that come from now on take this solver; none of the page's own at null. */
export function lendSolver(solver: SolverClient | null): void {
  lent = solver;
}
