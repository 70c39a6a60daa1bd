/**
 * Shapes of patches as the solver's worker answers them: they have no grid of their own, and what goes by rows from foot to rim is not there. Fetched with the module that solves them.
 *
 * Of a large network whose points are moved, nothing is read, sampled or sent but what moves.
 */

import { type Followed, follow, mesh } from "pasu/drawing";
import type { Sent, SentShape, Shape } from "../document/types";
import { boundsOf } from "./bounds";
import type {
  MeshChange,
  MeshWanted,
  PartFacts,
  PartLines,
  SentMesh,
  SentPart,
  SentPartAsk,
  SentWholeAsk,
} from "./messages";
import { isLarge, type Moved, Receiver } from "./moved";
import { boxesOf, reachOf, rebox } from "./reach";
import { evenWare } from "./ware";
import { rewrite } from "./written";

const receiver = new Receiver();

/** The network whose mesh was sent last, as it was then. */
interface Held {
  readonly shape: Shape;
  readonly rows: number;
  readonly columns: number;
  readonly moved: Followed["moved"];
  readonly serial: number;
  /** A copy of what was sent. */
  readonly positions: Float32Array;
  readonly boxes: Float32Array;
}

let held: Held | null = null;
let serials = 0;

const NO_LINES: PartLines = {
  iso_u: [],
  iso_v: [],
  ends: [new Float32Array(), new Float32Array()],
  tangents: { at: new Float64Array(), along: new Float64Array() },
};

/** The design that was meant, as text where reading every number of it by itself would take longer than solving it. */
export function readable(design: SentWholeAsk["design"]): Sent | string {
  const parts = design.parts.map((part) => ({ ...part, shape: receiver.unpack(part.shape) }));
  const meant = { ...design, parts } as Sent;
  return parts.some(({ shape }) => isLarge(shape)) ? JSON.stringify(meant) : meant;
}

/** How long meshes took is added to `spent`. */
export function patched(
  { id, shape: sent, mesh: wanted }: SentPartAsk,
  here: Set<string>,
  spent: { meshes: number },
): SentPart {
  const before = receiver.last;
  const shape = receiver.unpack(sent);
  if (!wanted) return { id, mesh: null, told: null, lines: null, section: null };
  const begun = performance.now();
  const change = sent.kind === "moved" ? changed(before, shape, sent, wanted) : null;
  const made = change ?? whole(shape, wanted, here);
  spent.meshes += performance.now() - begun;
  return { id, mesh: null, ...made, lines: NO_LINES, section: null };
}

/** What of the mesh that the page has is another, where that is known. */
function changed(before: Shape | null, shape: Shape, { vertices, points }: Moved, { rows, columns, has }: MeshWanted) {
  if (held?.shape !== before || held.serial !== has || held.rows !== rows || held.columns !== columns) return null;
  const last = held;
  // Whatever is refused on the way, the next mesh is sent as a whole.
  held = null;
  const moves = new Float64Array(4 * vertices.length);
  for (const [place, vertex] of vertices.entries()) {
    moves[4 * place] = vertex;
    moves.set(points.subarray(3 * place, 3 * place + 3), 4 * place + 1);
  }
  const change = last.moved(moves);
  if (!change) return null;
  const { ranges } = change;
  rewrite(last.positions, change.positions, ranges);
  for (let pair = 0; pair < ranges.length; pair += 2)
    rebox(last.positions, last.boxes, ranges[pair] ?? 0, ranges[pair + 1] ?? 0);
  serials += 1;
  held = { ...last, shape, serial: serials };
  return { change: { ...change, serial: serials } satisfies MeshChange, told: toldOf(last.positions, last.boxes) };
}

function whole(shape: Shape, { rows, columns, ware: size }: MeshWanted, here: Set<string>) {
  const design: Sent = { pasu: 1, parts: [{ shape: shape as SentShape }] };
  const guess = [...here].at(-1);
  const into = guess ? { topology: guess } : {};
  const followed = isLarge(shape) ? follow(JSON.stringify(design), { rows, columns, into }) : null;
  const { positions, normals, topology, uvs, indices } = followed?.mesh ?? mesh(design, { rows, columns, into });
  const lattice = uvs && indices && !here.has(topology) ? { uvs, indices } : null;
  here.add(topology);
  const boxes = boxesOf(positions);
  serials += 1;
  if (followed) {
    const { moved } = followed;
    held = { shape, rows, columns, moved, serial: serials, positions: positions.slice(), boxes };
  }
  const sent: SentMesh = {
    positions,
    normals,
    topology,
    ware: { texels: evenWare(size), ...size },
    lattice,
    ...(followed && { serial: serials }),
  };
  return { mesh: sent, told: toldOf(positions, boxes) };
}

function toldOf(positions: Float32Array, boxes: Float32Array): PartFacts {
  return { bounds: boundsOf(positions, positions), reach: reachOf(positions, null, boxes), closed: true, body: null };
}
