/**
 * What one stage has of its design: the meshes of its parts, by their identities. Only what is not there or is different is asked of the worker, and
 * a part that is moved costs nothing there.
 */

import { matrixOf, turnOf, turnsAlike } from "../document/placement";
import type { Design, Part, Placement, Shape } from "../document/types";
import { type GridSize, highestFrequency } from "../document/waves";
import type { Identified, PartId } from "../state/part-ids";
import type { Outcome } from "../worker/port";
import type {
  PartAsk,
  PartFacts,
  PartMesh,
  PartsAsk,
  Section,
  SentMesh,
  SentParts,
  Used,
  Whole,
  WholeAsk,
} from "./messages";
import { linesOfParts, nextRevision, type PartAnswer, placedParts, type Solved } from "./solved";
import { wareGrid } from "./ware";
import { rewrite } from "./written";

export interface SolveOptions extends GridSize {
  /** Whether the overlay lines are wanted. */
  readonly lines: boolean;
  /** The part whose section is wanted, if any. */
  readonly section: number | null;
  /** Whether the gesture is over: every part is as fine as it is asked for then, and link and fingerprint are known. */
  readonly settle: boolean;
}

/** One part as it was solved. */
interface Kept extends PartAnswer {
  readonly shape: Shape;
  readonly hollow: boolean;
  readonly turn: Placement | undefined;
  readonly exact: boolean;
  /** The rows and columns that were asked for. */
  readonly grid: GridSize;
  readonly section: Section | null;
  /** By what the worker knows its mesh again. */
  readonly serial: number | undefined;
}

/** What is asked when its turn comes, and what becomes of the answer. */
export interface Task<T> {
  /** What is not there by now; null where nothing is asked. */
  ask(): PartsAsk | null;
  /** What there is with the answer; undefined where something has gone meanwhile and has to be asked for again. */
  take(answer: SentParts | null, whole: (mesh: SentMesh) => PartMesh): T | undefined;
}

/** How a desk has its tasks done: the latest wins. */
export interface Desktop {
  solve(lane: object, task: Task<Solved>): Promise<Outcome<Solved>>;
  recycle(mesh: Used): void;
}

export class Desk {
  readonly #solver: Desktop;
  #kept = new Map<PartId, Kept>();
  /** Parts that were found to stand as they are told to. */
  #stood: readonly Part[] = [];
  /** What is known of the design that was last at rest. */
  #rest: { readonly asked: WholeAsk; readonly whole: Whole } | null = null;

  constructor(solver: Desktop) {
    this.#solver = solver;
  }

  solve(scene: Identified, options: SolveOptions): Promise<Outcome<Solved>> {
    let asked: PartsAsk | null = null;
    return this.#solver.solve(this, {
      ask: () => {
        asked = this.#missing(scene, options);
        return asked;
      },
      take: (answer, whole) => {
        if (answer && asked) this.#keep(asked, answer, whole);
        return this.#whole(scene, options, answer);
      },
    });
  }

  /** Takes back a mesh that nobody shows any more, to be written over; one that is still the newest of its part stays. */
  recycle(mesh: Used): void {
    for (const kept of this.#kept.values()) if (kept.mesh === mesh) return;
    this.#solver.recycle(mesh);
  }

  #missing({ design, ids }: Identified, options: SolveOptions): PartsAsk | null {
    const parts = design.parts.flatMap((part, place): PartAsk[] => {
      const id = ids[place] as PartId;
      const kept = this.#kept.get(id);
      const known = isOf(kept, part);
      // Under the hand a mesh of the very shape will do, however fine: of hundreds of parts that nobody touches no more is asked.
      const does = known && !options.settle && (!options.lines || kept.lines !== null);
      if (does && options.section !== place) return [];
      const wanted = meshWanted(design, part, options);
      const there = known && this.#serves(kept, part, options, wanted);
      const section =
        !isWithoutSection(part.shape) && options.section === place && !(kept?.shape === part.shape && kept.section);
      if (there && !section) return [];
      const has = kept && sameGrid(kept.grid, wanted) ? kept.serial : undefined;
      return [askOf(part, id, place, there ? null : { ...wanted, ...(has !== undefined && { has }) }, section)];
    });
    // What cannot stand as it is told to is for the solver to refuse, under the hand too.
    const stands = design.parts.every(({ place }, at) => place === this.#stood[at]?.place || matrixOf(place) !== null);
    if (stands) this.#stood = design.parts;
    const whole = options.settle || !stands ? wholeOf(design, options) : null;
    const known = whole !== null && this.#knows(whole);
    if (parts.length === 0 && (whole === null || known)) return null;
    return { kind: "parts", parts, whole: known ? null : whole };
  }

  /** Whether a mesh of the very shape will do. Under the hand any will. */
  #serves(kept: Kept, { place }: Part, { settle }: SolveOptions, wanted: NonNullable<PartAsk["mesh"]>): boolean {
    if (wanted.lines && !kept.lines) return false;
    if (!settle) return true;
    const { ware } = kept.mesh;
    return (
      kept.exact &&
      sameGrid(kept.grid, wanted) &&
      sameGrid(ware, wanted.ware) &&
      // How its glaze runs, and what is said of it, goes by how it stands.
      turnsAlike(kept.turn, turnOf(place))
    );
  }

  #knows(whole: WholeAsk): boolean {
    const { asked } = this.#rest ?? {};
    return asked?.design === whole.design && sameGrid(asked, whole);
  }

  #keep(asked: PartsAsk, answer: SentParts, whole: (mesh: SentMesh) => PartMesh): void {
    for (const [index, { id, mesh, change, told, lines, section }] of answer.parts.entries()) {
      const ask = asked.parts[index];
      if (!ask) continue;
      const { shape, hollow, turn } = ask;
      const old = this.#kept.get(id);
      const all = mesh ? whole(mesh) : old?.mesh;
      if (all && (mesh || change) && told && ask.mesh) {
        const { exact, rows, columns } = ask.mesh;
        const had = old?.shape === shape ? old.section : null;
        const revision = nextRevision();
        if (change && old) {
          rewrite(all.positions, change.positions, change.ranges);
          rewrite(all.normals, change.normals, change.ranges);
          all.writes?.note(old.revision, revision, change.ranges);
        }
        this.#kept.set(id, {
          id,
          revision,
          mesh: all,
          told: change && old ? stillTold(old.told, told) : told,
          lines,
          shape,
          hollow,
          turn,
          // Of a network all vertices are told of, under the hand too.
          exact: exact || shape.kind === "vertex-frame",
          grid: { rows, columns },
          section: section ?? had,
          serial: (mesh ?? change)?.serial,
        });
      } else if (old && section) this.#kept.set(id, { ...old, section });
    }
    if (asked.whole && answer.whole) this.#rest = { asked: asked.whole, whole: answer.whole };
  }

  /** The design with what there is of it, which is all that is kept from now on. */
  #whole({ design, ids }: Identified, options: SolveOptions, answer: SentParts | null): Solved | undefined {
    const found: Kept[] = [];
    for (const [place, part] of design.parts.entries()) {
      const kept = this.#kept.get(ids[place] as PartId);
      if (!isOf(kept, part)) return undefined;
      found.push(kept);
    }
    this.#kept = new Map(found.map((kept) => [kept.id, kept]));
    const rest = options.settle && this.#rest?.asked.design === design ? this.#rest.whole : null;
    const { bound = null, fingerprint = "", link = "" } = rest ?? {};
    return {
      ...placedParts(design, found),
      lines: options.lines ? linesOfParts(design, found) : null,
      section: options.section === null ? null : (found[options.section]?.section ?? null),
      bound,
      fingerprint,
      link,
      times: answer?.times ?? null,
    };
  }
}

/** What was told before where it is the same: what follows from it is known then. */
function stillTold(before: PartFacts, now: PartFacts): PartFacts {
  const { reach } = before;
  const same = reach.length === now.reach.length && reach.every((value, place) => value === now.reach[place]);
  return same ? { ...now, reach } : now;
}

/** What has no foot and no rim: there is no section through it. */
function isWithoutSection({ kind }: Shape): boolean {
  return kind === "vertex-frame" || kind === "blend" || kind === "octant";
}

/** How the mesh of one part is wanted. */
export function meshWanted(
  design: Design,
  { shape }: Part,
  { rows, columns, lines, settle }: Pick<SolveOptions, "rows" | "columns" | "lines" | "settle">,
): NonNullable<PartAsk["mesh"]> {
  const waves = Math.max(1, highestFrequency(shape));
  return { rows, columns, ware: wareGrid(design.parts.length, waves), lines, exact: settle };
}

export function askOf(part: Part, id: PartId, place: number, mesh: PartAsk["mesh"], section: boolean): PartAsk {
  const { shape, place: stands } = part;
  return { id, place, shape, hollow: isHollow(part), turn: turnOf(stands), mesh, section };
}

/** Whether a wall takes the ends away that a solid has: a surface has none. */
function isHollow({ shape, wall }: Part): boolean {
  return shape.kind === "blend" && wall !== undefined;
}

function isOf(kept: Kept | undefined, part: Part): kept is Kept {
  return kept?.shape === part.shape && kept.hollow === isHollow(part);
}

function wholeOf(design: Design, { rows, columns }: GridSize): WholeAsk {
  return { design, rows, columns };
}

function sameGrid(a: GridSize, b: GridSize): boolean {
  return a.rows === b.rows && a.columns === b.columns;
}
