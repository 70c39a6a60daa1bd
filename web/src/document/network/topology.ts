/** Building with patches: grown from edges, split, joined and taken away. What comes of it is a network, or is refused by name. */

import type { Triple } from "../types";
import {
  at,
  compacted,
  type Edge,
  edgesOf,
  edgesThrough,
  type Fault,
  type Frame,
  faultOf,
  isFree,
  keyOf,
  type Network,
  type Patch,
  sideOf,
  sizeOf,
} from "./network";
import { type Force, liesFlat, sharedBy } from "./sculpting";
import { cross, dot, orderOf, pointOn, unit } from "./surface";

export type Objection =
  | Fault
  | "no-edge"
  | "no-free-edge"
  | "no-patch"
  | "no-point"
  | "last-patch"
  | "crossing"
  | "spanned"
  | "torn"
  | "bent"
  | "no-rings"
  | "unequal-rings"
  | "no-hole"
  | "branching";

/** A network and the vertices that a person goes on with. */
export interface Built {
  readonly network: Network;
  readonly picked: ReadonlySet<number>;
}

export type Building = Built | { readonly refused: Objection };

/** A ring of free edges, or a row of them: its vertices in turn, corners and middles. */
export interface Row {
  readonly vertices: readonly number[];
  readonly closed: boolean;
  readonly edges: readonly Edge[];
}

/** Takes patches away, and with them the vertices that nothing else uses. The edges of the hole are picked. */
export function removed(network: Network, patches: ReadonlySet<number>): Building {
  if (patches.size === 0) return { refused: "no-patch" };
  const kept = network.patches.filter((_, patch) => !patches.has(patch));
  if (kept.length === 0) return { refused: "last-patch" };
  const { network: left, places } = compacted({ ...network, patches: kept, ...seeded(network, patches) });
  if (tears(network, patches, left)) return { refused: "torn" };
  const bared = [...edgesOf(network).values()].filter(
    ({ sides }) => sides.some(({ patch }) => patches.has(patch)) && sides.some(({ patch }) => !patches.has(patch)),
  );
  const picked = new Set(
    bared.flatMap(({ sides }) => (sides[0]?.vertices ?? []).map((vertex) => places[vertex] ?? -1)),
  );
  return checked(left, { network: left, picked });
}

/** Whether a region over several patches would be gone from some that stay, because the one that has it as a force goes, or one between them. */
function tears(network: Network, gone: ReadonlySet<number>, left: Network): boolean {
  const kept = [...network.patches.keys()].filter((patch) => !gone.has(patch));
  return [...network.patches.entries()].some(([home, { forces = [] }]) =>
    forces.some((force) => {
      const shared = [...sharedBy(network, home, force)];
      const stay = shared.filter((patch) => !gone.has(patch));
      if (stay.length === shared.length || stay.length === 0) return false;
      // By itself on its own patch it is shared with none.
      return gone.has(home) || Math.max(1, sharedBy(left, kept.indexOf(home), force).size) < stay.length;
    }),
  );
}

/** A rule that begins with a patch goes on beginning there, or where it is gone, with the next that would have had its turn. */
function seeded(network: Network, gone: ReadonlySet<number>): Pick<Network, "rule"> {
  const order = orderOf(network);
  if (!order) return {};
  const kept = [...order.keys()].filter((patch) => !gone.has(patch));
  const first = kept.reduce((one, other) => ((order[other] ?? 0) < (order[one] ?? 0) ? other : one));
  return { rule: { seed: kept.indexOf(first) } };
}

/** A patch on each free edge whose middle is picked; those that meet share a side. The new edges are picked. */
export function extruded(network: Network, picked: ReadonlySet<number>): Building {
  const edges = edgesThrough(network, picked);
  if (edges.length === 0) return { refused: "no-edge" };
  const free = edges.filter(isFree);
  if (free.length === 0) return { refused: "no-free-edge" };
  const rows = rowsOf(free);
  if (!rows) return { refused: "branching" };
  const vertices = [...network.vertices];
  const add = (point: Triple) => vertices.push(point) - 1;
  const patches: Patch[] = [];
  const next = new Set<number>();
  for (const row of rows) {
    const steps = stepsOf(network, row);
    const moved = new Map<number, readonly [middle: number, far: number]>();
    const grown = (vertex: number, isCorner: boolean) => {
      const known = moved.get(vertex);
      if (known) return known;
      const step = steps.get(vertex) ?? [0, 0, 0];
      const from = at(network, vertex);
      const made = [isCorner ? add(plus(from, step, 0.5)) : -1, add(plus(from, step, 1))] as const;
      moved.set(vertex, made);
      next.add(made[1]);
      return made;
    };
    for (const edge of row.edges) {
      const [side] = edge.sides;
      if (!side) continue;
      // Against the direction in which the patch beside it has the edge where that makes both turn alike.
      const [a, b, c] = alongOf(side.side, side.vertices);
      const [[am, af], [, bf], [cm, cf]] = [grown(a, true), grown(b, false), grown(c, true)];
      const { a1, a2 } = network.patches[side.patch] ?? {};
      const turned = side.side % 2 === 1;
      const [own, other] = turned ? [a2, a1] : [a1, a2];
      patches.push({ frame: [a, b, c, cm, cf, bf, af, am], ...(own && { a1: own }), ...(other && { a2: other }) });
    }
  }
  return checked(network, {
    network: { ...network, vertices, patches: [...network.patches, ...patches] },
    picked: next,
  });
}

/** The vertices of a side so that the patch beyond it goes round as its own does. */
function alongOf(side: number, [a, b, c]: Triple): Triple {
  return side === 0 || side === 1 ? [c, b, a] : [a, b, c];
}

/** How far each vertex of a row goes out: on from the patch behind it; of a closed ring, all alike along its axis where that is the longer way. */
function stepsOf(network: Network, row: Row): ReadonlyMap<number, Triple> {
  const steps = new Map<number, Triple[]>();
  for (const { sides } of row.edges) {
    const [side] = sides;
    const frame = side && network.patches[side.patch]?.frame;
    if (!side || !frame) continue;
    const behind = sideOf(frame, (side.side + 2) % 4);
    for (const [place, vertex] of side.vertices.entries()) {
      const way = minus(at(network, vertex), at(network, behind[place] as number));
      steps.set(vertex, [...(steps.get(vertex) ?? []), way]);
    }
  }
  const mean = new Map([...steps].map(([vertex, all]) => [vertex, meanOf(all)] as const));
  if (!row.closed) return mean;
  const axis = axisOf(network, row);
  const along = meanOf([...mean.values()]);
  const lengths = row.edges.map(({ sides }) => {
    const [from, , to] = sides[0]?.vertices ?? [0, 0, 0];
    return Math.hypot(...minus(at(network, to), at(network, from)));
  });
  const length = lengths.reduce((sum, each) => sum + each, 0) / (lengths.length || 1);
  // A tube goes on as it came; the rim of a hole in a wall goes out of the wall.
  const straight = Math.abs(dot(along, axis)) > 0.3 * Math.hypot(...meanOfLengths([...mean.values()]));
  const out = straight ? (dot(along, axis) < 0 ? -1 : 1) : outwardOf(network, row, axis);
  const step: Triple = [out * length * axis[0], out * length * axis[1], out * length * axis[2]];
  return new Map([...mean.keys()].map((vertex) => [vertex, step] as const));
}

function meanOfLengths(all: readonly Triple[]): Triple {
  return [all.reduce((sum, each) => sum + Math.hypot(...each), 0) / (all.length || 1), 0, 0];
}

/** Away from the middle of the whole. */
function outwardOf(network: Network, { vertices }: Row, axis: Triple): 1 | -1 {
  const centre = meanOf(network.vertices);
  const middle = meanOf(vertices.map((vertex) => at(network, vertex)));
  return dot(minus(middle, centre), axis) < 0 ? -1 : 1;
}

/** The direction that a ring goes round: of the area that it has. */
function axisOf(network: Network, { vertices }: Row): Triple {
  let sum: Triple = [0, 0, 0];
  const middle = meanOf(vertices.map((vertex) => at(network, vertex)));
  for (const [place, vertex] of vertices.entries()) {
    const next = vertices[(place + 1) % vertices.length] as number;
    sum = plus(sum, cross(minus(at(network, vertex), middle), minus(at(network, next), middle)), 1);
  }
  return unit(sum) ?? [0, 0, 1];
}

/** Edges that hang together, each in turn; null where three of them meet. */
export function rowsOf(edges: readonly Edge[]): readonly Row[] | null {
  const meeting = new Map<number, Edge[]>();
  for (const edge of edges) {
    const [from, , to] = edge.sides[0]?.vertices ?? [0, 0, 0];
    for (const end of [from, to]) meeting.set(end, [...(meeting.get(end) ?? []), edge]);
  }
  if ([...meeting.values()].some((each) => each.length > 2)) return null;
  const left = new Set(edges);
  const rows: Row[] = [];
  while (left.size > 0) {
    // A row that is open begins at an end.
    const starts = [...left].flatMap((edge) => {
      const [from, , to] = edge.sides[0]?.vertices ?? [0, 0, 0];
      return [from, to].filter((end) => meeting.get(end)?.length === 1);
    });
    const first = [...left][0]?.sides[0]?.vertices[0] ?? 0;
    let end = starts[0] ?? first;
    const begin = end;
    const vertices: number[] = [];
    const found: Edge[] = [];
    for (;;) {
      const edge = (meeting.get(end) ?? []).find((each) => left.has(each));
      const side = edge?.sides[0];
      if (!edge || !side) break;
      left.delete(edge);
      found.push(edge);
      const [from, middle, to] = side.vertices;
      vertices.push(end, middle);
      end = end === from ? to : from;
    }
    const closed = end === begin && found.length > 1;
    if (!closed) vertices.push(end);
    rows.push({ vertices, closed, edges: found });
  }
  return rows;
}

/** Divides every patch of the strips that the picked edges run across, in the middle. Where two of them cross, four patches are left of one. */
export function split(network: Network, picked: ReadonlySet<number>): Building {
  const edges = edgesThrough(network, picked);
  if (edges.length === 0) return { refused: "no-edge" };
  const middles = new Set(edges.map(({ sides }) => sides[0]?.vertices[1] ?? -1));
  const next = new Set<number>();
  let built = network;
  // What was the middle of an edge is a corner once that is divided: what is left are edges of strips that cross these.
  for (let left = edges; left.length > 0; left = edgesThrough(built, middles)) {
    const divided = divide(built, left);
    if ("refused" in divided) return divided;
    built = divided.network;
    for (const vertex of divided.picked) next.add(vertex);
  }
  return checked(network, { network: built, picked: next });
}

/** What a strip runs across: its edges, and for each of its patches whether along `u` or along `v`. */
interface Strip {
  readonly crossed: ReadonlyMap<string, Edge>;
  readonly ways: ReadonlyMap<number, number>;
}

/** The strip that an edge lies across; null where it runs through a patch both ways. */
function stripAcross(network: Network, from: Edge): Strip | null {
  const crossed = new Map<string, Edge>();
  const ways = new Map<number, number>();
  const queue = [from];
  while (queue.length > 0) {
    const edge = queue.pop();
    if (!edge || crossed.has(edge.key)) continue;
    crossed.set(edge.key, edge);
    for (const { patch, side } of edge.sides) {
      const way = side % 2;
      const before = ways.get(patch);
      if (before !== undefined && before !== way) return null;
      ways.set(patch, way);
      const opposite = edgesOf(network).get(keyOf(sideOf((network.patches[patch] as Patch).frame, (side + 2) % 4)));
      if (opposite) queue.push(opposite);
    }
  }
  return { crossed, ways };
}

/** Divides the strips that these edges lie across, but for those that cross one before them. */
function divide(network: Network, edges: readonly Edge[]): Building {
  const crossed = new Map<string, Edge>();
  const ways = new Map<number, number>();
  const waiting = new Set<string>();
  for (const edge of edges) {
    if (crossed.has(edge.key) || waiting.has(edge.key)) continue;
    const strip = stripAcross(network, edge);
    if (!strip) return { refused: "crossing" };
    if ([...strip.ways.keys()].some((patch) => ways.has(patch))) {
      for (const key of strip.crossed.keys()) waiting.add(key);
      continue;
    }
    for (const [key, each] of strip.crossed) crossed.set(key, each);
    for (const [patch, way] of strip.ways) ways.set(patch, way);
  }
  const spanned = spannedOf(network);
  if ([...ways.keys()].some((patch) => spanned.has(patch))) return { refused: "spanned" };
  const vertices = [...network.vertices];
  const add = (point: Triple) => vertices.push(point) - 1;
  // Two new middles for each edge that is divided, from its first end on; what was its middle is a corner.
  const halves = new Map<string, Triple>();
  for (const { key, sides } of crossed.values()) {
    const [side] = sides;
    if (!side) continue;
    const on = (share: number) => pointOn(network, side.patch, ...placeOn(side.side, share));
    halves.set(key, [side.vertices[0], add(on(0.25)), add(on(0.75))]);
  }
  const halvesOf = (edge: Triple): readonly [number, number] => {
    const [first, near, far] = halves.get(keyOf(edge)) ?? [0, 0, 0];
    return edge[0] === first ? [near, far] : [far, near];
  };
  const next = new Set<number>();
  const patches = network.patches.flatMap((patch, index): readonly Patch[] => {
    const way = ways.get(index);
    if (way === undefined) return [patch];
    const { frame } = patch;
    const centre = add(pointOn(network, index, 0.5, 0.5));
    next.add(centre);
    const [p0, p1, p2, p3, p4, p5, p6, p7] = frame;
    const [one, other]: readonly [Frame, Frame] =
      way === 0
        ? ((([s, e], [t, f]) => [
            [p0, s, p1, centre, p5, t, p6, p7],
            [p1, e, p2, p3, p4, f, p5, centre],
          ])(halvesOf([p0, p1, p2]), halvesOf([p6, p5, p4])) as readonly [Frame, Frame])
        : ((([s, e], [t, f]) => [
            [p0, p1, p2, t, p3, centre, p7, s],
            [p7, centre, p3, f, p4, p5, p6, e],
          ])(halvesOf([p0, p7, p6]), halvesOf([p2, p3, p4])) as readonly [Frame, Frame]);
    return [
      { ...halved(patch, way, 0), frame: one },
      { ...halved(patch, way, 1), frame: other },
    ];
  });
  for (const edge of crossed.values()) if (edge.sides[0]) next.add(edge.sides[0].vertices[1]);
  return { network: { ...network, vertices, patches, ...seedDivided(network, ways) }, picked: next };
}

/** A rule that begins with a patch begins with the first half of it. */
function seedDivided({ rule }: Network, ways: ReadonlyMap<number, unknown>): Pick<Network, "rule"> {
  if (rule === undefined || rule === "global") return {};
  return { rule: { seed: rule.seed + [...ways.keys()].filter((patch) => patch < rule.seed).length } };
}

function placeOn(side: number, share: number): readonly [number, number] {
  return (
    (
      [
        [share, 0],
        [1, share],
        [share, 1],
        [0, share],
      ] as const
    )[side] ?? [0, 0]
  );
}

/** The patches on which there is a region that goes over edges, however far away the patch is that has it as a force. */
function spannedOf(network: Network): ReadonlySet<number> {
  const found = new Set<number>();
  for (const [index, { forces = [] }] of network.patches.entries()) {
    for (const force of forces) for (const patch of sharedBy(network, index, force)) found.add(patch);
  }
  return found;
}

const UNIT = [0, 1] as const;

/** Half as long one way, a patch bends as the whole did where the parameter of that way is four times as large beside the other. With these, strips that run through both halves weigh them together as they weighed the whole. */
const LENGTHWISE = 2 * Math.SQRT2;
const CROSSWISE = Math.SQRT1_2;
const ONES: Triple = [1, 1, 1];
/** Less than this of the sum of both is rounding. */
const NONE = 1e-9;
/** Digits that documents keep. */
const KEPT = 12;

/** Half of a patch, which lies where it lay in the whole: its parameters go by its length, and its forces by these. */
function halved({ forces, ...patch }: Patch, way: number, half: 0 | 1): Patch {
  const { a1 = ONES, a2 = ONES } = patch;
  const [along, across] = way === 0 ? [LENGTHWISE, CROSSWISE] : [CROSSWISE, LENGTHWISE];
  const times = (axis: 0 | 1 | 2) => (along * a1[axis] + across * a2[axis]) / (a1[axis] + a2[axis]);
  // Where both would cancel each other out no force could push: they stay.
  const stays = (axis: 0 | 1 | 2) => forces !== undefined && !(Math.abs(times(axis)) > NONE && times(axis) < 1 / NONE);
  const scaled = (one: Triple, by: (axis: 0 | 1 | 2) => number): Triple => {
    const each = (axis: 0 | 1 | 2) => (stays(axis) ? one[axis] : Number((by(axis) * one[axis]).toPrecision(KEPT)));
    return [each(0), each(1), each(2)];
  };
  const own = (forces ?? []).flatMap((force) => forceOf(force, way, half));
  return {
    ...patch,
    a1: scaled(a1, () => along),
    a2: scaled(a2, () => across),
    ...(own.length > 0 && { forces: own.map((force) => ({ ...force, f0: scaled(force.f0, times) })) }),
  };
}

/** What of a force falls to a half: a rectangle across the new edge goes on from the first half to the second. */
function forceOf(force: Force, way: number, half: 0 | 1): readonly Force[] {
  const key = way === 0 ? "u" : "v";
  const [from, to] = force[key] ?? UNIT;
  const isSecond = from >= 0.5;
  if ((half === 1) !== isSecond) return [];
  const shift = isSecond ? 1 : 0;
  return [{ ...force, [key]: [2 * from - shift, 2 * to - shift] as const }];
}

/** Patches between two rings, or two rows, of as many free edges: what turns with the patches round them, and leaves each as its axis points. */
export function bridged(network: Network, picked: ReadonlySet<number>): Building {
  const rows = rowsOf(edgesThrough(network, picked).filter(isFree));
  if (!rows) return { refused: "branching" };
  const [one, other] = rows;
  if (rows.length !== 2 || !one || !other || one.closed !== other.closed) return { refused: "no-rings" };
  if (one.edges.length !== other.edges.length) return { refused: "unequal-rings" };
  const from = one.vertices;
  const to = matched(network, one, other);
  const [out, back] = [one, other].map((row) => leaving(network, row)) as [Triple, Triple];
  const vertices = [...network.vertices];
  const middles = new Map<number, number>();
  const next = new Set<number>();
  const between = (place: number): number => {
    const index = place % from.length;
    const known = middles.get(index);
    if (known !== undefined) return known;
    const [a, b] = [at(network, from[index] as number), at(network, to[index] as number)];
    const far = Math.hypot(...minus(b, a));
    const bulge: Triple = [out[0] + back[0], out[1] + back[1], out[2] + back[2]];
    const made = vertices.push(plus(meanOf([a, b]), bulge, one.closed ? far / 5 : 0)) - 1;
    middles.set(index, made);
    next.add(made);
    return made;
  };
  const patches: Patch[] = [];
  for (let place = 0; place < 2 * one.edges.length; place += 2) {
    const [a, b, c] = [0, 1, 2].map((by) => from[(place + by) % from.length]) as [number, number, number];
    const [d, e, f] = [0, 1, 2].map((by) => to[(place + by) % to.length]) as [number, number, number];
    patches.push({ frame: [a, b, c, between(place + 2), f, e, d, between(place)] });
  }
  return checked(network, {
    network: { ...network, vertices, patches: [...network.patches, ...patches] },
    picked: next,
  });
}

/** The direction in which a ring opens: away from the patches behind it, or where they lie flat round it, out of the whole. */
function leaving(network: Network, row: Row): Triple {
  const [step] = stepsOf(network, row).values();
  return unit(step ?? [0, 0, 0]) ?? [0, 0, 0];
}

/** The vertices of the second row in the order in which they stand over against the first: of all ways that turn rightly, the one on which they are nearest. */
function matched(network: Network, one: Row, other: Row): readonly number[] {
  const { vertices } = other;
  const count = vertices.length;
  const turns: (readonly number[])[] = [];
  for (const reversed of [false, true]) {
    const starts = other.closed ? Array.from({ length: count / 2 }, (_, each) => 2 * each) : [reversed ? count - 1 : 0];
    for (const start of starts) {
      turns.push(
        vertices.map(
          (_, place) => vertices[(((start + (reversed ? -place : place)) % count) + count) % count] as number,
        ),
      );
    }
  }
  const right = turns.filter((turn) => turnsRightly(network, one.vertices, turn, one, other));
  const far = (turn: readonly number[]) =>
    turn.reduce((sum, vertex, place) => {
      const gap = minus(at(network, vertex), at(network, one.vertices[place] as number));
      return sum + dot(gap, gap);
    }, 0);
  return (right.length > 0 ? right : turns).reduce((best, turn) => (far(turn) < far(best) ? turn : best));
}

/** Whether patches between both would have one outside with those behind them; of rows on bodies of their own either way is right. */
function turnsRightly(network: Network, from: readonly number[], to: readonly number[], one: Row, other: Row): boolean {
  const signs = outsides(network);
  const sense = (row: Row, order: readonly number[]) => {
    const [side] = row.edges[0]?.sides ?? [];
    if (!side) return null;
    const [a, b] = alongOf(side.side, side.vertices);
    const forward = order[(order.indexOf(a) + 1) % order.length] === b;
    const { body, sign } = signs[side.patch] ?? { body: -1, sign: 1 };
    return { body, turn: (forward ? 1 : -1) * sign };
  };
  const [first, second] = [sense(one, from), sense(other, to)];
  return !first || !second || first.body !== second.body || first.turn !== second.turn;
}

/** For every patch which body it is of, and whether it goes round as the first of that body does. */
export function outsides(network: Network): readonly { readonly body: number; readonly sign: 1 | -1 }[] {
  const found: ({ readonly body: number; readonly sign: 1 | -1 } | undefined)[] = network.patches.map(() => undefined);
  for (const seed of network.patches.keys()) {
    if (found[seed]) continue;
    found[seed] = { body: seed, sign: 1 };
    const queue = [seed];
    while (queue.length > 0) {
      const patch = queue.pop() as number;
      const own = found[patch]?.sign ?? 1;
      for (let side = 0; side < 4; side += 1) {
        const vertices = sideOf((network.patches[patch] as Patch).frame, side);
        for (const beside of edgesOf(network).get(keyOf(vertices))?.sides ?? []) {
          if (found[beside.patch]) continue;
          // Two that turn alike run along a common edge against each other.
          const same = alongOf(side, vertices)[0] !== alongOf(beside.side, beside.vertices)[0];
          found[beside.patch] = { body: seed, sign: same ? own : own === 1 ? -1 : 1 };
          queue.push(beside.patch);
        }
      }
    }
  }
  return found.map((each, patch) => each ?? { body: patch, sign: 1 });
}

/** Closes a hole of four free edges by a patch. */
export function filled(network: Network, picked: ReadonlySet<number>): Building {
  const rows = rowsOf(edgesThrough(network, picked).filter(isFree));
  const holes = (rows ?? []).filter(({ closed, edges }) => closed && edges.length === 4);
  if (holes.length === 0) return { refused: "no-hole" };
  const patches = holes.map(({ vertices }): Patch => ({ frame: vertices as unknown as Frame }));
  const next = new Set(holes.flatMap(({ vertices }) => vertices));
  return checked(network, { network: { ...network, patches: [...network.patches, ...patches] }, picked: next });
}

function checked(before: Network, built: Built): Building {
  const network = written(built.network, before.vertices.length);
  const fault = faultOf(network);
  if (fault !== null) return { refused: fault };
  const isBent = network.patches.some(({ forces = [] }, patch) =>
    forces.some((force) => !liesFlat(network, patch, force)),
  );
  return isBent ? { refused: "bent" } : { ...built, network };
}

/** New points, those from a place on, with as many digits as a person needs. What was there stays as it is. */
function written(network: Network, from: number): Network {
  if (network.vertices.length === from) return network;
  const digits = 6 - Math.floor(Math.log10(sizeOf(network)));
  const step = 10 ** Math.min(Math.max(digits, 0), 12);
  const vertices = network.vertices.map((point, place) =>
    place < from ? point : (point.map((value) => Math.round(value * step) / step + 0) as unknown as Triple),
  );
  return { ...network, vertices };
}

export function minus(a: Triple, b: Triple): Triple {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function plus(a: Triple, b: Triple, times: number): Triple {
  return [a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]];
}

export function meanOf(all: readonly Triple[]): Triple {
  let sum: Triple = [0, 0, 0];
  for (const each of all) sum = plus(sum, each, 1 / (all.length || 1));
  return sum;
}
