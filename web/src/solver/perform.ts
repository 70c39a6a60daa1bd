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
  parse,
} from "pasu/drawing";
import type { Grid } from "../document/facts";
import { facts } from "../document/facts";
import { SHAPES } from "../document/tables.gen";
import type { Part, Sent, SentShape } from "../document/types";
import { type GridSize, wavesOf } from "../document/waves";
import { boundsOf } from "./bounds";
import { linesOf, tangentPoints } from "./lines";
import type { Ask, Request, Section, SentAnswers, SentMesh, Solved, SolveOptions } from "./messages";
import { WARE_SIZE, type Ware, ware, wareGrid } from "./ware";

const SECTION_POINTS = 129;
const TAU = 2 * Math.PI;

/** The last coarse mesh, written over by every next one; it never leaves the worker. */
let coarse: Partial<Mesh> = {};

export function perform(request: Request): SentAnswers[Ask["kind"]] {
  const { ask } = request;
  switch (ask.kind) {
    case "solve":
      return solve(ask.design as Sent, ask.options, request);
    case "mesh":
      return meshed(ask.design as Sent, ask, request, true).mesh;
    case "parse": {
      const design = parse(ask.text);
      return { design, link: link(design) };
    }
    case "convert":
      return convert(ask.shape as SentShape, ask.order);
  }
}

function solve(design: Sent, options: SolveOptions, given: Given): Solved<SentMesh> {
  const begun = now();
  const made = meshed(design, options, given, options.settle);
  const { bounds, positions } = made.mesh;
  const part = options.section === null ? undefined : design.parts[options.section];
  return {
    mesh: made.mesh,
    lines: options.lines
      ? linesOf(
          gridsOf(positions, options),
          design.parts.map((each, index) => tangentsOf(design, each, index)),
        )
      : null,
    section: part && options.section !== null ? sectionOf(design, part, options.section) : null,
    facts:
      bounds &&
      facts(
        gridsOf(made.coarse, made.mesh.ware),
        bounds,
        options.settle ? positions : made.coarse,
        edgesOf(design, made),
      ),
    bound: options.settle ? bound(design, { rows: options.rows, columns: options.columns }) : null,
    fingerprint: options.settle ? fingerprint(design) : "",
    link: options.settle ? link(design) : "",
    times: { begun, ...made.times, done: now() },
  };
}

function now(): number {
  return performance.timeOrigin + performance.now();
}

/** What a request brings along. */
type Given = Pick<Request, "known" | "spare">;

function meshed(design: Sent, { rows, columns }: GridSize, { known, spare }: Given, exact: boolean) {
  const guess = spare && known.includes(spare.topology) ? spare.topology : known.at(-1);
  // A longer array would do, but a grid that became coarse is not to hold the memory of a fine one.
  const fits = spare?.positions.length === 3 * rows * columns * design.parts.length;
  const made = mesh(design, {
    rows,
    columns,
    into: { ...(fits && { positions: spare.positions, normals: spare.normals }), ...(guess && { topology: guess }) },
  });
  const meshedAt = now();
  const { positions, normals, topology, uvs, indices, groups } = made;
  const size = wareGrid(design.parts.length, wavesOf(design));
  // What is given and still holds is handed back: this mesh is always whole.
  const round = mesh(design, { ...size, into: coarse }) as Mesh;
  coarse = round;
  const glazed = now();
  return {
    mesh: {
      positions,
      normals,
      topology,
      ware: wareOf(round, size, spare?.texels),
      // Under the hand the coarse mesh will do: its corners stand on crests and troughs.
      bounds: boundsOf(exact ? positions : round.positions, round.positions),
      lattice: uvs && indices && groups && !known.includes(topology) ? { uvs, indices, groups } : null,
    } satisfies SentMesh,
    coarse: round.positions,
    times: { meshed: meshedAt, glazed },
  };
}

/** Samples per wave, with which every crest and trough is met nearly enough to be counted. */
const PER_WAVE = 16;

/** With more waves than this no eye counts petals, and no grid is made to do so. */
const MOST_COUNTED = 4000;

/** The rim and the foot of the first part, sampled finely enough for its waves; null where those are too many. */
function edgesOf(design: Sent, made: { readonly coarse: Float32Array; readonly mesh: SentMesh }): Grid | null {
  const waves = wavesOf(design);
  const [first] = gridsOf(made.coarse, made.mesh.ware);
  if (first && first.columns > PER_WAVE * waves) return first;
  const part = design.parts[0];
  if (!part || !(waves <= MOST_COUNTED)) return null;
  const [rows, columns] = [2, PER_WAVE * Math.ceil(waves) + 1];
  const { positions } = mesh({ ...design, parts: [part] }, { rows, columns });
  return { positions, first: 0, rows, columns };
}

function wareOf(round: Mesh, size: GridSize, old: Float32Array | undefined): Ware {
  const length = (WARE_SIZE * round.positions.length) / 3;
  const texels = old?.length === length ? old : new Float32Array(length);
  ware(round, size, texels);
  return { texels, ...size };
}

/** Every part was sampled on the same grid, so its vertices follow those of the part before. */
function gridsOf(positions: Float32Array, { rows, columns }: GridSize): readonly Grid[] {
  const parts = Math.round(positions.length / (3 * rows * columns));
  return Array.from({ length: parts }, (_, index) => ({ positions, first: index * rows * columns, rows, columns }));
}

function spanOf({ shape }: Part): number {
  const { span } = shape.kind === "boundary-value" ? shape : SHAPES[shape.kind];
  return span === "2pi" ? TAU : span;
}

function tangentsOf(design: Sent, part: Part, index: number) {
  const points = tangentPoints(spanOf(part));
  return {
    at: evaluate(design, index, points),
    du: derivatives(design, index, points).du,
    place: part.place,
  };
}

function sectionOf(design: Sent, part: Part, index: number): Section {
  const half = spanOf(part) / 2;
  const along = (v: number) => {
    const at = new Float64Array(2 * SECTION_POINTS);
    for (let i = 0; i < SECTION_POINTS; i += 1) at.set([i / (SECTION_POINTS - 1), v], 2 * i);
    return flat(evaluate(design, index, at));
  };
  const slopes = flat(derivatives(design, index, new Float64Array([0, 0, 1, 0])).du);
  return { right: along(0), left: along(half), slopes, handles: handles(part.shape as SentShape) };
}

/** `x, z` of xyz triples. */
function flat(triples: Float64Array): Float64Array {
  const pairs = new Float64Array((2 * triples.length) / 3);
  for (let i = 0; 3 * i < triples.length; i += 1) pairs.set([triples[3 * i] ?? 0, triples[3 * i + 2] ?? 0], 2 * i);
  return pairs;
}

/** What travels with an answer. */
export function buffersOf(answer: SentAnswers[Ask["kind"]]): Transferable[] {
  if ("design" in answer || "lost" in answer) return [];
  const { positions, normals, ware: wares, lattice } = "mesh" in answer ? answer.mesh : answer;
  const arrays = [positions, normals, wares.texels, ...(lattice ? [lattice.uvs, lattice.indices, lattice.groups] : [])];
  return arrays.map((array) => array.buffer);
}
