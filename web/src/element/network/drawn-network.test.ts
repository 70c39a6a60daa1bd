import { expect, test } from "vitest";
import type { Frame, Network } from "../../document/network/network";
import { seenOn } from "../../document/network/sculpting";
import { NOTHING } from "../../document/network/selection";
import type { Triple } from "../../document/types";
import type { See } from "../../render/pull/reach";
import {
  drawHeld,
  drawNetwork,
  isLeft,
  movedItems,
  NetworkCurves,
  partedOf,
  placedItems,
  touched,
} from "./drawn-network";

/** A flat sheet of patches, of sides 2. */
function sheet(rows: number, columns: number): Network {
  const [vertices, patches]: [Triple[], Network["patches"][number][]] = [[], []];
  const places = new Map<string, number>();
  const vertex = (x: number, y: number) => {
    const known = places.get(`${x} ${y}`);
    if (known !== undefined) return known;
    places.set(`${x} ${y}`, vertices.push([x, y, 0]) - 1);
    return vertices.length - 1;
  };
  for (let y = 0; y < 2 * rows; y += 2) {
    for (let x = 0; x < 2 * columns; x += 2) {
      const round = [0, 0, 1, 0, 2, 0, 2, 1, 2, 2, 1, 2, 0, 2, 0, 1];
      const frame = Array.from({ length: 8 }, (_, k) => vertex(x + (round[2 * k] ?? 0), y + (round[2 * k + 1] ?? 0)));
      patches.push({ frame: frame as unknown as Network["patches"][number]["frame"] });
    }
  }
  return { kind: "vertex-frame", vertices, patches };
}

/** A cube of so many patches along each edge, which has that length. */
function boxOf(size: number): Network {
  const [vertices, patches]: [Triple[], Network["patches"][number][]] = [[], []];
  const places = new Map<string, number>();
  const vertex = (point: Triple) => {
    const key = point.join();
    const known = places.get(key) ?? vertices.push(point) - 1;
    places.set(key, known);
    return known;
  };
  const round = [0, 0, 0.5, 0, 1, 0, 1, 0.5, 1, 1, 0.5, 1, 0, 1, 0, 0.5];
  for (const axis of [0, 1, 2])
    for (const side of [0, size])
      for (let i = 0; i < size; i += 1)
        for (let j = 0; j < size; j += 1) {
          const frame = Array.from({ length: 8 }, (_, k) => {
            const [u, v] = [i + (round[2 * k] ?? 0), j + (round[2 * k + 1] ?? 0)];
            const point: [number, number, number] = [0, 0, 0];
            point[axis] = side;
            point[(axis + 1) % 3] = u;
            point[(axis + 2) % 3] = v;
            return vertex(point);
          });
          patches.push({ frame: frame as unknown as Network["patches"][number]["frame"] });
        }
  return { kind: "vertex-frame", vertices, patches };
}

/** From straight above, y up the screen: all of a lid is as far away. */
const seeDown: See = ([x, y, z]) => ({ x: 10 * x, y: -10 * y, depth: 100 - z });

const see: See = ([x, y, z]) => ({ x: 3 * x, y: 3 * y, depth: 10 - z });

test("of many patches what a hand moves is found alone, and is as if all were found again", () => {
  const network = sheet(20, 20);
  const before = new NetworkCurves(network);
  const vertex = network.patches[210]?.frame[4] as number;
  const parted = partedOf(network, new Set([vertex]));
  if (!parted) throw new Error("all of it moves");
  expect([parted.edges.size, parted.patches.size]).toEqual([4, 4]);
  const vertices = network.vertices.map((point, index): Triple => (index === vertex ? [11, 12, -5] : point));
  const moved = { ...network, vertices };
  const [part, all] = [new NetworkCurves(moved, before, parted), new NetworkCurves(moved)];
  expect(part.edges).toEqual(all.edges);
  expect(part.middles).toEqual(all.middles);
  // What stays and what moves are all that there is.
  const picks = { ...NOTHING, vertices: new Set([vertex]) };
  const { placed, middle } = placedItems(before, picks, null, see);
  const left = placed.filter((each) => isLeft(parted, each));
  const others = movedItems(part, parted, picks, null, see, middle);
  expect(left.length + others.length).toBe(placed.length);
  expect(others.find(({ item }) => item.kind === "vertex" && item.index === vertex)?.at).toEqual([11, 12, -5]);
});

test("few patches are found together, and so are most of many", () => {
  expect(partedOf(sheet(3, 3), new Set([1]))).toBeNull();
  const many = sheet(20, 20);
  expect(partedOf(many, new Set(many.vertices.keys()))).toBeNull();
});

test("of a throng of points those are shown that have room, and those that are picked", () => {
  const network = sheet(60, 60);
  const picks = { ...NOTHING, vertices: new Set([5, 6, 7, 8, 9]) };
  const { placed } = placedItems(new NetworkCurves(network), picks, null, see);
  expect(placed.length).toBeGreaterThan(500);
  expect(placed.length).toBeLessThan(1000);
  for (const vertex of picks.vertices)
    expect(placed.some(({ item }) => item.kind === "vertex" && item.index === vertex)).toBe(true);
  // Nearer by there is room for all that is within sight.
  const near: See = (point) => {
    const seen = see(point);
    return seen && { ...seen, x: 20 * seen.x, y: 20 * seen.y };
  };
  expect(placedItems(new NetworkCurves(network), picks, null, near).placed.length).toBe(
    network.vertices.length + network.patches.length,
  );
});

test("of a body those points are shown that face the eye, however far away they are", () => {
  const box = boxOf(6);
  expect(box.vertices.length).toBeGreaterThan(150);
  const fromAbove = placedItems(new NetworkCurves(box), NOTHING, null, seeDown).placed;
  const patches = fromAbove.flatMap(({ item, at }) => (item.kind === "patch" ? [at[2]] : []));
  // The lid alone, whose middle is as far away as anything that is seen.
  expect(patches).toHaveLength(36);
  expect(new Set(patches)).toEqual(new Set([6]));
  // The other way round it is the same body.
  const back = ([first, ...rest]: readonly number[]) => [first, ...rest.reverse()] as unknown as Frame;
  const reversed = box.patches.map(({ frame }) => ({ frame: back(frame) }));
  const other = placedItems(new NetworkCurves({ ...box, patches: reversed }), NOTHING, null, seeDown).placed;
  expect(other.filter(({ item }) => item.kind === "patch")).toHaveLength(36);
});

test("what is picked, its middle and what a hand draws lie on lines of the ground, whatever the glaze beneath", () => {
  const network = sheet(1, 2);
  const curves = new NetworkCurves(network);
  const picks = { vertices: new Set([0, 1]), patches: new Set([0]) };
  const colours = { line: "ink", picked: "mint", ground: "sheet" };
  const strokes: { readonly colour: string; readonly wide: number }[] = [];
  const context = new Proxy({} as Record<string | symbol, unknown>, {
    get: (own, name) => {
      if (name === "stroke")
        return () => strokes.push({ colour: String(own.strokeStyle), wide: Number(own.lineWidth) });
      return name in own ? own[name] : () => undefined;
    },
  }) as unknown as CanvasRenderingContext2D;
  const { placed } = placedItems(curves, picks, [1, 1, 0], see);
  drawNetwork(context, curves, placed, picks, see, colours);
  drawHeld(
    context,
    see,
    colours,
    [
      { x: 0, y: 0 },
      { x: 9, y: 9 },
    ],
    [],
  );
  const lines = strokes.flatMap(({ colour, wide }, place) =>
    colour === "mint" ? [{ wide, under: strokes[place - 1] }] : [],
  );
  // Round the patch, round what pushes it, the middle, the box.
  expect(lines).toHaveLength(4);
  for (const { wide, under } of lines) expect(under).toEqual({ colour: "sheet", wide: wide + 2 });
  // Three that are filled in the colour of the accent have a rim of the ground.
  expect(strokes.filter(({ colour, wide }) => colour === "sheet" && wide === 1.6)).toHaveLength(3);
});

test("a hand is where the surface is seen, over a hill too", () => {
  const frame = [0, 1, 2, 3, 4, 5, 6, 7] as unknown as Frame;
  const flat = sheet(1, 1);
  // Three high in its middle.
  const hill: Network = {
    ...flat,
    patches: [{ frame, forces: [{ f0: [0, 0, -6 * Math.PI ** 2], falloff: "smooth" }] }],
  };
  const tilted: See = ([x, y, z]) => ({ x: 10 * x, y: -10 * y - 10 * z, depth: 100 - z + y });
  for (const [u, v] of [
    [0.4, 0.3],
    [0.6, 0.45],
  ] as const) {
    const spot = tilted(seenOn(hill, 0, u, v));
    const found = spot && touched(hill, tilted, spot);
    expect(Math.hypot((found?.u ?? 9) - u, (found?.v ?? 9) - v)).toBeLessThan(0.06);
  }
});
