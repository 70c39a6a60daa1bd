/**
 * Keeps a wall in step with its surface while a shape is dragged: both are made of the same design at once, by two workers, and shown in one
 * frame. One pair is under way at a time, and the latest change waits for it. Where a wall takes too long, the surface goes ahead alone,
 * and its wall follows once the hand holds still. Of a scene whose walls are on the stage only those of the parts that change are made.
 */

import { areCarried, changedBetween } from "../document/carried";
import type { Design } from "../document/types";
import { sameSurface } from "../document/wall";
import type { MakerClient } from "../maker/client";
import type { Quick, Solid, Spare } from "../maker/messages";
import { around } from "../solver/bounds";
import { longest, type Solved } from "../solver/solved";
import type { Store } from "../state/store";
import type { Outcome } from "../worker/port";
import { Pace } from "./pace";
import { NOTHING, type Piece, QUICK } from "./piece";
import type { Companion, Surface } from "./surface";

/**
 * How far the picture may be from the faces, as a share of the size of the pot, from that at rest to the coarsest. Most of the time goes into what a
 * coarser picture does not save: how thick the wall can be, and whether it has room.
 */
const TOLERANCES = [1 / 700, 1 / 450, 1 / 300] as const;

/** Milliseconds for which a surface waits for its wall. */
const PATIENCE_MS = 150;

/** And at the beginning of a drag, when the maker may have to be started anew. */
const FIRST_PATIENCE_MS = 400;

/** With the walls of other parts on the stage nobody misses one for a moment: the surface waits for two frames. */
const SHORT_PATIENCE_MS = 33;

/** Water follows the hand in so many pots; where there are more it is poured again once the hand lets go. */
const POURED = 4;

/** A wall on the coarsest grid that takes longer than this is left out until the hand lets go. */
const TOO_LONG_MS = 120;

/** The hand holds still when nothing has changed for so many milliseconds since the surface went ahead: its wall is asked for again, however long it takes. */
const STILL_MS = 150;

/** So many of these in a row: the first wall after a start is slower than those that follow. */
const TRIES = 2;

/** Sets of arrays that wait to be written over: one is on the stage, one under way. */
const SPARES = 2;

/** What is asked of the maker: the walls of these parts, or of all at null. */
interface Asking {
  readonly asking: Promise<Outcome<Quick>>;
  readonly step: number;
  readonly parts: readonly number[] | null;
}

/** A wall that was made, of these parts alone or of all. */
interface Walling {
  readonly piece: Piece<Quick>;
  readonly parts: readonly number[] | null;
}

/** Runs something after so many milliseconds; what comes back takes that back. */
export type Later = (run: () => void, milliseconds: number) => () => void;

export class InStep implements Companion {
  readonly #store: Store;
  readonly #surface: Surface;
  readonly #maker: MakerClient;
  readonly #put: (piece: Piece<Quick>, parts: readonly number[] | null) => void;
  readonly #later: Later;
  readonly #walls: () => Piece<Solid>;
  readonly #pace = new Pace(TOLERANCES.length - 1, 0);
  /** The pair under way: nothing else has the right to be shown. */
  #pair: object | null = null;
  #held: (() => void) | null = null;
  /** What was made last in this drag; null before its first pair. */
  #made: Design | null = null;
  /** The maker still works on a wall that nobody waits for. */
  #late = false;
  #tries = 0;
  /** Takes back the clock by which the hand is found to hold still; null when none runs. */
  #moved: (() => void) | null = null;
  /** Of walls of all parts, and of those of some. */
  #spares: Spare[] = [];
  #few: Spare[] = [];

  /** `put` takes the walls of some parts, or of all at null; `walls` are those that stand on the stage. */
  constructor(
    store: Store,
    surface: Surface,
    maker: MakerClient,
    put: (piece: Piece<Quick>, parts: readonly number[] | null) => void,
    later: Later = timer,
    walls: () => Piece<Solid> = () => NOTHING,
  ) {
    this.#store = store;
    this.#surface = surface;
    this.#maker = maker;
    this.#put = put;
    this.#later = later;
    this.#walls = walls;
  }

  /** Whether the next change has to wait for the pair that is under way; `run` is called after it. */
  waits(run: () => void): boolean {
    const waits = this.#pair !== null && this.#store.inGesture;
    this.#held = waits ? run : null;
    return waits;
  }

  /** The solved surface once its wall is there too; null where a wall is not dragged along. */
  join(design: Design, solving: Promise<Outcome<Solved>>): Promise<Outcome<Solved>> | null {
    const pair = {};
    this.#pair = null;
    this.#moved?.();
    this.#moved = null;
    if (!this.#dragged(design)) return null;
    if (this.#late || this.#tries >= TRIES) {
      void this.#alone(design, solving);
      return null;
    }
    this.#pair = pair;
    return this.#together(pair, design, solving);
  }

  /** Takes back the arrays of walls that are not shown any more, of all parts or of some: these are written over by their like, as what goes to the graphics card is as long as they are. */
  recycle({ positions, normals, wares, indices }: Spare, some = false): void {
    const spare = { positions, normals, wares, indices };
    if (some) this.#few = [...this.#few, spare].slice(-SPARES);
    else this.#spares = [...this.#spares, spare].slice(-SPARES);
  }

  /** Whether the shape of a pot is under the hand, or was until now. */
  #dragged(design: Design): boolean {
    const { shown } = this.#surface;
    const began = this.#made;
    if (!this.#store.inGesture) {
      this.#made = null;
      if (!began || this.#tries >= TRIES) {
        this.#tries = 0;
        return false;
      }
    }
    if (pots(design) === 0 || !shown) return false;
    // A part without a wall changes none of those that stand there.
    if (this.#store.inGesture && this.#anew(design)?.length === 0) return false;
    if (began !== null) return true;
    // A part that is only moved takes its wall along. Water would have to be poured anew.
    const [before, now] = [shown.design.parts, design.parts];
    return !sameSurface(before, now) && !(this.#fill(design) === null && areCarried(before, now));
  }

  /** How full the pots are that are filled under the hand. */
  #fill(design: Design): number | null {
    return pots(design) > POURED ? null : this.#store.session.fill;
  }

  /** The parts whose walls have to be made where those of others stand on the stage; null where nothing does, or water is poured into all. */
  #anew(design: Design): readonly number[] | null {
    const { value, of } = this.#walls();
    const stand = value !== null && of !== null && this.#fill(design) === null;
    return stand ? changedBetween(of.parts, design.parts) : null;
  }

  async #together(pair: object, design: Design, solving: Promise<Outcome<Solved>>): Promise<Outcome<Solved>> {
    const walls = this.#wall(design, this.#made ? PATIENCE_MS : FIRST_PATIENCE_MS);
    if (this.#store.inGesture) this.#made = design;
    const solved = await solving;
    const walling = solved.state === "done" ? await walls : null;
    const current = this.#pair === pair;
    if (current) {
      this.#pair = null;
      const held = this.#held;
      this.#held = null;
      held?.();
    }
    if (solved.state !== "done") return solved;
    if (current) {
      if (walling) this.#put(whole(walling.piece, solved.value), walling.parts);
      else this.#awaitStill(design);
      return solved;
    }
    // Something newer is on its way already.
    this.#surface.recycle(solved.value.parts.map(({ mesh }) => mesh));
    if (walling?.piece.value) this.recycle(walling.piece.value.solid, walling.parts !== null);
    return { state: "superseded" };
  }

  /** A surface that goes ahead without waiting for its wall. */
  async #alone(design: Design, solving: Promise<Outcome<Solved>>): Promise<void> {
    const solved = await solving;
    if (solved.state === "done" && !this.#pair) this.#awaitStill(design);
  }

  /** Sees to it that a surface that went ahead gets its wall, unless the hand moves on, which asks by itself. */
  #awaitStill(design: Design): void {
    this.#moved?.();
    this.#moved = this.#later(() => {
      this.#moved = null;
      this.#again(design);
    }, STILL_MS);
  }

  /** Asks for the wall of what the hand holds still. One that is under way is waited for. */
  #again(design: Design): void {
    if (this.#late || this.#pair || this.#moved || !this.#holds(design)) return;
    this.#follow(this.#ask(design), design);
  }

  /** Whether the hand still holds this, and its surface is on the stage. */
  #holds(design: Design): boolean {
    const { design: now, inGesture } = this.#store;
    return inGesture && now === design && this.#surface.shown?.design === design;
  }

  /** What nobody waits for is shown if the hand still holds what it is of; if it moved on and holds still by now, that is asked for. */
  #follow({ asking, parts }: Asking, design: Design): void {
    this.#late = true;
    void asking.then((outcome) => {
      this.#late = false;
      if (outcome.state === "superseded") return;
      const { shown } = this.#surface;
      if (shown && !this.#pair && this.#holds(design)) {
        this.#moved?.();
        this.#moved = null;
        this.#put(whole(pieceOf(outcome, design), shown.solved), parts);
        return;
      }
      if (outcome.state === "done") this.recycle(outcome.value.solid, parts !== null);
      this.#again(this.#store.design);
    });
  }

  /** The wall; null when it takes too long. */
  async #wall(design: Design, longest: number): Promise<Walling | null> {
    const asked = this.#ask(design);
    const { asking, step, parts } = asked;
    const patience = parts ? SHORT_PATIENCE_MS : longest;
    let wait = () => {};
    const over = new Promise<null>((resolve) => {
      wait = this.#later(() => resolve(null), patience);
    });
    const outcome = await Promise.race([asking, over]);
    wait();
    if (outcome === null) {
      this.#took(patience, step);
      this.#follow(asked, design);
      return null;
    }
    if (outcome.state === "superseded") return null;
    if (outcome.state === "done") this.#took(outcome.value.took, step);
    return { piece: pieceOf(outcome, design), parts };
  }

  #ask(design: Design): Asking {
    const { step } = this.#pace;
    const tolerance = longest(this.#surface.shown?.solved) * (TOLERANCES[step] ?? TOLERANCES[0]);
    const fill = this.#fill(design);
    const anew = this.#anew(design);
    const parts = anew && anew.length > 0 && anew.length < pots(design) ? anew : null;
    const spare = (parts ? this.#few : this.#spares).pop() ?? null;
    return { asking: this.#maker.ask({ kind: "quick", design, parts, tolerance, fill, spare }), step, parts };
  }

  #took(milliseconds: number, step: number): void {
    this.#tries = milliseconds > TOO_LONG_MS && step === TOLERANCES.length - 1 ? this.#tries + 1 : 0;
    this.#pace.learn(milliseconds, true);
  }
}

/** How many parts have a wall. */
function pots({ parts }: Design): number {
  return parts.filter(({ wall }) => wall !== undefined).length;
}

/** What came of asking for the wall of a design. */
function pieceOf(outcome: Exclude<Outcome<Quick>, { readonly state: "superseded" }>, design: Design): Piece<Quick> {
  const done = outcome.state === "done";
  return { value: done ? outcome.value : null, of: design, problem: done ? null : outcome.refusal, key: QUICK };
}

/** With the bounds of all of the pot: the wall comes without the surface. */
function whole(piece: Piece<Quick>, { bounds }: Solved): Piece<Quick> {
  const { value } = piece;
  if (!value) return piece;
  return { ...piece, value: { ...value, solid: { ...value.solid, bounds: around(value.solid.bounds, bounds) } } };
}

/** The clock of the browser. */
export function timer(run: () => void, milliseconds: number): () => void {
  const id = setTimeout(run, milliseconds);
  return () => clearTimeout(id);
}
