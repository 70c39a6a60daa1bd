/**
 * The page's side of the solver. Each lane has at most one request under way and one waiting: a newer request takes the
 * place of the waiting one, which then resolves as "superseded". A worker whose module trapped is replaced by a new one.
 */

import type { Conversion, Design, OrderKind, Refusal, Shape } from "../document/types";
import type { Outcome, Told } from "../worker/port";
import type {
  Answers,
  Ask,
  MeshArrays,
  Parsed,
  Reply,
  SentAnswers,
  Solved,
  SolveOptions,
  SolverPort,
} from "./messages";
import { type Lattices, Stock } from "./stock";

interface Job {
  readonly ask: Ask;
  readonly settle: (outcome: Outcome<Answers[Ask["kind"]]>) => void;
}

interface Sent {
  readonly job: Job;
  readonly lane: string;
  /** What the worker was told that is here. */
  readonly lattices: Lattices;
}

interface Lane {
  busy: boolean;
  waiting: Job | null;
}

const CRASHED: Refusal = {
  code: "solver-stopped",
  path: "",
  message: "The solver stopped on this design and was started again. Undo the last change, or go on.",
};

export class SolverClient {
  readonly #start: () => SolverPort;
  readonly #lanes = new Map<string, Lane>();
  readonly #sent = new Map<number, Sent>();
  readonly #stock = new Stock();
  #port: SolverPort | null = null;
  #nextId = 1;

  constructor(start: () => SolverPort) {
    this.#start = start;
  }

  /** Starts the worker before it is first asked, so that it loads while the page does. */
  warm(): void {
    this.#connect();
  }

  solve(design: Design, options: SolveOptions): Promise<Outcome<Solved>> {
    return this.#ask("solve", { kind: "solve", design, options }) as Promise<Outcome<Solved>>;
  }

  /**
   * Takes back a mesh that nobody shows any more. Its arrays travel to the worker, where a later mesh is written over them,
   * so that a drag allocates nothing.
   */
  recycle(mesh: MeshArrays): void {
    this.#stock.add(mesh);
  }

  /** A mesh alone. Requests of the same lane supersede each other; give each thumbnail a lane of its own. */
  mesh(lane: string, design: Design, rows: number, columns: number): Promise<Outcome<MeshArrays>> {
    return this.#ask(lane, { kind: "mesh", design, rows, columns }) as Promise<Outcome<MeshArrays>>;
  }

  /** Reads JSON text or a link. Never superseded. */
  parse(text: string): Promise<Outcome<Parsed>> {
    return this.#ask(`parse ${this.#nextId}`, { kind: "parse", text }) as Promise<Outcome<Parsed>>;
  }

  /** A vase in another order. Requests of the same lane supersede each other. */
  convert(lane: string, shape: Shape, order: OrderKind): Promise<Outcome<Conversion>> {
    return this.#ask(`convert ${lane}`, { kind: "convert", shape, order }) as Promise<Outcome<Conversion>>;
  }

  dispose(): void {
    this.#port?.terminate();
    this.#port = null;
    for (const { job } of this.#sent.values()) job.settle({ state: "superseded" });
    for (const lane of this.#lanes.values()) lane.waiting?.settle({ state: "superseded" });
    this.#sent.clear();
    this.#lanes.clear();
  }

  #ask(name: string, ask: Ask): Promise<Outcome<Answers[Ask["kind"]]>> {
    return new Promise((settle) => {
      const lane = this.#lanes.get(name) ?? { busy: false, waiting: null };
      this.#lanes.set(name, lane);
      const job: Job = { ask, settle };
      if (!lane.busy) {
        this.#send(name, lane, job);
        return;
      }
      lane.waiting?.settle({ state: "superseded" });
      lane.waiting = job;
    });
  }

  #send(name: string, lane: Lane, job: Job): void {
    lane.busy = true;
    const id = this.#nextId;
    this.#nextId += 1;
    const { lattices } = this.#stock;
    this.#sent.set(id, { job, lane: name, lattices });
    const { ask } = job;
    const spare =
      ask.kind === "solve" ? this.#stock.take(ask.design.parts.length * ask.options.rows * ask.options.columns) : null;
    this.#connect().postMessage(
      { id, ask, known: [...lattices.keys()], spare },
      spare ? [spare.positions.buffer, spare.normals.buffer, spare.texels.buffer] : [],
    );
  }

  #connect(): SolverPort {
    if (this.#port) return this.#port;
    const port = this.#start();
    port.onmessage = (event) => this.#receive(event.data);
    port.onerror = () => this.#restart();
    this.#port = port;
    return port;
  }

  #receive(reply: Reply | Told): void {
    if ("done" in reply) return;
    const sent = this.#sent.get(reply.id);
    if (!sent) return;
    if (!reply.ok && reply.broken) {
      this.#restart();
      return;
    }
    this.#sent.delete(reply.id);
    this.#release(sent.lane);
    sent.job.settle(
      reply.ok
        ? { state: "done", value: this.#whole(reply.answer, sent.lattices) }
        : { state: "refused", refusal: reply.refusal },
    );
  }

  /** Adds to a mesh what was not sent because it is here. */
  #whole(answer: SentAnswers[Ask["kind"]], then: Lattices): Answers[Ask["kind"]] {
    if ("design" in answer || "lost" in answer) return answer;
    return "mesh" in answer
      ? { ...answer, mesh: this.#stock.whole(answer.mesh, then) }
      : this.#stock.whole(answer, then);
  }

  #release(name: string): void {
    const lane = this.#lanes.get(name);
    if (!lane) return;
    const next = lane.waiting;
    lane.waiting = null;
    lane.busy = false;
    if (next) this.#send(name, lane, next);
    else this.#lanes.delete(name);
  }

  /** The first request under way is to blame; the others are asked again of the new worker. */
  #restart(): void {
    this.#port?.terminate();
    this.#port = null;
    const [blamed, ...others] = [...this.#sent.values()];
    this.#sent.clear();
    for (const { job, lane } of others) this.#send(lane, this.#lanes.get(lane) ?? { busy: true, waiting: null }, job);
    if (!blamed) return;
    this.#release(blamed.lane);
    blamed.job.settle({ state: "refused", refusal: CRASHED });
  }
}
