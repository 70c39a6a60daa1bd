/** What the solver's worker answers. */

import {
  bound,
  convert,
  derivatives,
  evaluate,
  fingerprint,
  handles,
  link,
  type Mesh,
  mesh,
  PasuError,
  parse,
} from "pasu/drawing";
import { bodyOf, type Grid, isClosed } from "../document/body";
import { placedNormals } from "../document/placed-normals";
import { matrixOf, placedAll } from "../document/placement";
import { SHAPES } from "../document/tables.gen";
import type { Blend, Section as BlendSection, Sent, SentShape, Shape, TwoSided, Wall } from "../document/types";
import { type GridSize, highestFrequency } from "../document/waves";
import { boundsOf } from "./bounds";
import { linesOf, tangentPoints } from "./lines";
import type {
  Ask,
  MeshWanted,
  PartAsk,
  PartFacts,
  PartLines,
  Request,
  Section,
  SentAnswers,
  SentMesh,
  SentPart,
  SentPartAsk,
  SentParts,
  SentPartsAsk,
  SentWholeAsk,
  Spare,
} from "./messages";
import type { Moved } from "./moved";
import { reachOf } from "./reach";
import { WARE_SIZE, ware } from "./ware";

const SECTION_POINTS = 129;
const TAU = 2 * Math.PI;

/** The last coarse mesh, written over by every next one; it never leaves the worker. */
let coarse: Partial<Mesh> = {};

/** What takes shapes of patches is fetched with the module that solves them; until then it is left out. */
let patchwork: typeof import("./patchwork") | null = null;

export async function fetchPatchwork(): Promise<void> {
  patchwork ??= await import("./patchwork");
}

function withPatchwork(): typeof import("./patchwork") {
  if (patchwork) return patchwork;
  throw new PasuError("unsupported-shape", "", "", { args: { what: "left-out" } });
}

export function perform(request: Request): SentAnswers[Ask["kind"]] {
  const { ask } = request;
  switch (ask.kind) {
    case "parts":
      return solve(ask, request);
    case "parse": {
      const design = parse(ask.text);
      return { design, link: linkOf(design) };
    }
    case "read": {
      const design = alone(ask.shape);
      return { points: evaluate(design, 0, ask.at), du: derivatives(design, 0, ask.at).du };
    }
    case "convert":
      return convert(ask.shape as SentShape, ask.order);
  }
}

/** The link of a design; empty for one that is too large for any. */
function linkOf(design: Sent | string): string {
  try {
    return link(design);
  } catch (error) {
    if (error instanceof PasuError && error.code === "too-large" && error.args?.what === "link") return "";
    throw error;
  }
}

/** How long each kind of thing took, all parts together. */
interface Spent {
  meshes: number;
  coarse: number;
}

function solve({ parts, whole }: SentPartsAsk, { known, spares }: Pick<Request, "known" | "spares">): SentParts {
  const begun = now();
  // The document is read as a whole before any of its parts, so that it is refused as a whole.
  const text = whole && readable(whole.design);
  const address = text ? linkOf(text) : "";
  // Of a long text all is asked that there is to be asked before another one is read.
  const long = whole && typeof text === "string" ? told(text, whole) : null;
  const read = now();
  const spent: Spent = { meshes: 0, coarse: 0 };
  const here = new Set(known);
  const sent = parts.map((part, index) => named(part.place, () => solved(part, spares[index] ?? null, here, spent)));
  const all = whole && text ? { ...(long ?? told(text, whole)), link: address } : null;
  const meshed = read + spent.meshes;
  return { parts: sent, whole: all, times: { begun, meshed, glazed: meshed + spent.coarse, done: now() } };
}

/** A design as it is read. */
function readable(design: SentWholeAsk["design"]): Sent | string {
  return design.parts.some(({ shape }) => isPatchwork(shape)) ? withPatchwork().readable(design) : (design as Sent);
}

function isPatchwork(shape: Shape | Moved): shape is Moved | Exclude<Shape, TwoSided | Blend> {
  return shape.kind === "moved" || shape.kind === "vertex-frame" || shape.kind === "octant";
}

function told(design: Sent | string, { rows, columns }: GridSize) {
  return { bound: bound(design, { rows, columns }), fingerprint: fingerprint(design) };
}

/** What a part is refused for is told of the place that it has in the design. */
function named<T>(place: number, run: () => T): T {
  try {
    return run();
  } catch (error) {
    if (!(error instanceof PasuError)) throw error;
    throw Object.assign(error, { path: error.path.replace(/^parts\[0\]/, `parts[${place}]`) });
  }
}

function now(): number {
  return performance.timeOrigin + performance.now();
}

/** The design of one shape. */
function alone(shape: Shape): Sent {
  return { pasu: 1, parts: [{ shape: shape as SentShape }] };
}

/** Any wall: what is drawn of a part goes by whether there is one, and not by how thick. */
const A_WALL: Wall = { thickness: 1, base: 0 };

/** The flank of a solid, without its ends. */
function flankOf(shape: Shape): Sent {
  return { pasu: 1, parts: [{ shape: shape as SentShape, wall: A_WALL }] };
}

function solved(part: SentPartAsk, spare: Spare | null, here: Set<string>, spent: Spent): SentPart {
  return hasTwoEnds(part) ? between(part, spare, here, spent) : withPatchwork().patched(part, here, spent);
}

/** Whether it goes from one end to another: of blends what is between two closed curves. Any other blend stays a solid, of which making a pot is refused. */
function hasTwoEnds(part: SentPartAsk): part is PartAsk & { readonly shape: TwoSided | Blend } {
  const { shape, hollow } = part;
  if (shape.kind !== "blend") return !isPatchwork(shape);
  const closed = ({ form }: BlendSection) => form === "disc" || form === "outline";
  return hollow && closed(shape.start) && closed(shape.end);
}

/** A surface between two ends. */
function between(
  part: PartAsk & { readonly shape: TwoSided | Blend },
  spare: Spare | null,
  here: Set<string>,
  spent: Spent,
): SentPart {
  const { id, shape } = part;
  const design = part.hollow ? flankOf(shape) : alone(shape);
  const made = part.mesh && meshed(design, part, part.mesh, spare, here, spent);
  const { mesh: sent = null, told: about = null, grid } = made ?? {};
  return {
    id,
    mesh: sent,
    told: about,
    lines:
      part.mesh?.lines && grid ? linesOf(grid, shape.kind === "blend" ? NO_TANGENTS : tangentsOf(design, shape)) : null,
    section: part.section && shape.kind !== "blend" ? sectionOf(design, shape) : null,
  };
}

const NO_TANGENTS: PartLines["tangents"] = { at: new Float64Array(), along: new Float64Array() };

function meshed(
  design: Sent,
  { shape, turn }: PartAsk,
  { rows, columns, ware: size, exact }: MeshWanted,
  spare: Spare | null,
  here: Set<string>,
  spent: Spent,
): { readonly mesh: SentMesh; readonly told: PartFacts; readonly grid: Grid } {
  const begun = now();
  const guess = [...here].at(-1);
  // A longer array would do, but a grid that became coarse is not to hold the memory of a fine one.
  const fits = spare?.positions.length === 3 * rows * columns;
  const made = mesh(design, {
    rows,
    columns,
    into: { ...(fits && { positions: spare.positions, normals: spare.normals }), ...(guess && { topology: guess }) },
  });
  const { positions, normals, topology, uvs, indices } = made;
  const fine = now();
  // What is given and still holds is handed back: this mesh is always whole.
  const round = mesh(design, { ...size, into: coarse }) as Mesh;
  coarse = round;
  const done = now();
  spent.meshes += fine - begun;
  spent.coarse += done - fine;
  const matrix = turn ? matrixOf(turn) : null;
  const turned = (points: Float32Array) => (matrix ? placedAll(matrix, points) : points);
  const wide = { positions: turned(round.positions), ...size };
  const length = WARE_SIZE * size.rows * size.columns;
  const texels = spare?.texels.length === length ? spare.texels : new Float32Array(length);
  ware({ ...wide, normals: matrix ? placedNormals(matrix, round.normals) : round.normals }, size, texels);
  const lattice = uvs && indices && !here.has(topology) ? { uvs, indices } : null;
  here.add(topology);
  // Under the hand the coarse mesh will do: its corners stand on crests and troughs.
  const sample = exact ? positions : round.positions;
  return {
    mesh: { positions, normals, topology, ware: { texels, ...size }, lattice },
    told: {
      bounds: boundsOf(sample, round.positions),
      reach: reachOf(sample, matrix),
      closed: isClosed(wide),
      body: bodyOf(wide, edgesOf(design, shape, wide, turned)),
    },
    grid: { positions, rows, columns },
  };
}

/** Samples per wave, with which every crest and trough is met nearly enough to be counted. */
const PER_WAVE = 16;

/** With more waves than this no eye counts petals, and no grid is made to do so. */
const MOST_COUNTED = 4000;

/** The rim and the foot, sampled finely enough for their waves; null where those are too many. */
function edgesOf(
  design: Sent,
  shape: Shape,
  wide: Grid,
  turned: (points: Float32Array) => Grid["positions"],
): Grid | null {
  const waves = Math.max(1, highestFrequency(shape));
  if (wide.columns > PER_WAVE * waves) return wide;
  if (!(waves <= MOST_COUNTED)) return null;
  const size: GridSize = { rows: 2, columns: PER_WAVE * Math.ceil(waves) + 1 };
  return { positions: turned(mesh(design, size).positions), ...size };
}

function spanOf(shape: TwoSided): number {
  if (shape.kind === "rings") return TAU;
  const { span } = shape.kind === "boundary-value" ? shape : SHAPES[shape.kind];
  return span === "2pi" ? TAU : span;
}

function tangentsOf(design: Sent, shape: TwoSided) {
  const points = tangentPoints(spanOf(shape));
  return { at: evaluate(design, 0, points), along: derivatives(design, 0, points).du };
}

function sectionOf(design: Sent, shape: TwoSided): Section {
  const half = spanOf(shape) / 2;
  const along = (v: number) => {
    const at = new Float64Array(2 * SECTION_POINTS);
    for (let i = 0; i < SECTION_POINTS; i += 1) at.set([i / (SECTION_POINTS - 1), v], 2 * i);
    return flat(evaluate(design, 0, at));
  };
  const slopes = flat(derivatives(design, 0, new Float64Array([0, 0, 1, 0])).du);
  return { right: along(0), left: along(half), slopes, handles: handles(shape as SentShape) };
}

/** `x, z` of xyz triples. */
function flat(triples: Float64Array): Float64Array {
  const pairs = new Float64Array((2 * triples.length) / 3);
  for (let i = 0; 3 * i < triples.length; i += 1) pairs.set([triples[3 * i] ?? 0, triples[3 * i + 2] ?? 0], 2 * i);
  return pairs;
}

/** What travels with an answer. */
export function buffersOf(answer: SentAnswers[Ask["kind"]]): Transferable[] {
  if (!("parts" in answer)) return [];
  return answer.parts.flatMap(({ mesh: sent }) => {
    if (!sent) return [];
    const { positions, normals, ware: wares, lattice } = sent;
    const arrays = [positions, normals, wares.texels, ...(lattice ? [lattice.uvs, lattice.indices] : [])];
    return arrays.map((array) => array.buffer);
  });
}
