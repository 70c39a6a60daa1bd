/** The solver's worker: the only importer of the package. Answers one request after the other. */

import init, { derivatives, evaluate, fingerprint, link, mesh, PasuError, parse } from "pasu";
import type { Grid } from "../document/describe";
import { facts } from "../document/describe";
import type { Design, Part, Refusal } from "../document/types";
import { linesOf, tangentPoints } from "./lines";
import type { Answers, Ask, MeshArrays, Reply, Request, Section, Solved, SolveOptions } from "./messages";

const SECTION_POINTS = 129;
const TAU = 2 * Math.PI;

const ready = init();

self.addEventListener("message", (event: MessageEvent<Request>) => {
  void respond(event.data);
});

async function respond({ id, ask }: Request): Promise<void> {
  try {
    await ready;
    const answer = perform(ask);
    post({ id, ok: true, answer }, buffersOf(answer));
  } catch (error) {
    post({ id, ok: false, refusal: refusalOf(error), broken: error instanceof WebAssembly.RuntimeError }, []);
  }
}

function post(reply: Reply, transfer: Transferable[]): void {
  self.postMessage(reply, { transfer });
}

function perform(ask: Ask): Answers[Ask["kind"]] {
  switch (ask.kind) {
    case "solve":
      return solve(ask.design, ask.options);
    case "mesh":
      return arraysOf(ask.design, ask.rows, ask.columns);
    case "parse": {
      const design = parse(ask.text);
      return { design, link: link(design) };
    }
  }
}

function solve(design: Design, options: SolveOptions): Solved {
  const { rows, columns } = options;
  const made = arraysOf(design, rows, columns);
  const grids = gridsOf(made, rows, columns);
  const part = design.parts[options.part];
  return {
    mesh: made,
    lines: options.lines
      ? linesOf(
          grids,
          design.parts.map((each, index) => tangentsOf(design, each, index)),
        )
      : null,
    section: part ? sectionOf(design, part, options.part) : null,
    facts: facts(grids),
    fingerprint: options.settle ? fingerprint(design) : "",
    link: options.settle ? link(design) : "",
  };
}

function arraysOf(design: Design, rows: number, columns: number): MeshArrays {
  const { positions, normals, uvs, indices, groups } = mesh(design, { rows, columns });
  return { positions, normals, uvs, indices, groups };
}

/** Every part was sampled on the same grid, so its vertices follow those of the part before. */
function gridsOf(made: MeshArrays, rows: number, columns: number): readonly Grid[] {
  const parts = Math.round(made.positions.length / (3 * rows * columns));
  return Array.from({ length: parts }, (_, index) => ({
    positions: made.positions,
    first: index * rows * columns,
    rows,
    columns,
  }));
}

function spanOf({ shape }: Part): number {
  switch (shape.kind) {
    case "second-order":
    case "mixed-order":
      return 1;
    case "boundary-value":
      return shape.span === "2pi" ? TAU : shape.span;
    default:
      return TAU;
  }
}

function tangentsOf(design: Design, part: Part, index: number) {
  const points = tangentPoints(spanOf(part));
  return {
    at: evaluate(design, index, points),
    du: derivatives(design, index, points).du,
    place: part.place,
  };
}

function sectionOf(design: Design, part: Part, index: number): Section {
  const half = spanOf(part) / 2;
  const along = (v: number) => {
    const at = new Float64Array(2 * SECTION_POINTS);
    for (let i = 0; i < SECTION_POINTS; i += 1) at.set([i / (SECTION_POINTS - 1), v], 2 * i);
    return flat(evaluate(design, index, at));
  };
  const slopes = flat(derivatives(design, index, new Float64Array([0, 0, 1, 0])).du);
  return { right: along(0), left: along(half), slopes };
}

/** `x, z` of xyz triples. */
function flat(triples: Float64Array): Float64Array {
  const pairs = new Float64Array((2 * triples.length) / 3);
  for (let i = 0; 3 * i < triples.length; i += 1) pairs.set([triples[3 * i] ?? 0, triples[3 * i + 2] ?? 0], 2 * i);
  return pairs;
}

function refusalOf(error: unknown): Refusal {
  if (error instanceof PasuError) return { code: error.code, path: error.path, message: error.message };
  const message = error instanceof Error ? error.message : String(error);
  return { code: "internal", path: "", message: `The solver could not be used: ${message}` };
}

function buffersOf(answer: Answers[Ask["kind"]]): Transferable[] {
  if ("design" in answer) return [];
  const arrays = "mesh" in answer ? answer.mesh : answer;
  return [arrays.positions, arrays.normals, arrays.uvs, arrays.indices, arrays.groups].map((array) => array.buffer);
}
