import { expect, test } from "vitest";
import { JAR, tall } from "../../testing/jar";
import { realSolver } from "../../testing/real-solver";
import type { Design, VertexFrame } from "../document/types";
import { boundsOf } from "./bounds";

const { solver, worker } = realSolver({ free: true });

const SCENE = { design: JAR, ids: [7] };
const GRID = { rows: 13, columns: 25 };

test("a design is solved, drawn and told by the real solver across a channel", async () => {
  const desk = solver.desk();
  const options = { ...GRID, lines: true, section: 0, settle: true };
  const outcome = await desk.solve(SCENE, options);
  if (outcome.state !== "done") throw new Error(JSON.stringify(outcome));
  const { bounds, parts, lines, section, facts, bound, link, fingerprint } = outcome.value;
  const [part] = parts;
  if (!part) throw new Error("no part");
  expect(part.id).toBe(7);
  expect(part.mesh.positions.length).toBe(3 * 13 * 25);
  expect(part.mesh.uvs.length).toBe(2 * 13 * 25);
  const { min, max, centre } = boundsOf(part.mesh.positions) ?? {};
  expect(bounds).toMatchObject({ min, max, centre });
  expect(lines?.[0]?.rim.length).toBeGreaterThan(0);
  expect(section?.right.length).toBe(section?.left.length);
  expect(facts?.height).toBeGreaterThan(0);
  expect(bound).toBeGreaterThan(0);
  expect(link).not.toBe("");
  expect(fingerprint).not.toBe("");
  expect(worker.sent).toHaveLength(1);
  // Asked again it is there. The lattice of a grid that the page has does not travel again, and the arrays that it gave back are written over.
  expect((await desk.solve(SCENE, options)).state).toBe("done");
  expect(worker.sent).toHaveLength(1);
  solver.recycle(part.mesh);
  const other = { design: tall(JAR, 21), ids: [7] };
  const again = await desk.solve(other, { ...options, settle: false });
  expect(worker.last.known).toEqual([part.mesh.topology]);
  expect(worker.last.spares[0]).not.toBeNull();
  expect(again.state === "done" && again.value.parts[0]?.mesh.uvs).toBe(part.mesh.uvs);
});

// Before anything has loaded the whole module.
test("what the small module leaves out is refused where the whole one cannot be had, asked again each time, and everything else goes on", async () => {
  let asked = 0;
  const wider = async () => {
    asked += 1;
    throw new TypeError("no network");
  };
  const { solver } = realSolver({ free: true, wider });
  const section = { form: "disc", radius: [1, 1], z: 0, taper: 0, dz: 2 } as const;
  const blend: Design = {
    pasu: 1,
    parts: [{ shape: { kind: "blend", start: section, end: { ...section, radius: [2, 1], z: 2 } } }],
  };
  const options = { ...GRID, lines: false, section: null, settle: false };
  for (const count of [1, 2]) {
    const [refused, drawn] = await Promise.all([
      solver.desk().solve({ design: blend, ids: [3] }, options),
      solver.desk().solve(SCENE, options),
    ]);
    expect(refused).toMatchObject({ state: "refused", refusal: { code: "solver-unusable", message: "no network" } });
    expect(drawn.state).toBe("done");
    expect(asked).toBe(count);
  }
});

test("a network of patches is drawn as it is, without lines and a section, and is there when it is asked for again", async () => {
  const round = [
    [0, 0, 0],
    [1, 0, 0.5],
    [2, 0, 0],
    [2, 1, 0],
    [2, 2, 0],
    [1, 2, 0.5],
    [0, 2, 0],
    [0, 1, 0],
  ] as const;
  const patches = [{ frame: [0, 1, 2, 3, 4, 5, 6, 7], forces: [{ f0: [0, 0, 9] }] }] as const;
  const design: Design = { pasu: 1, parts: [{ shape: { kind: "vertex-frame", vertices: round, patches } }] };
  const desk = solver.desk();
  const options = { ...GRID, lines: true, section: 0, settle: true };
  const outcome = await desk.solve({ design, ids: [9] }, options);
  if (outcome.state !== "done") throw new Error(JSON.stringify(outcome));
  const { bounds, parts, lines, section, facts, link } = outcome.value;
  expect(parts[0]?.mesh.positions.length).toBe(3 * 13 * 25);
  expect(bounds?.max.slice(0, 2)).toEqual([2, 2]);
  expect([lines?.[0]?.iso_u.length, lines?.[0]?.tangents.length, section]).toEqual([0, 0, null]);
  expect(facts).toBeNull();
  expect(link).toMatch(/^1~/);
  const { length } = worker.sent;
  expect((await desk.solve({ design, ids: [9] }, options)).state).toBe("done");
  expect(worker.sent).toHaveLength(length);
});

test("a blend is drawn with its ends while it is a solid, and as a flank between two rims once it has a wall", async () => {
  const shape = {
    kind: "blend",
    start: { form: "disc", radius: [3, 2], z: 0, taper: 0.5, dz: 6 },
    end: { form: "disc", radius: [4, 4], z: 6, taper: 0, dz: 6 },
  } as const;
  const desk = solver.desk();
  const options = { ...GRID, lines: true, section: 0, settle: true };
  const solid = await desk.solve({ design: { pasu: 1, parts: [{ shape }] }, ids: [11] }, options);
  const walled: Design = { pasu: 1, parts: [{ shape, wall: { thickness: 0.3, base: 0.3 } }] };
  const vessel = await desk.solve({ design: walled, ids: [11] }, options);
  if (solid.state !== "done" || vessel.state !== "done") throw new Error(JSON.stringify([solid, vessel]));
  expect(solid.value.facts).toBeNull();
  const [part] = vessel.value.parts;
  expect(part?.mesh.positions.length).toBe(3 * 13 * 25);
  expect(vessel.value.facts).toMatchObject({ closed: true, height: 6 });
  expect([vessel.value.lines?.[0]?.iso_u.length, vessel.value.section]).toEqual([11, null]);
  // How thick the wall is changes nothing of it.
  const { length } = worker.sent;
  const thicker: Design = { ...walled, parts: [{ shape, wall: { thickness: 0.5, base: 0.3 } }] };
  expect((await desk.solve({ design: thicker, ids: [11] }, { ...options, settle: false })).state).toBe("done");
  expect(worker.sent).toHaveLength(length);
});

test("what cannot be a design is refused with its place", async () => {
  const outcome = await solver.parse('{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": 7 } }] }');
  expect(outcome).toMatchObject({ state: "refused", refusal: { path: "parts[0].shape.r" } });
});

/** A sheet of patches with waves. */
function sheet(rows: number, columns: number): VertexFrame {
  const across = 2 * columns + 1;
  const vertices = Array.from({ length: across * (2 * rows + 1) }, (_, place): [number, number, number] => {
    const [row, column] = [Math.floor(place / across), place % across];
    return [column, row, Math.sin(column / 9) * Math.cos(row / 7)];
  });
  const patches = Array.from({ length: rows * columns }, (_, place) => {
    const [row, column] = [2 * Math.floor(place / columns), 2 * (place % columns)];
    const at = (right: number, up: number) => (row + up) * across + column + right;
    return { frame: [at(0, 0), at(1, 0), at(2, 0), at(2, 1), at(2, 2), at(1, 2), at(0, 2), at(0, 1)] as const };
  });
  return { kind: "vertex-frame", vertices, patches };
}

test("of a large network under the hand what moves is sent alone and written over, and nothing else of it is another than in a mesh of its own", async () => {
  const { solver, worker } = realSolver({ free: true });
  const desk = solver.desk();
  const first = sheet(12, 15);
  const designOf = (shape: VertexFrame): Design => ({ pasu: 1, parts: [{ shape }] });
  const size = { rows: 97, columns: 169 };
  const options = { ...size, lines: false, section: null, settle: true };
  const done = async (shape: VertexFrame, settle: boolean) => {
    const outcome = await desk.solve({ design: designOf(shape), ids: [7] }, { ...options, settle });
    if (outcome.state !== "done") throw new Error(JSON.stringify(outcome));
    return outcome.value;
  };
  const before = await done(first, true);
  const seen: { shape: VertexFrame; bounds: unknown; positions: unknown; normals: unknown }[] = [];
  let shape = first;
  let revision = before.parts[0]?.revision ?? 0;
  for (const [step, vertex] of [400, 401, 0, 400].entries()) {
    const vertices = [...shape.vertices];
    vertices[vertex] = [vertex % 31, Math.floor(vertex / 31), 2 + step / 4];
    shape = { ...shape, vertices };
    worker.sent.splice(0);
    const now = await done(shape, false);
    const [part] = now.parts;
    expect(worker.last.ask).toMatchObject({ parts: [{ shape: { kind: "moved" } }], whole: null });
    // The same arrays, of which a part was written over.
    expect(part?.mesh).toBe(before.parts[0]?.mesh);
    const [ranges, ...more] = part?.mesh.writes?.since(revision) ?? [];
    expect(more).toEqual([]);
    const count = ranges?.reduce((sum, each, place) => sum + (place % 2) * each, 0) ?? 0;
    expect(count).toBeGreaterThan(0);
    expect(count).toBeLessThan((part?.mesh.positions.length ?? 0) / 6);
    revision = part?.revision ?? 0;
    const { positions = null, normals = null } = part?.mesh ?? {};
    seen.push({ shape, bounds: now.bounds, positions: positions?.slice(), normals: normals?.slice() });
  }
  // When the hand lets go all of it is there: of the network nothing is sent but that it is this one.
  worker.sent.splice(0);
  const rest = await done(shape, true);
  expect(rest.parts[0]?.revision).toBe(revision);
  expect(rest.fingerprint).not.toBe("");
  expect(worker.last.ask).toMatchObject({ parts: [], whole: { design: { parts: [{ shape: { kind: "moved" } }] } } });
  // What is refused leaves no half of a mesh behind.
  const pinched = {
    ...shape,
    vertices: shape.vertices.map((at, place) => (place === 2 ? (shape.vertices[0] ?? at) : at)),
  };
  expect((await desk.solve({ design: designOf(pinched), ids: [7] }, { ...options, settle: false })).state).toBe(
    "refused",
  );
  const again = await done({ ...shape }, false);
  expect(again.parts[0]?.mesh.positions).toEqual(rest.parts[0]?.mesh.positions);
  // Afterwards, because all solvers of a test share one module.
  for (const each of seen) {
    const anew = await solver.mesh(
      "anew",
      designOf({ ...each.shape, vertices: [...each.shape.vertices] }),
      size.rows,
      size.columns,
    );
    if (anew.state !== "done") throw new Error(JSON.stringify(anew));
    const [part] = anew.value.parts;
    expect(each.positions).toEqual(part?.mesh.positions);
    expect(each.normals).toEqual(part?.mesh.normals);
    expect(each.bounds).toEqual(anew.value.bounds);
  }
});
