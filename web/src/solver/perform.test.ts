import { afterEach, expect, test } from "vitest";
import { realSolver } from "../../testing/real-solver";
import { designOf } from "../document/gallery/exhibit";
import { FIRST } from "../document/gallery/first";

const { solver, asked } = realSolver();
afterEach(() => solver.dispose());

test("a design is solved, drawn and told by the real solver across a channel", async () => {
  const design = designOf(FIRST);
  const options = { rows: 13, columns: 25, lines: true, section: 0, settle: true };
  const outcome = await solver.solve(design, options);
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
  expect(asked).toHaveLength(1);
  // The lattice of a grid that the page has does not travel again, and the arrays that it gave back are written over.
  solver.recycle(mesh);
  const again = await solver.solve(design, { ...options, settle: false });
  expect(asked.at(-1)?.known).toEqual([mesh.topology]);
  expect(again.state === "done" && again.value.mesh.uvs).toBe(mesh.uvs);
});

test("what cannot be a design is refused with its place", async () => {
  const outcome = await solver.parse('{ "pasu": 1, "parts": [{ "shape": { "kind": "second-order", "r": 7 } }] }');
  expect(outcome).toMatchObject({ state: "refused", refusal: { path: "parts[0].shape.r" } });
});
