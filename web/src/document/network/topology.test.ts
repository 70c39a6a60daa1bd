import { expect, test } from "vitest";
import { NETWORKED } from "../gallery/networks";
import type { Pair, Triple } from "../types";
import { type Edge, edgesOf, faultOf, isClosed, isFree, type Network, type Patch } from "./network";
import { readObj } from "./obj";
import { heightOf, seenOn } from "./sculpting";
import { ringThrough } from "./selection";
import { pointOn } from "./surface";
import { type Building, type Built, bridged, extruded, filled, outsides, removed, rowsOf, split } from "./topology";
import { ringOf, Weaving } from "./weaving";

function model(id: string): Network {
  const shape = NETWORKED.find((each) => each.id === id)?.shape;
  if (shape?.kind !== "vertex-frame") throw new Error(id);
  return shape;
}

function done(building: Building): Built {
  if ("refused" in building) throw new Error(building.refused);
  return building;
}

const free = (network: Network) => [...edgesOf(network).values()].filter(isFree);
const turnsAlike = (network: Network) => {
  const signs = outsides(network);
  return [...edgesOf(network).values()].every(({ sides: [one, other] }) => {
    if (!one || !other) return true;
    const along = (side: number, [a, , c]: Triple) => (side < 2 ? c : a);
    const same = along(one.side, one.vertices) !== along(other.side, other.vertices);
    return same === (signs[one.patch]?.sign === signs[other.patch]?.sign);
  });
};

/** A can: a wall of six patches between two rims. */
function can(): Network {
  const weaving = new Weaving();
  const [low, middle, high] = [0, 2, 4].map((z) =>
    ringOf(6, (angle) => [3 * Math.cos(angle), 3 * Math.sin(angle), z]),
  ) as [readonly Triple[], readonly Triple[], readonly Triple[]];
  weaving.wall(low, middle, high);
  return weaving.network();
}

test("what has a free edge is not closed, and what is bridged is", () => {
  const round = can();
  expect(isClosed(round)).toBe(false);
  const joined = done(bridged(round, new Set(free(round).flatMap(({ sides }) => sides[0]?.vertices ?? []))));
  expect(isClosed(joined.network)).toBe(true);
});

test("a patch is put on a free edge, and goes on from the one behind it", () => {
  const leaf = model("own-leaf");
  const { network, picked } = done(extruded(leaf, new Set([3])));
  expect([network.patches.length, network.vertices.length, picked.size]).toEqual([2, 13, 3]);
  expect(free(network).length).toBe(6);
  expect(turnsAlike(network)).toBe(true);
  const far = [...picked].map((vertex) => network.vertices[vertex]?.[0] ?? 0);
  expect(Math.min(...far)).toBeGreaterThan(12);
  expect(extruded(leaf, new Set([0]))).toEqual({ refused: "no-edge" });
  expect(extruded(network, new Set([3]))).toEqual({ refused: "no-free-edge" });
});

test("a mug grows a handle: two openings, drawn out, bridged", () => {
  const mug = model("own-mug");
  expect(turnsAlike(mug)).toBe(true);
  const before = free(mug).length;
  // Two patches in the wall against the handle, one above the other.
  const middles = mug.patches.map((_, patch) => pointOn(mug, patch, 0.5, 0.5));
  const holes = [2.5, 6.8].map((z) =>
    middles.findIndex((at) => at[0] < -3.9 && Math.abs(at[1]) < 0.1 && Math.abs(at[2] - z) < 0.2),
  );
  expect(holes.every((each) => each >= 0)).toBe(true);
  const opened = done(removed(mug, new Set(holes)));
  expect([before, free(opened.network).length]).toEqual([0, 8]);
  const drawn = done(extruded(opened.network, opened.picked));
  const reach = [...drawn.picked].map((vertex) => drawn.network.vertices[vertex]?.[0] ?? 0);
  expect(Math.max(...reach)).toBeLessThan(-4.2);
  const closed = done(bridged(drawn.network, drawn.picked));
  expect(free(closed.network)).toEqual([]);
  expect(turnsAlike(closed.network)).toBe(true);
  expect(new Set(outsides(closed.network).map(({ body }) => body)).size).toBe(1);
  // The way over is out of the mug, its outer side above and below.
  const over = [...closed.picked].map((vertex) => closed.network.vertices[vertex]?.[0] ?? 0);
  expect(Math.min(...over)).toBeLessThan(Math.min(...reach) - 0.5);
  // What was taken away can be closed again.
  expect(done(filled(opened.network, opened.picked)).network.patches.length).toBe(mug.patches.length);
});

test("a strip is split all the way round, and the surface stays where it was", () => {
  const round = can();
  const edge = [...edgesOf(round).values()].find((each) => !isFree(each));
  const across = new Set([edge?.sides[0]?.vertices[1] ?? -1]);
  const { network } = done(split(round, across));
  expect([network.patches.length, free(network).length, faultOf(network)]).toEqual([12, 12, null]);
  expect(turnsAlike(network)).toBe(true);
  const rims = rowsOf(free(network)) ?? [];
  expect(rims.map(({ closed, edges }) => [closed, edges.length])).toEqual([
    [true, 6],
    [true, 6],
  ]);
  for (const [patch, { frame }] of round.patches.entries()) {
    expect(frame.length).toBe(8);
    const [u, v] = [0.3, 0.2];
    const before = pointOn(round, patch, u, v);
    const after = pointOn(network, 2 * patch, u, 2 * v);
    expect(Math.hypot(...before.map((value, axis) => value - (after[axis] ?? 0)))).toBeLessThan(1e-4);
  }
});

test("what is split stays where it was whatever its parameters, in strips that are split in part too, and is pushed as far", () => {
  const parameters = (patch: number): Pick<Patch, "a1" | "a2" | "forces"> => ({
    a1: [1 + (patch % 3), 0.5, 2],
    a2: [1, 3, 0.75 + (patch % 5)],
    forces: [{ f0: [1, -20, 30], u: [0.25, 0.75], v: [0.5, 1], falloff: "smooth" }],
  });
  for (const id of ["own-leaf", "own-mug"]) {
    const plain = model(id);
    const stiff = { ...plain, patches: plain.patches.map((patch, place) => ({ ...patch, ...parameters(place) })) };
    for (const whole of [plain, stiff]) {
      for (const edge of [...edgesOf(whole).values()].slice(0, 24)) {
        const { network } = done(split(whole, new Set([edge.sides[0]?.vertices[1] ?? -1])));
        let place = 0;
        for (const [patch, before] of whole.patches.entries()) {
          const now = network.patches[place] as Patch;
          const isHalf = now.frame.some((vertex, index) => vertex !== before.frame[index]);
          const isAlongU = now.frame[2] !== before.frame[2];
          const [u, v] = [0.3, 0.2];
          const there = pointOn(network, place, isHalf && isAlongU ? 2 * u : u, isHalf && !isAlongU ? 2 * v : v);
          const apart = pointOn(whole, patch, u, v).map((value, axis) => value - there[axis as 0]);
          expect(Math.hypot(...apart), `${id} ${patch}`).toBeLessThan(1e-5);
          // The region along v is that of the second half alone.
          const pushed = isHalf && !isAlongU ? network.patches[place + 1] : now;
          const [force, first] = [pushed?.forces?.[0], before.forces?.[0]];
          if (pushed && force && first)
            for (const axis of [0, 1, 2] as const)
              expect(heightOf(pushed, force)[axis]).toBeCloseTo(heightOf(before, first)[axis], 9);
          else expect(first).toBeUndefined();
          place += isHalf ? 2 : 1;
        }
        expect(place).toBe(network.patches.length);
      }
    }
  }
});

test("no force is left with nothing to push where parameters would cancel each other out", () => {
  const forces: Patch["forces"] = [{ f0: [0, 0, 5] }];
  const [patch] = model("own-leaf").patches as readonly [Patch];
  const leaf: Network = { ...model("own-leaf"), patches: [{ ...patch, a1: [1, 1, 1], a2: [1, 1, -4], forces }] };
  const { network } = done(split(leaf, new Set([1])));
  for (const { a1, a2 } of network.patches) expect([a1?.[2], a2?.[2]]).toEqual([1, -4]);
});

test("all strips are split across which an edge is picked, also where they cross", () => {
  const round = can();
  const middles = (all: readonly Edge[]) => new Set(all.map(({ sides }) => sides[0]?.vertices[1] ?? -1));
  const edges = [...edgesOf(round).values()];
  // Every edge: four patches of each.
  const { network } = done(split(round, middles(edges)));
  expect([network.patches.length, faultOf(network), turnsAlike(network)]).toEqual([
    4 * round.patches.length,
    null,
    true,
  ]);
  for (const [patch] of round.patches.entries()) {
    const before = pointOn(round, patch, 0.3, 0.2);
    const after = pointOn(network, 4 * patch, 0.6, 0.4);
    for (const axis of [0, 1, 2] as const) expect(after[axis]).toBeCloseTo(before[axis], 5);
  }
  // All edges across one strip divide it once, those of a rim the strips of their own.
  const [inner] = edges.filter((each) => !isFree(each));
  const along = middles(inner ? [inner] : []);
  const ring = ringThrough(round, { vertices: along, patches: new Set() }).vertices;
  expect(done(split(round, ring)).network).toEqual(done(split(round, along)).network);
  expect(done(split(round, middles(free(round)))).network.patches).toHaveLength(2 * round.patches.length);
});

test("thousands of patches are split while somebody waits", { timeout: 20_000 }, () => {
  const weaving = new Weaving();
  for (let row = 0; row < 50; row += 1) {
    for (let column = 0; column < 80; column += 1) {
      const round = [0, 0, 1, 0, 2, 0, 2, 1, 2, 2, 1, 2, 0, 2, 0, 1];
      const at = (place: number): Triple => [
        2 * column + (round[2 * place] ?? 0),
        2 * row + (round[2 * place + 1] ?? 0),
        0,
      ];
      weaving.patch(Array.from({ length: 8 }, (_, place) => at(place)));
    }
  }
  const large = weaving.network();
  const middles = [...edgesOf(large).values()].map(({ sides }) => sides[0]?.vertices[1] ?? -1);
  expect(done(split(large, new Set(middles))).network.patches).toHaveLength(16_000);
});

test("rings are found from one edge", () => {
  const round = can();
  const [rim] = free(round);
  const picks = ringThrough(round, { vertices: new Set([rim?.sides[0]?.vertices[1] ?? -1]), patches: new Set() });
  expect(picks.vertices.size).toBe(12);
  const upright = [...edgesOf(round).values()].find((each) => !isFree(each));
  const ring = ringThrough(round, { vertices: new Set([upright?.sides[0]?.vertices[1] ?? -1]), patches: new Set() });
  expect(ring.vertices.size).toBe(18);
});

test("what cannot be done is refused by name", () => {
  const leaf = model("own-leaf");
  expect(removed(leaf, new Set([0]))).toEqual({ refused: "last-patch" });
  expect(removed(leaf, new Set())).toEqual({ refused: "no-patch" });
  expect(bridged(leaf, new Set([1, 3]))).toEqual({ refused: "no-rings" });
  expect(filled(can(), new Set(can().vertices.keys()))).toEqual({ refused: "no-hole" });
  expect(split(leaf, new Set([0]))).toEqual({ refused: "no-edge" });
  // A region of the face lies on several patches: what divides one of them would move it.
  const face = model("own-face");
  const everywhere = [...edgesOf(face).values()].map(({ sides }) =>
    split(face, new Set(sides.slice(0, 1).map((side) => side.vertices[1]))),
  );
  expect(everywhere.some((each) => "refused" in each && each.refused === "spanned")).toBe(true);
});

/** A row of patches, two by two each; the first has a force on this part of its `u`, across its `v`. */
function row(count: number, u: Pair): Network {
  const weaving = new Weaving();
  const point = (x: number, y: number): Triple => [x, y, Math.sin(x + 0.3 * y)];
  for (let place = 0; place < count; place += 1) {
    const [a, b, c] = [2 * place, 2 * place + 1, 2 * place + 2] as const;
    const forces = [{ f0: [0, 0, -20] as const, u, v: [0.1, 0.9] as const, falloff: "smooth" as const }];
    weaving.patch(
      [point(a, 0), point(b, 0), point(c, 0), point(c, 1), point(c, 2), point(b, 2), point(a, 2), point(a, 1)],
      place === 0 ? { forces } : {},
    );
  }
  return weaving.network();
}

test("a strip is split where no region of several patches lies on it, however far away the patch is that has it", () => {
  const across = (network: Network, patch: number) => split(network, new Set([network.patches[patch]?.frame[1] ?? -1]));
  // On three patches, of which the last is two away from the one that has the force.
  const far = row(4, [0.2, 2.6]);
  expect([0, 1, 2].map((patch) => across(far, patch))).toEqual(Array(3).fill({ refused: "spanned" }));
  expect(done(across(far, 3)).network.patches).toHaveLength(5);
  // Beside it.
  const near = row(4, [0.2, 1.6]);
  const { network } = done(across(near, 2));
  const places: readonly Pair[] = [
    [0.3, 0.4],
    [0.8, 0.5],
  ];
  for (const [u, v] of places) {
    for (const patch of [0, 1]) {
      const [is, was] = [network, near].map((each) => seenOn(each, patch, u, v)) as [Triple, Triple];
      expect(Math.hypot(is[0] - was[0], is[1] - was[1], is[2] - was[2])).toBeLessThan(1e-6);
    }
  }
  // What ends at a free edge is on its own patch alone.
  expect(done(across(row(1, [0.2, 1.6]), 0)).network.patches).toHaveLength(2);
});

test("no patch that stays loses a region with one that is taken away", () => {
  // The first of four has it; it reaches the third.
  const far = row(4, [0.2, 2.6]);
  for (const gone of [[0], [1], [0, 1], [1, 3]]) {
    expect(removed(far, new Set(gone))).toEqual({ refused: "torn" });
  }
  for (const gone of [[2], [3], [1, 2, 3], [0, 1, 2]]) {
    expect(done(removed(far, new Set(gone))).network.patches).toHaveLength(4 - gone.length);
  }
});

test("what would bend a region round a corner is refused", () => {
  // Three of five patches round a corner: a region of the first goes on to the other two, which end at free edges.
  const weaving = new Weaving();
  const rim = (place: number): Triple => [4 * Math.cos((place * Math.PI) / 5), 4 * Math.sin((place * Math.PI) / 5), 0];
  const half = (one: Triple, other: Triple): Triple => [(one[0] + other[0]) / 2, (one[1] + other[1]) / 2, 0];
  const corner: Triple = [0, 0, 0];
  for (const place of [0, 2, 4]) {
    const [a, b, c] = [rim(place), rim(place + 1), rim(place + 2)];
    const forces = [{ f0: [0, 0, 1] as const, u: [-0.5, 0.5] as const, v: [-0.5, 0.5] as const }];
    const frame = [corner, half(corner, a), a, half(a, b), b, half(b, c), c, half(corner, c)];
    weaving.patch(frame, place === 0 ? { forces } : {});
  }
  const fan = weaving.network();
  const [first, , third] = fan.patches;
  const ends = new Set([first?.frame[1] ?? -1, third?.frame[7] ?? -1]);
  expect(extruded(fan, ends)).toEqual({ refused: "bent" });
  const bare = { ...fan, patches: fan.patches.map(({ frame }) => ({ frame })) };
  expect(done(extruded(bare, ends)).network.patches).toHaveLength(5);
});

test("a rule that begins with a patch goes on with half of it, and with the next where it is taken away", () => {
  const round: Network = { ...can(), rule: { seed: 2 } };
  const below = (patch: number) =>
    new Set(
      free(round)
        .filter(({ sides: [side] }) => side?.patch === patch)
        .slice(0, 1)
        .map(({ sides }) => sides[0]?.vertices[1] ?? -1),
    );
  const seed = (building: Building) => done(building).network.rule;
  expect(done(split(round, below(0))).network.patches).toHaveLength(7);
  expect(seed(split(round, below(0)))).toEqual({ seed: 3 });
  expect(seed(split(round, below(2)))).toEqual({ seed: 2 });
  expect(seed(split(round, below(3)))).toEqual({ seed: 2 });
  expect(seed(removed(round, new Set([0])))).toEqual({ seed: 1 });
  expect(seed(removed(round, new Set([2])))).toEqual({ seed: 1 });
  expect(seed(removed(round, new Set([1, 2])))).toEqual({ seed: 1 });
  expect(seed(removed(can(), new Set([2])))).toBeUndefined();
  const all: Network = { ...can(), rule: "global" };
  expect([seed(split(all, below(0))), seed(removed(all, new Set([2])))]).toEqual(["global", "global"]);
});

/** Numbers that are the same on every machine. */
function dice(seed: number) {
  let state = seed;
  return (below: number) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * below);
  };
}

test.each([1, 2, 3, 4, 5, 6, 7, 8])("whatever is done to networks leaves networks, or is refused: %d", (seed) => {
  const roll = dice(seed);
  let network = [model("own-leaf"), can(), model("own-mug"), model("own-face")][seed % 4] as Network;
  let [changed, refused] = [0, 0];
  for (let step = 0; step < 60; step += 1) {
    const edges = free(network);
    const all = [...edgesOf(network).values()];
    const some = <T>(from: readonly T[], count: number) =>
      Array.from({ length: count }, () => from[roll(from.length)] as T);
    const middles = (from: typeof all) => new Set(from.flatMap((edge) => edge?.sides[0]?.vertices[1] ?? []));
    const rims = rowsOf(edges) ?? [];
    const ring = (rim: (typeof rims)[number] | undefined) => rim?.edges ?? [];
    const acts: readonly (() => Building)[] = [
      () => extruded(network, middles(some(edges, 1 + roll(3)))),
      () => extruded(network, middles(ring(rims[roll(rims.length || 1)]) as typeof all)),
      () => split(network, middles(some(all, 1))),
      () => removed(network, new Set(some([...network.patches.keys()], 1 + roll(2)))),
      () => bridged(network, middles(some(rims, 2).flatMap((rim) => ring(rim)))),
      () => bridged(network, middles(some(edges, 2))),
      () => filled(network, middles(edges)),
    ];
    const building = (acts[roll(acts.length)] as () => Building)();
    if ("refused" in building) {
      refused += 1;
      continue;
    }
    changed += 1;
    expect(faultOf(building.network)).toBe(null);
    for (const vertex of building.picked) expect(building.network.vertices[vertex]).toBeDefined();
    const used = new Set(building.network.patches.flatMap(({ frame }) => frame));
    expect(used.size).toBe(building.network.vertices.length);
    if (building.network.patches.length < 400) network = building.network;
  }
  expect(changed).toBeGreaterThan(10);
  expect(refused).toBeLessThan(50);
});

test("a rim is picked as far as it can be followed, whatever rims meet elsewhere", () => {
  // Of four squares round a point two stay that have nothing but the point in common.
  const read = readObj(
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 0 2 0\nv 1 2 0\nv 2 2 0\nf 1 2 5 4\nf 2 3 6 5\nf 4 5 8 7\nf 5 6 9 8\n",
  );
  if ("trouble" in read) throw new Error(read.trouble.code);
  const whole = read.network;
  const { network } = done(removed(whole, new Set([0, 3])));
  const touching = {
    vertices: new Set(
      free(network)
        .slice(0, 1)
        .map(({ sides }) => sides[0]?.vertices[1] ?? -1),
    ),
    patches: new Set<number>(),
  };
  // All four edges of its square, and of the other none.
  expect(ringThrough(network, touching).vertices.size).toBe(8);
  // Two cans, one of them beside such a point.
  const away: Network = can();
  const shifted = (index: number) => index + network.vertices.length;
  const both: Network = {
    kind: "vertex-frame",
    vertices: [...network.vertices, ...away.vertices],
    patches: [
      ...network.patches,
      ...away.patches.map(({ frame }) => ({ frame: frame.map(shifted) as unknown as Patch["frame"] })),
    ],
  };
  const [rim] = free(away);
  const picked = { vertices: new Set([shifted(rim?.sides[0]?.vertices[1] ?? -1)]), patches: new Set<number>() };
  expect(ringThrough(both, picked).vertices.size).toBe(12);
});

test("points that nothing is done to keep all their digits", () => {
  const round = can();
  const third: Network = { ...round, vertices: round.vertices.map(([x, y, z]) => [x / 3, y / 3, z / 3]) };
  const [rim] = free(third);
  const on = new Set([rim?.sides[0]?.vertices[1] ?? -1]);
  const built = [
    extruded(third, on),
    split(third, on),
    removed(third, new Set([0])),
    bridged(
      third,
      ringThrough(third, {
        vertices: new Set(free(third).map(({ sides }) => sides[0]?.vertices[1] ?? -1)),
        patches: new Set(),
      }).vertices,
    ),
  ];
  for (const { network } of built.map(done)) {
    const kept = network.vertices.slice(0, Math.min(network.vertices.length, third.vertices.length));
    for (const point of kept) expect(third.vertices).toContainEqual(point);
  }
});
