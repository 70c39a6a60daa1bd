/** A solved design as the page has it: every part with its mesh where it stands, and what is known of all together. */

import { type Box, boxOf } from "../document/box";
import { extentsTogether, type Farthest, farthestOf } from "../document/extents";
import { type Facts, factsOf } from "../document/facts";
import { IDENTITY, type Matrix, matrixOf, placedAll } from "../document/placement";
import type { Design, Placement } from "../document/types";
import type { PartId } from "../state/part-ids";
import { around, type Bounds, boundsOfParts } from "./bounds";
import { placedLines } from "./lines";
import type { LineArrays, PartFacts, PartLines, PartMesh, Section, Times } from "./messages";

/** A part of a solved design. The same revision is the same mesh. */
export interface SolvedPart {
  readonly id: PartId;
  readonly revision: number;
  readonly mesh: PartMesh;
  /** From the mesh to where the part stands. */
  readonly matrix: Matrix;
  /** From which height to which that is. */
  readonly span: readonly [low: number, high: number];
  /** What it fills there; null where it has no points. */
  readonly box: Box | null;
  /** What it fills before it is placed. */
  readonly own: Bounds | null;
  /** Its farthest points where it stands. */
  readonly farthest: Farthest;
}

/** Parts in the order of the design, and what they fill. */
export interface SolvedParts {
  readonly parts: readonly SolvedPart[];
  readonly bounds: Bounds | null;
}

export interface Solved extends SolvedParts {
  /** Of every part. */
  readonly lines: readonly LineArrays[] | null;
  readonly section: Section | null;
  readonly facts: Facts | null;
  /** The largest distance of the triangles from the true surface; known once the gesture is over. */
  readonly bound: number | null;
  readonly fingerprint: string;
  readonly link: string;
  /** What the worker needed; null where nothing was asked of it. */
  readonly times: Times | null;
}

/** The longest of height, width and depth; 1 while that is not known. Patches have no foot and no rim, of which facts are told. */
export function longest(solved: Pick<Solved, "facts" | "bounds"> | undefined): number {
  const { facts, bounds } = solved ?? {};
  if (facts) return Math.max(facts.height, facts.width, facts.depth);
  return bounds ? Math.max(...bounds.max.map((most, axis) => most - (bounds.min[axis] ?? most))) : 1;
}

/** How far it goes along x; 1 while that is not known. */
export function widthOf(solved: Pick<Solved, "bounds"> | undefined): number {
  const bounds = solved?.bounds;
  return bounds ? bounds.max[0] - bounds.min[0] : 1;
}

let revisions = 0;

/** A number for a mesh that no mesh before had. */
export function nextRevision(): number {
  revisions += 1;
  return revisions;
}

/** What there is of one part. */
export interface PartAnswer {
  readonly id: PartId;
  readonly revision: number;
  readonly mesh: PartMesh;
  readonly told: PartFacts;
  readonly lines: PartLines | null;
}

/** Puts parts where a design has them, which are in its order. */
export function placedParts(design: Design, answers: readonly PartAnswer[]): SolvedParts & Pick<Solved, "facts"> {
  const standing = answers.map(({ told, ...answer }, place) => ({
    answer,
    told,
    bounds: told.bounds,
    ...standingOf(told.reach, design.parts[place]?.place),
  }));
  const bounds = boundsOfParts(standing);
  const extents = extentsTogether(standing.map(({ farthest }) => farthest));
  const lifted = standing.map(({ told: { body, closed }, matrix }) => ({ body, closed, lift: matrix[14] ?? 0 }));
  return {
    parts: standing.map(({ answer: { id, revision, mesh }, bounds: own, matrix, box, farthest }) => ({
      id,
      revision,
      mesh,
      matrix,
      span: box ? [box.min[2], box.max[2]] : [0, 0],
      box,
      own,
      farthest,
    })),
    bounds,
    facts: bounds && extents && factsOf(lifted, bounds, extents),
  };
}

/** The parts that have no wall: what is made of walls tells nothing of them. */
export function unwalled(design: Design, parts: readonly SolvedPart[]): readonly SolvedPart[] {
  return parts.filter((_, place) => design.parts[place]?.wall === undefined);
}

/** What walls fill together with the parts that have none. */
export function boundsWith(walls: Bounds | null, design: Design, parts: readonly SolvedPart[]): Bounds | null {
  const standing = unwalled(design, parts).map(({ matrix, own: bounds, box }) => ({ matrix, bounds, box }));
  return around(walls, boundsOfParts(standing));
}

/** Where a part stands by its placement, and how far it reaches there. */
interface Stood {
  readonly place: Placement | undefined;
  readonly matrix: Matrix;
  readonly box: Box | null;
  readonly farthest: Farthest;
}

/** Of many parts one is moved: where the others stand is found once for each mesh and placement. */
const stood = new WeakMap<Float32Array, Stood>();

function standingOf(reach: Float32Array, place: Placement | undefined): Stood {
  const known = stood.get(reach);
  if (known && known.place === place) return known;
  const matrix = matrixOf(place) ?? IDENTITY;
  const placed = placedAll(matrix, reach);
  const found = { place, matrix, box: boxOf(placed), farthest: farthestOf(placed) };
  stood.set(reach, found);
  return found;
}

/** The lines of each part where it stands; null where they are not all there. */
export function linesOfParts(design: Design, answers: readonly PartAnswer[]): readonly LineArrays[] | null {
  const placed: LineArrays[] = [];
  for (const [place, { lines }] of answers.entries()) {
    if (!lines) return null;
    placed.push(placedLines(lines, matrixOf(design.parts[place]?.place) ?? IDENTITY));
  }
  return placed;
}

/** How many vertices the meshes have together. */
export function verticesOf(parts: readonly SolvedPart[]): number {
  return parts.reduce((sum, { mesh }) => sum + mesh.positions.length / 3, 0);
}
