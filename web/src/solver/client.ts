/**
 * The page's side of the solver. Each lane has at most one request under way and one waiting: a newer request takes the
 * place of the waiting one, which then resolves as "superseded". A worker whose module trapped is replaced by a new one.
 */

import type { Points } from "../document/mixing";
import type { Conversion, Design, OrderKind, Refusal, Shape } from "../document/types";
import type { Outcome, Told } from "../worker/port";
import { askOf, Desk, type Desktop, meshWanted, type Task } from "./desk";
import type {
  Ask,
  Parsed,
  PartsAsk,
  Reply,
  Request,
  SentAnswers,
  SentMesh,
  SentParts,
  SolverPort,
  Used,
} from "./messages";
import { Sender } from "./moved";
import { nextRevision, placedParts, type Solved, type SolvedParts } from "./solved";
import { type Lattices, Stock } from "./stock";

/** Lanes are known by their names, or by whom they belong to. */
type LaneKey = string | object;

/** Something that the worker is wanted for. */
interface Job {
  /** What is asked by now; null where nothing is. */
  readonly ask: () => Ask | null;
  /** Takes the answer, null where nothing was asked. Says whether that will do: what was asked for has to be asked for again where not. */
  readonly take: (answer: SentAnswers[Ask["kind"]] | null, then: Lattices) => boolean;
  readonly end: (
    outcome: { readonly state: "superseded" } | { readonly state: "refused"; readonly refusal: Refusal },
  ) => void;
}

interface Sent {
  readonly job: Job;
  readonly lane: LaneKey;
  /** What the worker was told that is here. */
  readonly lattices: Lattices;
}

interface Lane {
  busy: boolean;
  waiting: Job | null;
}

const CRASHED: Refusal = { code: "solver-stopped", path: "", message: "" };

export class SolverClient implements Desktop {
  readonly #start: () => SolverPort;
  readonly #lanes = new Map<LaneKey, Lane>();
  readonly #sent = new Map<number, Sent>();
  readonly #stock = new Stock();
  readonly #sender = new Sender();
  #port: SolverPort | null = null;
  #nextId = 1;

  constructor(start: () => SolverPort) {
    this.#start = start;
  }

  /** Starts the worker before it is first asked, so that it loads while the page does. */
  warm(): void {
    this.#connect();
  }

  /** A place where the parts of one design are kept from one change to the next. */
  desk(): Desk {
    return new Desk(this);
  }

  solve(lane: object, task: Task<Solved>): Promise<Outcome<Solved>> {
    return this.#parts(lane, task);
  }

  /**
   * Takes back a mesh that nobody shows any more. Its arrays travel to the worker, where a later mesh is written over them,
   * so that a drag allocates nothing.
   */
  recycle(mesh: Used): void {
    this.#stock.add(mesh);
  }

  /** Meshes alone, which nobody keeps. Requests of the same lane supersede each other; give each thumbnail a lane of its own. */
  mesh(lane: string, design: Design, rows: number, columns: number): Promise<Outcome<SolvedParts>> {
    const options = { rows, columns, lines: false, settle: true };
    const parts = design.parts.map((part, place) =>
      askOf(part, place, place, meshWanted(design, part, options), false),
    );
    return this.#parts<SolvedParts>(lane, {
      ask: () => ({ kind: "parts", parts, whole: null }),
      take: (answer, whole) => {
        const sent = answer?.parts ?? [];
        const made = sent.flatMap(({ id, mesh, told }) =>
          mesh && told ? [{ id, revision: nextRevision(), mesh: whole(mesh), told, lines: null }] : [],
        );
        return placedParts(design, made);
      },
    });
  }

  /** Reads JSON text or a link. Never superseded. */
  parse(text: string): Promise<Outcome<Parsed>> {
    return this.#plain<Parsed>(`parse ${this.#nextId}`, { kind: "parse", text });
  }

  /** A vase in another order. Requests of the same lane supersede each other. */
  convert(lane: string, shape: Shape, order: OrderKind): Promise<Outcome<Conversion>> {
    return this.#plain<Conversion>(`convert ${lane}`, { kind: "convert", shape, order });
  }

  /** Points of a shape at these `u, v` pairs, in double precision. Requests of the same lane supersede each other. */
  read(lane: string, shape: Shape, at: Float64Array): Promise<Outcome<Points>> {
    return this.#plain<Points>(`read ${lane}`, { kind: "read", shape, at });
  }

  /** Ends all that is under way: the worker is stopped in the midst of it, and the next one begins anew. */
  halt(): void {
    const sent = [...this.#sent.values()];
    if (sent.length === 0) return;
    this.#port?.terminate();
    this.#port = null;
    this.#sent.clear();
    for (const { job, lane } of sent) {
      job.end({ state: "superseded" });
      this.#release(lane);
    }
  }

  dispose(): void {
    this.#port?.terminate();
    this.#port = null;
    for (const { job } of this.#sent.values()) job.end({ state: "superseded" });
    for (const lane of this.#lanes.values()) lane.waiting?.end({ state: "superseded" });
    this.#sent.clear();
    this.#lanes.clear();
  }

  #parts<T>(lane: LaneKey, { ask, take }: Task<T>): Promise<Outcome<T>> {
    return new Promise((settle) => {
      this.#queue(lane, {
        ask,
        take: (answer, then) => {
          const value = take(answer as SentParts | null, (mesh: SentMesh) => this.#stock.whole(mesh, then));
          if (value !== undefined) settle({ state: "done", value });
          return value !== undefined;
        },
        end: settle,
      });
    });
  }

  /** Something whose answer is what was sent. */
  #plain<T>(lane: LaneKey, ask: Exclude<Ask, PartsAsk>): Promise<Outcome<T>> {
    return new Promise((settle) => {
      const take = (answer: unknown) => {
        settle({ state: "done", value: answer as T });
        return true;
      };
      this.#queue(lane, { ask: () => ask, take, end: settle });
    });
  }

  #queue(name: LaneKey, job: Job): void {
    const lane = this.#lanes.get(name) ?? { busy: false, waiting: null };
    this.#lanes.set(name, lane);
    if (!lane.busy) {
      this.#send(name, lane, job);
      return;
    }
    lane.waiting?.end({ state: "superseded" });
    lane.waiting = job;
  }

  #send(name: LaneKey, lane: Lane, job: Job): void {
    lane.busy = true;
    const { lattices } = this.#stock;
    const ask = job.ask();
    if (!ask) {
      job.take(null, lattices);
      this.#release(name);
      return;
    }
    const id = this.#nextId;
    this.#nextId += 1;
    this.#sent.set(id, { job, lane: name, lattices });
    // Who keeps what he is sent gives it back.
    const spares =
      ask.kind === "parts" && typeof name !== "string"
        ? ask.parts.map(({ mesh }) => mesh && this.#stock.take(mesh.rows * mesh.columns))
        : [];
    const port = this.#connect();
    port.postMessage(
      { id, ask: this.#packed(ask), known: [...lattices.keys()], spares },
      spares.flatMap((spare) => (spare ? [spare.positions.buffer, spare.normals.buffer, spare.texels.buffer] : [])),
    );
  }

  #packed(ask: Ask): Request["ask"] {
    if (ask.kind !== "parts") return ask;
    const packed = <T extends { readonly shape: Shape }>(part: T) => ({
      ...part,
      shape: this.#sender.pack(part.shape),
    });
    // In the order in which they are read.
    const whole = ask.whole && {
      ...ask.whole,
      design: { ...ask.whole.design, parts: ask.whole.design.parts.map(packed) },
    };
    return { ...ask, whole, parts: ask.parts.map(packed) };
  }

  #connect(): SolverPort {
    if (this.#port) return this.#port;
    const port = this.#start();
    this.#sender.forget();
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
    if (!reply.ok) sent.job.end({ state: "refused", refusal: reply.refusal });
    else if (!sent.job.take(reply.answer, sent.lattices)) {
      this.#send(sent.lane, this.#lanes.get(sent.lane) ?? { busy: true, waiting: null }, sent.job);
      return;
    }
    // What is answered at once now comes after this answer.
    this.#release(sent.lane);
  }

  #release(name: LaneKey): void {
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
    blamed.job.end({ state: "refused", refusal: CRASHED });
  }
}
