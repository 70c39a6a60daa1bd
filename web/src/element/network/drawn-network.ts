/** The network as it is drawn over the stage: edges, points, middles of patches, regions; those that face away fainter, and where it closes round nothing those behind the middle. */

import {
  at,
  CORNERS,
  edgesOf,
  type Frame,
  isClosed,
  type Network,
  patchesRound,
  type Side,
} from "../../document/network/network";
import { crestOf, pointAt, pointsAt, rimOf, seenOn, unfolded } from "../../document/network/sculpting";
import type { Picks } from "../../document/network/selection";
import { cross, dot, pointOn } from "../../document/network/surface";
import { outsides } from "../../document/network/topology";
import type { Triple } from "../../document/types";
import type { See, Spot } from "../../render/pull/reach";

export interface Seen extends Spot {
  readonly depth: number;
}

/** A thing of the network that a hand can take. */
export type Item =
  | { readonly kind: "vertex" | "patch"; readonly index: number }
  | { readonly kind: "crest"; readonly patch: number; readonly index: number }
  | { readonly kind: "pivot" };

export interface Placed {
  readonly item: Item;
  readonly at: Triple;
  readonly seen: Seen;
  readonly front: boolean;
}

/** How an edge is divided to be drawn, of few patches and of more. */
const PIECES = { few: 16, more: 6 } as const;
/** Of no more patches each is large on the stage. */
const FEW = 24;
const RIM = 6;
/** Of more patches than these edges are drawn from point to point. */
const MANY = 300;
/** Of so many points one at most moves, or all are drawn again. */
const MOST_MOVED = 4;
/** More points than these are a crowd: they are drawn smaller. */
const CROWD = 150;
/** Of more points those are drawn, and can be taken, that have so many pixels to themselves; nearer by there is room for more. */
const THRONG = 10_000;
const ROOM = 14;
/** Of more patches no edges are drawn, nor looked for: they would be a surface of lines. */
const NO_EDGES = 10_000;

export interface Colours {
  readonly line: string;
  readonly picked: string;
  readonly ground: string;
}

/** The places of a side, from 0 to 1 along it. */
type Along = (share: number) => readonly [number, number];
const ALONG: readonly Along[] = [
  (share) => [share, 0],
  (share) => [1, share],
  (share) => [share, 1],
  (share) => [0, share],
];

/** What of a network a hand moves, by numbers: of thousands of patches this alone is found and drawn again with every movement. */
export interface Parted {
  readonly vertices: ReadonlySet<number>;
  /** Those that have one of the vertices, in the order of {@link edgesOf}. */
  readonly edges: ReadonlySet<number>;
  readonly patches: ReadonlySet<number>;
}

/** What goes with these vertices; null where the network is small, or so much of it moves that all may be drawn again. */
export function partedOf(network: Network, vertices: ReadonlySet<number>): Parted | null {
  if (!isMany(network) || vertices.size > network.vertices.length / MOST_MOVED) return null;
  const patches = new Set(patchesRound(network, vertices));
  const [sides, numbers] = [sidesOf(network), sidesOfPatches(network)];
  const edges = new Set<number>();
  for (const patch of patches) {
    for (let side = 0; side < 4; side += 1) {
      const edge = numbers[4 * patch + side] ?? NONE;
      if (sides[edge]?.vertices.some((vertex) => vertices.has(vertex))) edges.add(edge);
    }
  }
  return { vertices, edges, patches };
}

/** The same with what goes with other vertices. */
export function withParted(network: Network, { vertices }: Parted, others: Iterable<number>): Parted | null {
  return partedOf(network, new Set([...vertices, ...others]));
}

/** Among very many patches the points themselves are line enough. */
function isMany({ patches }: Network): boolean {
  return patches.length > MANY;
}

/** Curves and middles of a network: good until it changes. */
export class NetworkCurves {
  readonly edges: readonly (readonly Triple[])[];
  readonly middles: readonly Triple[];

  /** `before` are those of the same patches, of which `parted` alone has moved since. */
  constructor(
    readonly network: Network,
    before: NetworkCurves | null = null,
    parted: Parted | null = null,
  ) {
    if (before && parted) {
      const [edges, middles] = [[...before.edges], [...before.middles]];
      const all = sidesOf(network);
      for (const edge of parted.edges) edges[edge] = curveOf(network, all[edge]);
      for (const patch of parted.patches) middles[patch] = middleOf(network, network.patches[patch]?.frame);
      this.edges = edges;
      this.middles = middles;
      return;
    }
    this.edges = sidesOf(network).map((side) => curveOf(network, side));
    this.middles = network.patches.map(({ frame }) => middleOf(network, frame));
  }
}

const known = new WeakMap<Network["patches"], readonly Side[]>();

/** One side of each edge that is drawn. */
function sidesOf(network: Network): readonly Side[] {
  const before = known.get(network.patches);
  if (before) return before;
  const all = network.patches.length > NO_EDGES ? [] : [...edgesOf(network).values()];
  const sides = all.flatMap(({ sides: [side] }) => side ?? []);
  known.set(network.patches, sides);
  return sides;
}

const NONE = 0xffffffff;

const numbered = new WeakMap<Network["patches"], Uint32Array>();

/** For each side of each patch the number of its edge among those that are drawn. */
function sidesOfPatches(network: Network): Uint32Array {
  const before = numbered.get(network.patches);
  if (before) return before;
  const numbers = new Uint32Array(4 * network.patches.length).fill(NONE);
  if (sidesOf(network).length > 0) {
    let number = 0;
    for (const { sides } of edgesOf(network).values()) {
      for (const { patch, side } of sides) numbers[4 * patch + side] = number;
      number += 1;
    }
  }
  numbered.set(network.patches, numbers);
  return numbers;
}

function curveOf(network: Network, side: Side | undefined): readonly Triple[] {
  const along = side && ALONG[side.side];
  if (!along) return [];
  if (isMany(network)) return side.vertices.map((vertex) => at(network, vertex));
  return piecesOf(network, side.patch, along);
}

function piecesOf(network: Network, patch: number, along: Along): readonly Triple[] {
  const pieces = network.patches.length <= FEW ? PIECES.few : PIECES.more;
  return Array.from({ length: pieces + 1 }, (_, piece) => pointOn(network, patch, ...along(piece / pieces)));
}

/** Where a patch is halfway along both ways: no cubic term reaches there. */
function middleOf(network: Network, frame: Frame | undefined): Triple {
  const sum: [number, number, number] = [0, 0, 0];
  for (let place = 0; frame && place < frame.length; place += 1) {
    const point = at(network, frame[place] ?? 0);
    const weight = place % 2 === 0 ? -0.25 : 0.5;
    for (const axis of [0, 1, 2] as const) sum[axis] += weight * point[axis];
  }
  return sum;
}

/** Everything that a hand can take, the nearest first, and how far from the eye what is behind begins. */
export interface Items {
  readonly placed: readonly Placed[];
  readonly middle: number;
  /** Where each vertex is seen, right and down, not a number where it is not. */
  readonly spots: Float32Array;
}

export function placedItems(curves: NetworkCurves, picks: Picks, pivot: Triple | null, see: See): Items {
  const { network, middles } = curves;
  const all: { item: Item; at: Triple; seen: Seen }[] = [];
  let [near, far] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  const add = (item: Item, point: Triple) => {
    const spot = see(point);
    if (!spot) return;
    const depth = spot.depth ?? 0;
    if (depth < near) near = depth;
    if (depth > far) far = depth;
    all.push({ item, at: point, seen: { x: spot.x, y: spot.y, depth } });
  };
  const spots = new Float32Array(2 * network.vertices.length).fill(Number.NaN);
  for (let index = 0; index < network.vertices.length; index += 1) {
    const known = all.length;
    add({ kind: "vertex", index }, at(network, index));
    const seen = all[known]?.seen;
    if (seen) spots.set([seen.x, seen.y], 2 * index);
  }
  for (let index = 0; index < middles.length; index += 1) add({ kind: "patch", index }, middles[index] ?? [0, 0, 0]);
  for (const { item, at: point } of crests(network, picks)) add(item, point);
  if (pivot) add({ kind: "pivot" }, pivot);
  const middle = (near + far) / 2;
  const placed = inSight(all, picks, middle, network.vertices.length, facingOf(network, network.patches.keys(), see));
  return { placed: network.vertices.length > THRONG ? thinned(placed, picks) : placed, middle, spots };
}

/** A rectangle of the stage, in whole pixels. */
export interface Rect {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** What goes with a part of a network is drawn within this; null where nothing of it is seen. */
export function rectOf(network: Network, { patches }: Parted, spots: Float32Array): Rect | null {
  let all: Rect | null = null;
  for (const patch of patches) {
    let own: Rect | null = null;
    for (const vertex of network.patches[patch]?.frame ?? []) {
      const [x, y] = [spots[2 * vertex] ?? Number.NaN, spots[2 * vertex + 1] ?? Number.NaN];
      if (!Number.isNaN(x + y)) own = around(own, { left: x, top: y, right: x, bottom: y });
    }
    if (!own) continue;
    // The middle of a patch is no further beyond its points than half of what lies between these.
    const [wide, high] = [HALF + 2 + (own.right - own.left) / 2, HALF + 2 + (own.bottom - own.top) / 2];
    const { left, top, right, bottom } = own;
    all = around(all, { left: left - wide, top: top - high, right: right + wide, bottom: bottom + high });
  }
  return (
    all && {
      left: Math.floor(all.left),
      top: Math.floor(all.top),
      right: Math.ceil(all.right),
      bottom: Math.ceil(all.bottom),
    }
  );
}

/** Both together. */
export function around(one: Rect | null, other: Rect | null): Rect | null {
  if (!one || !other) return one ?? other;
  return {
    left: Math.min(one.left, other.left),
    top: Math.min(one.top, other.top),
    right: Math.max(one.right, other.right),
    bottom: Math.max(one.bottom, other.bottom),
  };
}

/** Where these vertices are seen now. */
export function respot(network: Network, vertices: Iterable<number>, see: See, spots: Float32Array): void {
  for (const vertex of vertices) {
    const spot = see(at(network, vertex));
    spots.set(spot ? [spot.x, spot.y] : [Number.NaN, Number.NaN], 2 * vertex);
  }
}

/** Draws again what of the rest lies in a rectangle. */
export function redrawWithin(
  context: CanvasRenderingContext2D,
  rect: Rect,
  curves: NetworkCurves,
  items: Items,
  picks: Picks,
  see: See,
  colours: Colours,
  parted: Parted,
): void {
  const { left, top, right, bottom } = rect;
  const { spots, placed } = items;
  context.save();
  context.beginPath();
  context.rect(left, top, right - left, bottom - top);
  context.clip();
  context.clearRect(left, top, right - left, bottom - top);
  const sides = sidesOf(curves.network);
  const within = placed.filter(
    ({ seen: { x, y } }) => x > left - HALF && x < right + HALF && y > top - HALF && y < bottom + HALF,
  );
  const crosses = (edge: number) => {
    let [least, most, high, low] = [Infinity, -Infinity, Infinity, -Infinity];
    for (const vertex of sides[edge]?.vertices ?? []) {
      const [x, y] = [spots[2 * vertex] ?? Number.NaN, spots[2 * vertex + 1] ?? Number.NaN];
      [least, most, high, low] = [Math.min(least, x), Math.max(most, x), Math.min(high, y), Math.max(low, y)];
    }
    return !(most < left - 1 || least > right + 1 || low < top - 1 || high > bottom + 1);
  };
  drawNetwork(context, curves, within, picks, see, colours, { of: parted, which: "left" }, crosses);
  context.restore();
}

/** Those alone that a hand moves. */
export function movedItems(
  curves: NetworkCurves,
  { vertices, patches }: Parted,
  picks: Picks,
  pivot: Triple | null,
  see: See,
  middle: number,
): readonly Placed[] {
  const { network, middles } = curves;
  const all: { item: Item; at: Triple }[] = [
    ...[...vertices].map((index) => ({ item: { kind: "vertex", index } as const, at: at(network, index) })),
    ...[...patches].map((index) => ({ item: { kind: "patch", index } as const, at: middles[index] ?? at(network, 0) })),
    ...crests(network, picks),
    ...(pivot ? [{ item: { kind: "pivot" } as const, at: pivot }] : []),
  ];
  const seen = all.flatMap(({ item, at: point }) => {
    const spot = see(point);
    return spot ? [{ item, at: point, seen: { x: spot.x, y: spot.y, depth: spot.depth ?? 0 } }] : [];
  });
  // All patches that have a vertex which moves are among these.
  return inSight(seen, picks, middle, network.vertices.length, facingOf(network, patches, see));
}

/** Whether something stays where it is while a hand moves these. */
export function isLeft({ vertices, patches }: Parted, { item }: Placed): boolean {
  if (item.kind === "vertex") return !vertices.has(item.index);
  return item.kind === "patch" && !patches.has(item.index);
}

/** What of a network turns its outside to the eye. */
interface Facing {
  readonly vertices: ReadonlySet<number>;
  readonly patches: ReadonlySet<number>;
}

/** Which way round each patch of a body goes, seen from outside: good as long as its patches are the same. Null where it has no outside that could face anybody. */
const turns = new WeakMap<Network["patches"], readonly (1 | -1)[] | null>();

function turnsOf(network: Network): readonly (1 | -1)[] | null {
  const before = turns.get(network.patches);
  if (before !== undefined) return before;
  const found = isClosed(network) ? outwards(network) : null;
  turns.set(network.patches, found);
  return found;
}

/** By the volume of each body between the corners of its patches, which is positive where they go round as their outside does. */
function outwards(network: Network): readonly (1 | -1)[] {
  const sides = outsides(network);
  const volumes = new Map<number, number>();
  for (const [patch, { frame }] of network.patches.entries()) {
    const { body, sign } = sides[patch] ?? { body: patch, sign: 1 };
    const [a, b, c, d] = CORNERS.map((place) => at(network, frame[place] ?? 0)) as [Triple, Triple, Triple, Triple];
    const volume = dot(a, cross(b, c)) + dot(a, cross(c, d));
    volumes.set(body, (volumes.get(body) ?? 0) + sign * volume);
  }
  return sides.map(({ body, sign }) => ((volumes.get(body) ?? 0) < 0 ? (-sign as 1 | -1) : sign));
}

/** Seen from its outside a patch goes round against the clock; on the screen y goes down. */
function facingOf(network: Network, patches: Iterable<number>, see: See): Facing | null {
  if (network.vertices.length <= CROWD) return null;
  const signs = turnsOf(network);
  if (!signs) return null;
  const facing = { vertices: new Set<number>(), patches: new Set<number>() };
  for (const patch of patches) {
    const frame = network.patches[patch]?.frame;
    if (!frame) continue;
    const corners = CORNERS.map((place) => see(at(network, frame[place] ?? 0)));
    const area = corners.reduce((sum, here, k) => {
      const next = corners[(k + 1) % corners.length];
      return here && next ? sum + here.x * next.y - next.x * here.y : Number.NaN;
    }, 0);
    if (!(area * (signs[patch] ?? 1) < 0)) continue;
    facing.patches.add(patch);
    for (const vertex of frame) facing.vertices.add(vertex);
  }
  return facing;
}

/** Among many points those behind would only be in the way. */
function inSight(
  all: readonly Omit<Placed, "front">[],
  picks: Picks,
  middle: number,
  count: number,
  facing: Facing | null,
): readonly Placed[] {
  const faces = ({ item, seen }: Omit<Placed, "front">): boolean => {
    if (item.kind === "pivot" || item.kind === "crest") return true;
    if (!facing) return seen.depth <= middle;
    return (item.kind === "vertex" ? facing.vertices : facing.patches).has(item.index);
  };
  const crowded = count > CROWD;
  const found: Placed[] = [];
  for (const each of all) {
    const { item, at: point, seen } = each;
    const front = faces(each);
    const isPicked = item.kind === "vertex" && picks.vertices.has(item.index);
    if (front || !crowded || isPicked) found.push({ item, at: point, seen, front });
  }
  return found.sort((a, b) => a.seen.depth - b.seen.depth);
}

/** Of what lies close together the nearest to the eye; what is picked stays. */
function thinned(placed: readonly Placed[], { vertices, patches }: Picks): readonly Placed[] {
  const taken = new Set<number>();
  return placed.filter(({ item, seen }) => {
    if (item.kind === "vertex" ? vertices.has(item.index) : item.kind !== "patch" || patches.has(item.index))
      return true;
    const place = 65_536 * Math.floor(seen.y / ROOM) + Math.floor(seen.x / ROOM);
    if (taken.has(place)) return false;
    taken.add(place);
    return true;
  });
}

function crests(network: Network, { patches }: Picks) {
  return [...patches].flatMap((patch) => {
    const own = network.patches[patch];
    const forces = own?.forces;
    if (!own || !forces) return [];
    const laid = unfolded(network, patch);
    return forces.flatMap((force, index) => {
      const crest = pointAt(network, laid, crestOf(force));
      return crest ? [{ item: { kind: "crest", patch, index } as const, at: crest }] : [];
    });
  });
}

/** Draws edges and points; where a hand moves some, `parted` says which, and `which` whether it is these or the others. */
export function drawNetwork(
  context: CanvasRenderingContext2D,
  curves: NetworkCurves,
  placed: readonly Placed[],
  picks: Picks,
  see: See,
  colours: Colours,
  parted: { readonly of: Parted; readonly which: "moved" | "left" } | null = null,
  shows: (edge: number) => boolean = () => true,
): void {
  const { network, edges } = curves;
  const trace = tracer(context, see);
  context.lineJoin = "round";
  context.beginPath();
  if (parted?.which === "moved") for (const edge of parted.of.edges) trace(edges[edge] ?? []);
  else
    for (let edge = 0; edge < edges.length; edge += 1)
      if (!parted?.of.edges.has(edge) && shows(edge)) trace(edges[edge] ?? []);
  const crowded = network.vertices.length > CROWD;
  context.globalAlpha = 0.55;
  context.lineWidth = 1;
  if (crowded) {
    context.strokeStyle = colours.line;
    context.stroke();
  } else strokeSeen(context, colours.line, colours);
  context.globalAlpha = 1;
  // What is picked moves.
  if (parted?.which !== "left") drawPicked(context, network, picks, trace, colours);
  const stamps = crowded ? new Stamps(context, picks, colours) : null;
  for (let place = placed.length - 1; place >= 0; place -= 1) {
    const each = placed[place] as Placed;
    if (!stamps?.put(each)) drawItem(context, each, picks, colours, crowded ? LARGE : 1);
  }
  context.globalAlpha = 1;
}

/** How much of the ground is seen on either side of a line, in pixels. */
const RIND = 1;
/** How large points are among many. */
const LARGE = 0.75;
/** Half of a stamp, in CSS pixels. */
const HALF = 6;

/** What is drawn in some colours: a canvas of its own takes longer to have than a movement may. */
const stamped = new WeakMap<Colours, Map<string, HTMLCanvasElement | null>>();

/** Among many points each is one of few pictures, drawn once and put down thousands of times. */
class Stamps {
  readonly #context: CanvasRenderingContext2D;
  readonly #picks: Picks;
  readonly #colours: Colours;
  readonly #ratio: number;
  readonly #made: Map<string, HTMLCanvasElement | null>;

  constructor(context: CanvasRenderingContext2D, picks: Picks, colours: Colours) {
    this.#context = context;
    this.#picks = picks;
    this.#colours = colours;
    this.#ratio = context.getTransform().a;
    this.#made = stamped.get(colours) ?? new Map();
    stamped.set(colours, this.#made);
  }

  /** Says whether it could. */
  put({ item, seen, at: point, front }: Placed): boolean {
    if (item.kind !== "vertex" && item.kind !== "patch") return false;
    const isPicked = (item.kind === "vertex" ? this.#picks.vertices : this.#picks.patches).has(item.index);
    const key = `${this.#ratio} ${item.kind} ${isPicked} ${front}`;
    let stamp = this.#made.get(key);
    if (stamp === undefined) {
      stamp = this.#stamp({ item, at: point, front, seen: { x: HALF, y: HALF, depth: 0 } });
      this.#made.set(key, stamp);
    }
    if (!stamp) return false;
    const ratio = this.#ratio;
    // On whole pixels nothing has to be blended anew.
    const [x, y] = [Math.round(ratio * (seen.x - HALF)) / ratio, Math.round(ratio * (seen.y - HALF)) / ratio];
    this.#context.globalAlpha = 1;
    this.#context.drawImage(stamp, x, y, stamp.width / ratio, stamp.height / ratio);
    return true;
  }

  #stamp(one: Placed): HTMLCanvasElement | null {
    const stamp = document.createElement("canvas");
    stamp.width = Math.ceil(2 * HALF * this.#ratio);
    stamp.height = stamp.width;
    const context = stamp.getContext("2d");
    context?.setTransform(this.#ratio, 0, 0, this.#ratio, 0, 0);
    if (context) drawItem(context, one, this.#picks, this.#colours, LARGE);
    return context && stamp;
  }
}

/** Draws what a hand is drawing: `box` is a rectangle, `region` a line round what would be sculpted. */
export function drawHeld(
  context: CanvasRenderingContext2D,
  see: See,
  colours: Colours,
  box: readonly [Spot, Spot] | null,
  region: readonly Triple[],
): void {
  const trace = tracer(context, see);
  context.setLineDash([5, 4]);
  context.lineWidth = 1.6;
  context.beginPath();
  trace(region, true);
  if (box) context.rect(box[0].x, box[0].y, box[1].x - box[0].x, box[1].y - box[0].y);
  strokeSeen(context, colours.picked, colours);
  context.setLineDash([]);
}

/** Along the path, with so much of the ground on either side that it is seen on a glaze of its own colour too. */
function strokeSeen(context: CanvasRenderingContext2D, colour: string, colours: Colours): void {
  const { lineWidth } = context;
  context.lineWidth = lineWidth + 2 * RIND;
  context.strokeStyle = colours.ground;
  context.stroke();
  context.lineWidth = lineWidth;
  context.strokeStyle = colour;
  context.stroke();
}

type Trace = (points: readonly Triple[], close?: boolean) => void;

function tracer(context: CanvasRenderingContext2D, see: See): Trace {
  return (points, close = false) => {
    for (let place = 0; place < points.length; place += 1) {
      const spot = see(points[place] as Triple);
      if (!spot) continue;
      if (place === 0) context.moveTo(spot.x, spot.y);
      else context.lineTo(spot.x, spot.y);
    }
    if (close) context.closePath();
  };
}

/** Round picked patches, and round what pushes them. */
function drawPicked(
  context: CanvasRenderingContext2D,
  network: Network,
  picks: Picks,
  trace: Trace,
  colours: Colours,
): void {
  context.lineWidth = 2.4;
  context.beginPath();
  for (const patch of picks.patches) {
    if (isMany(network)) {
      trace(
        (network.patches[patch]?.frame ?? []).map((vertex) => at(network, vertex)),
        true,
      );
      continue;
    }
    for (const along of ALONG) {
      trace(piecesOf(network, patch, along));
    }
  }
  strokeSeen(context, colours.picked, colours);
  context.setLineDash([5, 4]);
  context.lineWidth = 1.6;
  context.beginPath();
  for (const patch of picks.patches) {
    const forces = network.patches[patch]?.forces;
    if (!forces) continue;
    const laid = unfolded(network, patch);
    for (const force of forces) trace(pointsAt(network, laid, rimOf(force, RIM)), true);
  }
  strokeSeen(context, colours.picked, colours);
  context.setLineDash([]);
}

function drawItem(
  context: CanvasRenderingContext2D,
  { item, seen, front }: Placed,
  picks: Picks,
  colours: Colours,
  large: number,
): void {
  const isPicked =
    (item.kind === "vertex" && picks.vertices.has(item.index)) ||
    (item.kind === "patch" && picks.patches.has(item.index));
  context.globalAlpha = front || isPicked ? 1 : 0.35;
  context.strokeStyle = isPicked ? colours.ground : item.kind === "crest" ? colours.picked : colours.line;
  context.fillStyle = isPicked ? colours.picked : colours.ground;
  context.lineWidth = 1.6;
  context.beginPath();
  const { x, y } = seen;
  const side = isPicked ? 4.3 : 3.5;
  switch (item.kind) {
    case "vertex":
      context.arc(x, y, large * (isPicked ? 5.6 : 3.6), 0, 2 * Math.PI);
      break;
    case "patch":
      context.rect(x - side * large, y - side * large, 2 * side * large, 2 * side * large);
      break;
    case "crest":
      context.moveTo(x, y - 7);
      context.lineTo(x + 7, y);
      context.lineTo(x, y + 7);
      context.lineTo(x - 7, y);
      context.closePath();
      break;
    case "pivot":
      context.arc(x, y, 9, 0, 2 * Math.PI);
      context.lineWidth = 2.6;
      strokeSeen(context, colours.picked, colours);
      return;
  }
  context.fill();
  context.stroke();
}

/** The point of the surface that is seen there, by its patch; the nearest to the eye. */
export function touched(
  network: Network,
  see: See,
  spot: Spot,
): { readonly patch: number; readonly u: number; readonly v: number } | null {
  const steps = 6;
  let best: { patch: number; u: number; v: number; depth: number } | null = null;
  for (const patch of network.patches.keys()) {
    const seen = Array.from({ length: (steps + 1) ** 2 }, (_, place) =>
      see(seenOn(network, patch, (place % (steps + 1)) / steps, Math.floor(place / (steps + 1)) / steps)),
    );
    for (let row = 0; row < steps; row += 1) {
      for (let column = 0; column < steps; column += 1) {
        const corner = (right: number, up: number) => seen[(row + up) * (steps + 1) + column + right] ?? null;
        const [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)];
        if (!a || !b || !c || !d) continue;
        const low = within(spot, a, b, c);
        const high = low ? null : within(spot, d, c, b);
        const [s, t] = low ?? (high ? [1 - high[0], 1 - high[1]] : [-1, -1]);
        if (s < 0) continue;
        const depth =
          (a.depth ?? 0) * (1 - s) * (1 - t) +
          (b.depth ?? 0) * s * (1 - t) +
          (c.depth ?? 0) * (1 - s) * t +
          (d.depth ?? 0) * s * t;
        if (!best || depth < best.depth) best = { patch, u: (column + s) / steps, v: (row + t) / steps, depth };
      }
    }
  }
  return best;
}

/** Where in a triangle a spot is, along its two sides from the first corner; null outside. */
function within(spot: Spot, a: Spot, b: Spot, c: Spot): readonly [number, number] | null {
  const [ux, uy, vx, vy] = [b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y];
  const area = ux * vy - uy * vx;
  if (Math.abs(area) < 1e-9) return null;
  const [px, py] = [spot.x - a.x, spot.y - a.y];
  const s = (px * vy - py * vx) / area;
  const t = (ux * py - uy * px) / area;
  return s >= 0 && t >= 0 && s + t <= 1 ? [s, t] : null;
}
