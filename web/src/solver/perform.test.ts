import { expect, test } from "vitest";
import { JAR, tall } from "../../testing/jar";
import { realSolver } from "../../testing/real-solver";
import type { Design } from "../document/types";
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
  expect(lines?.rim?.length).toBeGreaterThan(0);
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
  expect([lines?.iso_u.length, lines?.tangents.length, section]).toEqual([0, 0, null]);
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
  expect([vessel.value.lines?.iso_u.length, vessel.value.section]).toEqual([11, null]);
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
