/** The network as it is drawn over the stage: edges, points, middles of patches, regions; those behind the middle fainter. */

import { at, edgesOf, type Frame, type Network } from "../../document/network/network";
import { crestOf, heightOf, pointAt, pointsAt, rimOf, unfolded } from "../../document/network/sculpting";
import type { Picks } from "../../document/network/selection";
import { pointOn } from "../../document/network/surface";
import { plus } from "../../document/network/topology";
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

/** How an edge is divided to be drawn. */
const PIECES = 6;
const RIM = 6;
/** Of more patches than these edges are drawn from point to point. */
const MANY = 300;
/** More points than these are a crowd: they are drawn smaller. */
const CROWD = 150;

export interface Colours {
  readonly line: string;
  readonly picked: string;
  readonly ground: string;
}

/** The places of a side, from 0 to 1 along it. */
const ALONG: readonly ((share: number) => readonly [number, number])[] = [
  (share) => [share, 0],
  (share) => [1, share],
  (share) => [share, 1],
  (share) => [0, share],
];

/** Curves and middles of a network: good until it changes. */
export class NetworkCurves {
  readonly edges: readonly (readonly Triple[])[];
  readonly middles: readonly Triple[];

  constructor(readonly network: Network) {
    // Among very many patches the points themselves are line enough.
    const many = network.patches.length > MANY;
    this.edges = [...edgesOf(network).values()].flatMap(({ sides: [side] }) => {
      const along = side && ALONG[side.side];
      if (!along) return [];
      if (many) return [side.vertices.map((vertex) => at(network, vertex))];
      return [Array.from({ length: PIECES + 1 }, (_, piece) => pointOn(network, side.patch, ...along(piece / PIECES)))];
    });
    this.middles = network.patches.map(({ frame }) => middleOf(network, frame));
  }
}

/** Where a patch is halfway along both ways: no cubic term reaches there. */
function middleOf(network: Network, frame: Frame): Triple {
  const sum: [number, number, number] = [0, 0, 0];
  for (const [place, vertex] of frame.entries()) {
    const point = at(network, vertex);
    const weight = place % 2 === 0 ? -0.25 : 0.5;
    for (const axis of [0, 1, 2] as const) sum[axis] += weight * point[axis];
  }
  return sum;
}

/** Everything that a hand can take, the nearest first. */
export function placedItems(curves: NetworkCurves, picks: Picks, pivot: Triple | null, see: See): readonly Placed[] {
  const { network, middles } = curves;
  const all: { item: Item; at: Triple }[] = [
    ...network.vertices.map((point, index) => ({ item: { kind: "vertex", index } as const, at: point })),
    ...middles.map((point, index) => ({ item: { kind: "patch", index } as const, at: point })),
    ...crests(network, picks),
  ];
  if (pivot) all.push({ item: { kind: "pivot" }, at: pivot });
  const placed = all.flatMap(({ item, at: point }) => {
    const spot = see(point);
    return spot ? [{ item, at: point, seen: { x: spot.x, y: spot.y, depth: spot.depth ?? 0 } }] : [];
  });
  const depths = placed.map(({ seen }) => seen.depth);
  const [near, far] = [Math.min(...ends(depths, -1)), Math.max(...ends(depths, 1))];
  const middle = (near + far) / 2;
  const isWorkedWith = ({ kind }: Item) => kind === "pivot" || kind === "crest";
  const isPicked = (item: Item) => item.kind === "vertex" && picks.vertices.has(item.index);
  // Among many points those behind would only be in the way.
  const crowded = network.vertices.length > CROWD;
  return placed
    .map((each) => ({ ...each, front: isWorkedWith(each.item) || each.seen.depth <= middle }))
    .filter(({ item, front }) => front || !crowded || isPicked(item))
    .sort((a, b) => a.seen.depth - b.seen.depth);
}

/** Without spreading thousands of numbers over a call. */
function ends(values: readonly number[], way: 1 | -1): readonly number[] {
  let end = values[0] ?? 0;
  for (const value of values) if (way * value > way * end) end = value;
  return [end];
}

function crests(network: Network, { patches }: Picks) {
  return [...patches].flatMap((patch) => {
    const own = network.patches[patch];
    const forces = own?.forces;
    if (!own || !forces) return [];
    const laid = unfolded(network, patch);
    return forces.flatMap((force, index) => {
      const base = pointAt(network, laid, crestOf(force));
      return base ? [{ item: { kind: "crest", patch, index } as const, at: plus(base, heightOf(own, force), 1) }] : [];
    });
  });
}

/** Draws it all; `box` is a rectangle that is being drawn, `region` a line round what would be sculpted. */
export function drawNetwork(
  context: CanvasRenderingContext2D,
  curves: NetworkCurves,
  placed: readonly Placed[],
  picks: Picks,
  see: See,
  colours: Colours,
  box: readonly [Spot, Spot] | null,
  region: readonly Triple[],
): void {
  const { network } = curves;
  context.lineJoin = "round";
  const trace = (points: readonly Triple[], close = false) => {
    for (const [place, point] of points.entries()) {
      const spot = see(point);
      if (!spot) continue;
      if (place === 0) context.moveTo(spot.x, spot.y);
      else context.lineTo(spot.x, spot.y);
    }
    if (close) context.closePath();
  };
  context.beginPath();
  for (const edge of curves.edges) trace(edge);
  context.strokeStyle = colours.line;
  context.globalAlpha = 0.55;
  context.lineWidth = 1;
  context.stroke();
  context.globalAlpha = 1;
  context.strokeStyle = colours.picked;
  context.lineWidth = 2.4;
  context.beginPath();
  for (const patch of picks.patches) {
    for (const along of ALONG) {
      trace(Array.from({ length: PIECES + 1 }, (_, piece) => pointOn(network, patch, ...along(piece / PIECES))));
    }
  }
  context.stroke();
  context.setLineDash([5, 4]);
  context.lineWidth = 1.6;
  context.beginPath();
  for (const patch of picks.patches) {
    const forces = network.patches[patch]?.forces;
    if (!forces) continue;
    const laid = unfolded(network, patch);
    for (const force of forces) trace(pointsAt(network, laid, rimOf(force, RIM)), true);
  }
  trace(region, true);
  if (box) context.rect(box[0].x, box[0].y, box[1].x - box[0].x, box[1].y - box[0].y);
  context.stroke();
  context.setLineDash([]);
  const large = network.vertices.length > CROWD ? 0.75 : 1;
  for (const each of placed.toReversed()) drawItem(context, each, picks, colours, large);
  context.globalAlpha = 1;
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
  context.strokeStyle = isPicked || item.kind === "pivot" || item.kind === "crest" ? colours.picked : colours.line;
  context.fillStyle = isPicked ? colours.picked : colours.ground;
  context.lineWidth = 1.6;
  context.beginPath();
  const { x, y } = seen;
  switch (item.kind) {
    case "vertex":
      context.arc(x, y, large * (isPicked ? 5 : 3.6), 0, 2 * Math.PI);
      break;
    case "patch":
      context.rect(x - 3.5 * large, y - 3.5 * large, 7 * large, 7 * large);
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
      context.stroke();
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
      see(pointOn(network, patch, (place % (steps + 1)) / steps, Math.floor(place / (steps + 1)) / steps)),
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
