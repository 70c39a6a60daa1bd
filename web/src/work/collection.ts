/**
 * The shelf: designs that a person saved in this browser. One changes only when a person says so, whatever becomes of the pot on the stage, and what is taken away or
 * written over is handed back to whoever may want to undo it. What is in the browser was written by anybody: it is a design when the solver has read it.
 */

import { signal } from "@preact/signals-core";
import { setPath } from "../document/path";
import type { Design, Refusal } from "../document/types";
import type { SolverClient } from "../solver/client";
import { forgetPiece, forgetWork, keepPiece, type Piece, readPieces, type Shelf } from "../state/storage";
import type { Keeper } from "./keeper";
import { freshName } from "./seat";

/** A piece as the solver read it. */
export interface Entry {
  readonly piece: Piece;
  /** Null where it is no design. */
  readonly design: Design | null;
  readonly link: string;
  readonly refusal: Refusal | null;
}

/** How a change ended: why there is none, or what takes it back, which says whether it could. */
export type Change =
  | { readonly state: "done"; readonly undo: () => Promise<boolean> }
  | { readonly state: "full" | "refused" };

export class Collection {
  readonly #solver: SolverClient;
  readonly #keeper: Keeper;
  readonly #entries = signal<readonly Entry[] | null>(null);
  #reading = 0;

  constructor(solver: SolverClient, keeper: Keeper) {
    this.#solver = solver;
    this.#keeper = keeper;
  }

  /** Everything on the shelf, the one changed last first; null before it was read. */
  get entries(): readonly Entry[] | null {
    return this.#entries.value;
  }

  /** Puts the work of closed tabs that is nowhere else on the shelf, and says how much that was. */
  async gather(): Promise<number> {
    let gathered = 0;
    for (const { tab, work, at } of await this.#keeper.left()) {
      if (!keepPiece(this.#shelf, { id: `tab-${tab}`, text: work.text, at })) continue;
      forgetWork(this.#shelf, tab);
      gathered += 1;
    }
    return gathered;
  }

  /** Reads the shelf as it is now; another tab may have changed it. */
  async read(): Promise<void> {
    this.#reading += 1;
    const mine = this.#reading;
    const before = new Map(this.#entries.peek()?.map((entry) => [entry.piece.id, entry]));
    const entries: Entry[] = [];
    for (const piece of readPieces(this.#shelf)) {
      const known = before.get(piece.id);
      entries.push(known?.piece.text === piece.text ? { ...known, piece } : await this.#readPiece(piece));
    }
    if (mine === this.#reading) this.#entries.value = entries;
  }

  async #readPiece(piece: Piece): Promise<Entry> {
    const outcome = await this.#solver.parse(piece.text);
    if (outcome.state === "done") return { piece, ...outcome.value, refusal: null };
    return { piece, design: null, link: "", refusal: outcome.state === "refused" ? outcome.refusal : null };
  }

  /** Saves a design as a new piece. */
  save(design: Design): Promise<Change> {
    return this.#write(freshName(), design);
  }

  /** Puts a design in the place of a piece. */
  replace({ piece }: Entry, design: Design): Promise<Change> {
    return this.#write(piece.id, design, piece);
  }

  rename({ piece, design }: Entry, title: string): Promise<Change> {
    return design
      ? this.#write(piece.id, setPath(design, ["title"], title === "" ? undefined : title), piece)
      : Promise.resolve({ state: "refused" });
  }

  async remove({ piece }: Entry): Promise<Change> {
    forgetPiece(this.#shelf, piece.id);
    await this.read();
    return { state: "done", undo: () => this.#putBack(piece) };
  }

  get #shelf(): Shelf | null {
    return this.#keeper.shelf;
  }

  async #write(id: string, design: Design, before?: Piece): Promise<Change> {
    const outcome = await this.#solver.parse(JSON.stringify(design));
    if (outcome.state !== "done") return { state: "refused" };
    // Another tab may have changed it since it was read: then both stay.
    const now = before && readPieces(this.#shelf).find((piece) => piece.id === id);
    const place = before && now?.text !== before.text ? freshName() : id;
    const text = JSON.stringify(outcome.value.design);
    if (!keepPiece(this.#shelf, { id: place, text, at: Date.now() })) return { state: "full" };
    await this.read();
    return {
      state: "done",
      undo: async () => {
        if (before && place === id) return await this.#putBack(before);
        forgetPiece(this.#shelf, place);
        await this.read();
        return true;
      },
    };
  }

  /** Whether there was room for it. */
  async #putBack(piece: Piece): Promise<boolean> {
    const kept = keepPiece(this.#shelf, piece);
    await this.read();
    return kept;
  }
}
