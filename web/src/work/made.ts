/**
 * What is made of the design besides its picture: the pot with its wall, its measures, the verdict of the checks, colour maps
 * and water. It follows the document and its surface, asks the maker once the design rests (or when nothing but a wall changes), and only
 * for what somebody looks at. Whether it can be made is also found out while a hand holds it still.
 */

import { batch, computed, effect, type Signal, signal } from "@preact/signals-core";
import { areCarried, areUntouched } from "../document/carried";
import { type Extents, extentsTogether } from "../document/extents";
import { unitOf } from "../document/look";
import type { Constraints, Design, MapName, Measures, Refusal, Report } from "../document/types";
import { sameSurface } from "../document/wall";
import { waterRange } from "../document/water";
import type { MakerClient } from "../maker/client";
import type { Answers, Ask, Filled, Kind, Lined, Painted, Quick, Solid } from "../maker/messages";
import { longest, unwalled } from "../solver/solved";
import type { PartId } from "../state/part-ids";
import type { Store } from "../state/store";
import { holdsText } from "../words/measures";
import { InStep, type Later, timer } from "./in-step";
import { NOTHING, type Piece, QUICK } from "./piece";
import type { Surface } from "./surface";

/** What is shown in the panels; the export dialogue asks for itself. */
type Shown = "solid" | "measure" | "check" | "constraints" | "paint" | "lining" | "water";

/** How far a picture may be from the faces, as a share of the size of the pot: one that is there soon, and one to look at. */
const COARSE = 1 / 150;
const FINE = 1 / 700;

/** What was made of other parts serves again as long as all is about as large: so many steps lie between a size and twice that. */
const STEPS = 4;

/** Of these, what is made of an earlier change is better to look at than what was there before. */
const SHOWN_LATE: readonly Shown[] = ["solid", "water"];

/** The hand holds still when what it holds has stood on the stage for so many milliseconds. */
const STILL_MS = 400;

/** The walls of these parts. */
export interface ChangedWalls extends Piece<Solid> {
  readonly parts: readonly number[];
}

const UNCHANGED: ChangedWalls = { ...NOTHING, parts: [] };

type DesignAsk = Extract<Ask, { readonly design: Design }>;

export class Made {
  readonly maker: MakerClient;
  /**
   * Another, which judges whether parts fit together: of hundreds that may take long, and nothing else is to wait for it. What a hand holds
   * still it judges as a whole, so that the wall under the hand never waits.
   */
  readonly judge: MakerClient;
  /** What keeps the wall on the screen while the shape is dragged. */
  readonly inStep: InStep;
  readonly #store: Store;
  readonly #surface: Surface;
  readonly #pieces: { readonly [K in Shown]: Signal<Piece<Answers[K]>> } = {
    solid: signal<Piece<Solid>>(NOTHING),
    measure: signal<Piece<Measures>>(NOTHING),
    check: signal<Piece<Report>>(NOTHING),
    constraints: signal<Piece<Constraints>>(NOTHING),
    paint: signal<Piece<Painted>>(NOTHING),
    lining: signal<Piece<Lined>>(NOTHING),
    water: signal<Piece<Filled>>(NOTHING),
  };
  /** The walls of parts that a hand changed since the others' were made, which stand with those. */
  readonly #changed = signal<ChangedWalls>(UNCHANGED);
  /** What is asked for and of whom, so that it is asked once. */
  readonly #asked = new Map<Shown, { readonly of: Design; readonly key: string; readonly maker: MakerClient }>();
  /** How high and wide all is with walls, and what these were made on. */
  #beneath: { readonly value: Solid; readonly all: Extents | null; readonly drawn: Extents } | null = null;
  /** Who the parts were that were followed last. */
  #ids: readonly PartId[];
  readonly #later: Later;
  /** What is under the hand in a gesture, once it is on the stage. */
  readonly #held = computed(() => {
    const { design, inGesture } = this.#store;
    return inGesture && this.#surface.shown?.design === design ? design : null;
  });
  /** The same where the hand holds still. */
  readonly #still = signal<Design | null>(null);

  /** `later` is the clock by which a surface waits for its wall, and a hand holds still. One maker may be both. */
  constructor(store: Store, surface: Surface, maker: MakerClient, later: Later = timer, judge = maker) {
    this.#store = store;
    this.#surface = surface;
    this.#ids = store.ids;
    this.#later = later;
    this.maker = maker;
    this.judge = judge;
    const put = (piece: Piece<Quick>, parts: readonly number[] | null) => this.#putQuick(piece, parts);
    this.inStep = new InStep(store, surface, maker, put, later, () => this.#pieces.solid.peek());
  }

  /** Follows the document and its surface until what comes back is called. */
  connect(): () => void {
    this.#surface.accompany(this.inStep);
    const leaving = [effect(() => this.#hold()), effect(() => this.#follow())];
    return () => {
      for (const leave of leaving) leave();
      this.#surface.accompany(null);
      this.#rest();
    };
  }

  /** The pot with its wall. */
  get solid(): Piece<Solid> {
    return this.#pieces.solid.value;
  }

  /** Walls of some parts in place of those that the pot has there. */
  get changed(): ChangedWalls {
    return this.#changed.value;
  }

  /** Why the design as it is now has no wall, or one of its parts. */
  get wallProblem(): Refusal | null {
    const named = [this.changed, this.solid].find((piece) => this.isOfNow(piece) && piece.problem);
    return named?.problem ?? null;
  }

  get measures(): Piece<Measures> {
    return this.#pieces.measure.value;
  }

  get report(): Piece<Report> {
    return this.#pieces.check.value;
  }

  /** Whether the parts fit together; of a design of one part nothing. */
  get constraints(): Piece<Constraints> {
    return this.#pieces.constraints.value;
  }

  get painted(): Piece<Painted> {
    return this.#pieces.paint.value;
  }

  /** The map inside, at the vertices of the solid whose key begins its own. */
  get lining(): Piece<Lined> {
    return this.#pieces.lining.value;
  }

  get water(): Piece<Filled> {
    return this.#pieces.water.value;
  }

  /** How high and wide a design is whose surface was `drawn` so: with its wall, if it has one, and as it was measured, if that is known. */
  extentsOf(design: Design, drawn: Extents): Extents {
    const { measures } = this;
    const extents = this.#walled(design, drawn) ?? drawn;
    const measured = measures.of === design ? measures.value : null;
    if (!measured) return extents;
    const { height, width } = measured;
    return {
      ...extents,
      height: height.value,
      greatest: { ...extents.greatest, width: width.greatest.value },
      least: { ...extents.least, width: width.least.value },
    };
  }

  /** The same with its walls, and the parts that have none; of one whose walls went along what it is beyond its surface as it was where they were made. Null without one. */
  #walled(design: Design, drawn: Extents): Extents | null {
    const { value, of } = this.solid;
    if (!value || !of) return null;
    if (of === design) {
      if (this.#beneath?.value !== value || this.#beneath.drawn !== drawn) {
        const beside = unwalled(design, this.#surface.shown?.solved.parts ?? []).map(({ farthest }) => farthest);
        this.#beneath = { value, all: extentsTogether([value.farthest, ...beside]), drawn };
      }
      return this.#beneath.all;
    }
    const { all, drawn: then } = this.#beneath?.value === value ? this.#beneath : { all: null, drawn };
    if (!all || !areCarried(of.parts, design.parts)) return null;
    const span = (name: "greatest" | "least") => {
      const [wall, was, now] = [all[name], then[name], drawn[name]];
      return { ...now, low: now.low + (wall.low - was.low), width: now.width + (wall.width - was.width) };
    };
    return {
      bottom: drawn.bottom + (all.bottom - then.bottom),
      height: drawn.height + (all.height - then.height),
      greatest: span("greatest"),
      least: span("least"),
    };
  }

  /** Whether a piece is of the design as it is now; of an earlier one nothing is said. */
  isOfNow({ of }: Piece<unknown>): boolean {
    return of === this.#store.design;
  }

  /** How much the pot holds, in words; null while that is not known of the design as it is now. */
  get holds(): string | null {
    const { value, of } = this.measures;
    return value && of && this.isOfNow(this.measures) ? holdsText(value, unitOf(of)) : null;
  }

  /** How high the water is to stand, which its surface may still have to follow; null without water. */
  get level(): number | null {
    const { value, of, key } = this.water;
    const follows = key === QUICK && of === this.#surface.shown?.design;
    return this.#measured ?? (follows ? (value?.level ?? null) : null);
  }

  get #measured(): number | null {
    const { design, session } = this.#store;
    const range = this.measures.of === design ? this.waterRange : null;
    return range && session.fill !== null ? range.low + session.fill * (range.high - range.low) : null;
  }

  /** The heights between which water can stand; null when none can. */
  get waterRange(): { readonly low: number; readonly high: number } | null {
    return this.measures.value && waterRange(this.measures.value);
  }

  /** Finds out that the hand holds still. */
  #hold(): () => void {
    const held = this.#held.value;
    this.#still.value = null;
    if (!held) return () => {};
    return this.#later(() => {
      this.#still.value = held;
    }, STILL_MS);
  }

  #follow(): void {
    const { design, ids, session } = this.#store;
    const { shown } = this.#surface;
    // Measures of an earlier change are of some use until the new ones are there, those of another pot of none.
    const opened = !ids.some((id) => this.#ids.includes(id));
    this.#ids = ids;
    if (opened) this.#want("measure", null, "");
    const rests = shown?.settled === true && shown.design === design;
    const still = this.#still.value === design;
    const { of, value, key } = this.solid;
    const same = of !== null && sameSurface(of.parts, design.parts);
    const rewalled = same && of !== design;
    const walled = design.parts.some((part) => part.wall !== undefined);
    // A hand on the pot is told at once what it does to it.
    const pulled = walled && session.pulling;
    // Something else changed than what has a wall.
    if (rests && value && of && of !== design && key === "fine" && areUntouched(of.parts, design.parts)) {
      this.#put("solid", { ...this.solid, of: design });
      return;
    }
    // A wall that was only moved is there to be looked at until the fine one is.
    const there = () => of === design || (value !== null && of !== null && areCarried(of.parts, design.parts));
    if (rests || rewalled) this.#draw(walled ? design : null, rests && there());
    if (rests || rewalled || still) {
      const labelled = walled && session.overlays.axes;
      const looked = session.tab === "measures" || session.tab === "wall" || session.fill !== null || labelled;
      const measured = looked || pulled;
      this.#want("measure", measured ? { kind: "measure", design, product: "pot", fill: null } : null, "");
    }
    if (rests || still) {
      // Beside the wall's numbers only what would help a wall that is refused, and what of one was fitted.
      const fits = design.parts.some(({ wall }) => wall?.foot || wall?.drain);
      const refused = of === design && this.solid.problem !== null;
      const helped = session.tab === "wall" && (fits || refused);
      const checked = walled && (session.tab === "measures" || helped || pulled);
      this.#want("check", checked ? { kind: "check", design, making: {} } : null, "");
      this.#want("constraints", design.parts.length > 1 ? { kind: "constraints", design } : null, "");
    }
    if (rests) {
      const { map } = session;
      const { rows, columns } = this.#surface.grid(design);
      this.#want("paint", map ? { kind: "paint", design, map, rows, columns } : null, `${map} ${rows} ${columns}`);
      this.#line(design, map, rows, columns);
    }
    if (!this.#store.inGesture || rests || same) this.#pour();
    else if (!still) this.#hush();
  }

  /** A wall within the surface hides what the map shows of it: behind it lies the lining. What leans is known of every face by its normal. */
  #line(design: Design, map: MapName | null, rows: number, columns: number): void {
    const { value, of, key } = this.solid;
    const within = design.parts.some(({ wall }) => wall && wall.side !== "outside");
    if (!map || map === "overhang" || !within || !value || of !== design || key === QUICK) {
      this.#want("lining", null, "");
      return;
    }
    const mine = `${key} ${map} ${rows} ${columns}`;
    if (this.#has("lining", design, mine)) return;
    this.#want("lining", { kind: "lining", design, map, rows, columns, points: liningOf(value) }, mine);
  }

  /** The shape changes under the hand, which needs the machine for itself: what is under way would be of no use by its end. But for a wall that is still to come, and only has to be moved by then. */
  #hush(): void {
    const wall = this.#asked.get("solid");
    const awaited = this.solid.value === null && wall && areCarried(wall.of.parts, this.#store.design.parts);
    this.#rest(awaited ? "solid" : null);
  }

  /** Takes back what was asked, but for one thing. */
  #rest(stays: Shown | null = null): void {
    const asked = [...this.#asked].filter(([name]) => name !== stays);
    for (const [name] of asked) this.#asked.delete(name);
    for (const maker of new Set([this.maker, this.judge]))
      maker.cancel(...asked.filter(([, ask]) => ask.maker === maker).map(([name]) => name));
  }

  /** Coarsely at once, and finely once that is there and the hand rests. */
  #draw(design: Design | null, fine: boolean): void {
    const size = longest(this.#surface.shown?.solved);
    const tolerance = 2 ** (Math.floor(STEPS * Math.log2(size)) / STEPS) * (fine ? FINE : COARSE);
    // What was refused is not tried again, unless that was said in haste.
    if (design && fine && this.solid.value === null && this.solid.key !== QUICK) return;
    this.#want("solid", design && { kind: "solid", design, tolerance, fine }, fine ? "fine" : "coarse");
  }

  /** A wall that was dragged along, and its water; or the walls of some parts. */
  #putQuick({ value, of, problem }: Piece<Quick>, parts: readonly number[] | null): void {
    if (parts) {
      this.#changed.value = { value: value?.solid ?? null, of, problem, key: QUICK, parts };
      return;
    }
    batch(() => {
      if (value?.water) {
        const water = { ...value.water, volume: null, error: null };
        this.#put("water", { value: water, of, problem: null, key: QUICK });
      }
      this.#put("solid", { value: value?.solid ?? null, of, problem, key: QUICK });
    });
  }

  /** The water follows the hand as soon as its range is known. */
  #pour(): void {
    const { design, session } = this.#store;
    if (session.fill === null) {
      this.#want("water", null, "");
      return;
    }
    const level = this.#measured;
    if (level !== null) this.#want("water", { kind: "water", design, level }, String(level));
    else if (this.measures.of === design) this.#want("water", null, "");
  }

  /** Sees to it that a piece is there, or that it is not. */
  #want<K extends Shown>(name: K, ask: Extract<DesignAsk, { kind: K }> | null, key: string): void {
    const asked = this.#asked.get(name);
    if (!ask) {
      if (asked) {
        this.#asked.delete(name);
        asked.maker.cancel(name);
      }
      if (this.#pieces[name].value !== NOTHING) this.#put(name, NOTHING);
      return;
    }
    const { design }: DesignAsk = ask;
    if (asked ? asked.of === design && asked.key === key : this.#has(name, design, key)) return;
    const mine = { of: design, key, maker: this.#makerOf(name, design) };
    if (asked && asked.maker !== mine.maker) asked.maker.cancel(name);
    this.#asked.set(name, mine);
    void mine.maker.ask<Kind>(ask).then((outcome) => {
      const asked = this.#asked.get(name);
      if (asked === mine) this.#asked.delete(name);
      if (outcome.state === "superseded") return;
      const done = outcome.state === "done";
      if (asked !== mine && !(asked && done && SHOWN_LATE.includes(name))) return;
      this.#put(name, {
        value: done ? (outcome.value as Answers[K]) : null,
        of: design,
        problem: done ? null : outcome.refusal,
        key,
      });
    });
  }

  #makerOf(name: Shown, design: Design): MakerClient {
    const held = this.#still.peek() === design && (name === "check" || name === "measure");
    return held || name === "constraints" ? this.judge : this.maker;
  }

  #has(name: Shown, design: Design, key: string): boolean {
    const piece = this.#pieces[name].value;
    return piece.of === design && piece.key === key;
  }

  #put<K extends Shown>(name: K, piece: Piece<Answers[K]>): void {
    batch(() => {
      this.#pieces[name].value = piece;
      if (name === "solid") this.#changed.value = UNCHANGED;
    });
  }
}

/** Numbers of a vertex that say what the glaze goes by, of which the first is 1 in the lining. */
const WARES = 4;

/** Where the vertices of the lining are; NaN for all others. */
function liningOf({ positions, wares }: Solid): Float32Array {
  return positions.map((x, i) => (wares[WARES * Math.floor(i / 3)] === 1 ? x : Number.NaN));
}
