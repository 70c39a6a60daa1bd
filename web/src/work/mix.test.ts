import { expect, test } from "vitest";
import { realSolver } from "../../testing/real-solver";
import { FORMS } from "../document/forms";
import { designOf } from "../document/gallery/exhibit";
import type { Design } from "../document/types";
import { mixOf } from "./mix";

const { solver } = realSolver({ free: true });
const form = (id: string): Design => {
  const found = FORMS.find((each) => each.id === id);
  if (!found) throw new Error(id);
  return designOf(found, id);
};
const [JAR, JUG] = [form("form-jar"), form("form-jug")];

test("every share of two pots is a design that the library reads, and the ends are the two", async () => {
  const mix = await mixOf(solver, JAR, JUG);
  if (mix.state !== "done") throw new Error(mix.state);
  expect(mix.at(0)).toBe(JAR);
  expect(mix.at(1)).toEqual({ ...JUG, title: "form-jar" });
  for (const share of [0.01, 0.3, 0.5, 0.99]) {
    const design = mix.at(share);
    const read = await solver.parse(JSON.stringify(design));
    expect(read.state).toBe("done");
    expect(design.parts[0]?.wall?.thickness).toBeCloseTo(0.5 - 0.1 * share, 11);
    expect(design.parts[0]?.look).toEqual((share < 0.5 ? JAR : JUG).parts[0]?.look);
  }
});

test("what cannot be mixed says why", async () => {
  const other: Design = { pasu: 1, parts: [{ shape: { kind: "second-order", r: [4, 0, 3, 0] } }] };
  expect(await mixOf(solver, JAR, other)).toEqual({ state: "other" });
  const crowded = (shift: number): Design => {
    const u = (at: number) => (at % 44 === 0 ? at / 44 : (at + shift) / 44);
    const rings = Array.from({ length: 45 }, (_, at) => ({ u: u(at), r: { mean: 4 }, z: { mean: at } }));
    return { pasu: 1, parts: [{ shape: { kind: "rings", rings } }] };
  };
  expect(await mixOf(solver, crowded(0), crowded(0.5))).toEqual({ state: "many" });
  const broken = crowded(0);
  const [shape] = broken.parts.map((part) => (part.shape.kind === "rings" ? part.shape : null));
  const turned: Design = { pasu: 1, parts: [{ shape: { kind: "rings", rings: [...(shape?.rings ?? [])].reverse() } }] };
  expect(await mixOf(solver, JAR, turned)).toMatchObject({
    state: "refused",
    refusal: { path: "parts[0].shape.rings[0].u" },
  });
});
