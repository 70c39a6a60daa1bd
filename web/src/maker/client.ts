/**
 * The page's side of the maker, whose work may take seconds. One request is under way at a time, and of every lane at most one
 * waits: a newer one takes its place, and the older resolves as "superseded". What is under way while something newer waits in its lane
 * may still end by itself and is handed over; if that takes long, its worker is ended and another started, in no more than a blink.
 */

import type { Refusal } from "../document/types";
import type { Outcome, Told } from "../worker/port";
import type { Answers, Ask, Kind, MakerPort, Reply } from "./messages";

/** Runs something after so many milliseconds; what comes back takes that back. */
export type Later = (run: () => void, milliseconds: number) => () => void;

/** What hears how far work is, from 0 to 1. */
export type Tell = (done: number) => void;

interface Job {
  readonly ask: Ask;
  readonly lane: string;
  readonly tell: Tell | undefined;
  readonly settle: (outcome: Outcome<Answers[Kind]>) => void;
}

/** Work that something newer waits for may go on for so long. */
const PATIENCE_MS = 1000;

/** What a person looks at comes first. */
const ORDER: readonly Kind[] = [
  "pull",
  "pick",
  "free",
  "fit",
  "levels",
  "scanned",
  "compare",
  "apart",
  "together",
  "push",
  "open",
  "faces",
  "write",
  "quick",
  "water",
  "solid",
  "paint",
  "lining",
  "measure",
  "constraints",
  "check",
];

const CRASHED: Refusal = { code: "maker-stopped", path: "", message: "" };

const SUPERSEDED = { state: "superseded" } as const;

export class MakerClient {
  readonly #start: () => MakerPort;
  readonly #later: Later;
  readonly #waiting = new Map<string, Job>();
  #port: MakerPort | null = null;
  #under: { readonly id: number; readonly job: Job } | null = null;
  #nextId = 1;
  #stay: (() => void) | null = null;

  constructor(start: () => MakerPort, later: Later = timer) {
    this.#start = start;
    this.#later = later;
  }

  /** Starts the worker before it is first asked, so that it loads meanwhile. */
  warm(): void {
    this.#connect();
  }

  /** Whether anything is under way. */
  get busy(): boolean {
    return this.#under !== null;
  }

  /**
   * Requests of the same lane supersede each other; whoever asks for something of its own takes a lane of its own. A check and a file
   * `tell` how far they are.
   */
  ask<K extends Kind>(
    ask: Extract<Ask, { kind: K }>,
    lane: string = ask.kind,
    tell?: Tell,
  ): Promise<Outcome<Answers[K]>> {
    return new Promise((settle) => {
      const job: Job = { ask, lane, tell, settle: settle as Job["settle"] };
      this.#waiting.get(lane)?.settle(SUPERSEDED);
      this.#waiting.set(lane, job);
      if (this.#under?.job.lane === lane) this.#abandon();
      this.#next();
    });
  }

  /** Takes back what was asked in these lanes; whoever asked hears "superseded". What is under way ends at once. */
  cancel(...lanes: readonly string[]): void {
    for (const lane of lanes) {
      const job = this.#waiting.get(lane);
      this.#waiting.delete(lane);
      job?.settle(SUPERSEDED);
    }
    if (this.#under && lanes.includes(this.#under.job.lane)) {
      this.#end(SUPERSEDED);
      this.#next();
    }
  }

  dispose(): void {
    this.cancel(...this.#waiting.keys(), this.#under?.job.lane ?? "");
    this.#port?.terminate();
    this.#port = null;
  }

  #next(): void {
    if (this.#under) return;
    const rank = ({ ask }: Job) => (ask.kind === "solid" && ask.fine ? ORDER.length : ORDER.indexOf(ask.kind));
    const [job] = [...this.#waiting.values()].sort((a, b) => rank(a) - rank(b));
    if (!job) return;
    this.#waiting.delete(job.lane);
    const id = this.#nextId;
    this.#nextId += 1;
    this.#under = { id, job };
    const spare = job.ask.kind === "quick" ? job.ask.spare : null;
    this.#connect().postMessage({ id, ask: job.ask }, spare ? Object.values(spare).map(({ buffer }) => buffer) : []);
  }

  #connect(): MakerPort {
    if (this.#port) return this.#port;
    const port = this.#start();
    port.onmessage = (event) => {
      if (port === this.#port) this.#receive(event.data);
    };
    port.onerror = () => {
      if (port === this.#port) this.#crash();
    };
    this.#port = port;
    return port;
  }

  #receive(reply: Reply | Told): void {
    const under = this.#under;
    if (under?.id !== reply.id) return;
    if ("done" in reply) {
      under.job.tell?.(reply.done);
      return;
    }
    if (!reply.ok && reply.broken) {
      this.#crash();
      return;
    }
    this.#rest();
    this.#under = null;
    under.job.settle(reply.ok ? { state: "done", value: reply.answer } : { state: "refused", refusal: reply.refusal });
    this.#next();
  }

  /** Nobody waits for what is under way any more. */
  #abandon(): void {
    this.#stay ??= this.#later(() => {
      this.#stay = null;
      this.#end(SUPERSEDED);
      this.#next();
    }, PATIENCE_MS);
  }

  #crash(): void {
    this.#end({ state: "refused", refusal: CRASHED });
    this.#next();
  }

  /** Ends the worker and with it what is under way. */
  #end(outcome: Outcome<Answers[Kind]>): void {
    this.#rest();
    this.#port?.terminate();
    this.#port = null;
    const under = this.#under;
    this.#under = null;
    under?.job.settle(outcome);
  }

  #rest(): void {
    this.#stay?.();
    this.#stay = null;
  }
}

function timer(run: () => void, milliseconds: number): () => void {
  const id = setTimeout(run, milliseconds);
  return () => clearTimeout(id);
}
