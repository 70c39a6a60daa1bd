import { expect, test } from "vitest";
import { JAR } from "../../testing/jar";
import { realSolver } from "../../testing/real-solver";

const { solver, worker } = realSolver({ free: true });

test("a design is solved, drawn and told by the real solver across a channel", async () => {
  const options = { rows: 13, columns: 25, lines: true, section: 0, settle: true };
  const outcome = await solver.solve(JAR, options);
  if (outcome.state !== "done") throw new Error(JSON.stringify(outcome));
  const { mesh, lines, section, facts, bound, link, fingerprint } = outcome.value;
  expect(mesh.positions.length).toBe(3 * 13 * 25);
  expect(mesh.uvs.length).toBe(2 * 13 * 25);
  expect(mesh.bounds).not.toBeNull();
  expect(lines?.rim?.length).toBeGreaterThan(0);
  expect(section?.right.length).toBe(section?.left.length);
  expect(facts?.height).toBeGreaterThan(0);
  expect(bound).toBeGreaterThan(0);
  expect(link).not.toBe("");
  expect(fingerprint).not.toBe("");
  expect(worker.sent).toHaveLength(1);
  // The lattice of a grid that the page has does not travel again, and the arrays that it gave back are written over.
  solver.recycle(mesh);
  const again = await solver.solve(JAR, { ...options, settle: false });
  expect(worker.last.known).toEqual([mesh.topology]);
  expect(again.state === "done" && again.value.mesh.uvs).toBe(mesh.uvs);
});

test("what cannot be a design is refused with its place", async () => {
  const outcome = await solver.parse('{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": 7 } }] }');
  expect(outcome).toMatchObject({ state: "refused", refusal: { path: "parts[0].shape.r" } });
});
