import { readFile } from "node:fs/promises";
import init, { inside } from "pasu";
import { beforeAll, expect, test } from "vitest";
import type { Blend, Sent } from "../types";
import { agreed, clashOf, REMEDIES, remediesOf } from "./agreement";
import { borderOf, FORMS, type Form, reformed } from "./section";

beforeAll(async () => {
  const module = new URL("../../../../crates/pasu-wasm/pkg/pasu_bg.wasm", import.meta.url);
  await init(await WebAssembly.compile(await readFile(module)));
});

const DISC = { form: "disc", radius: [1, 1], z: 0, taper: 0, dz: 4 } as const;

const between = (start: Form, end: Form): Blend => ({
  kind: "blend",
  start: reformed(DISC, start),
  end: reformed({ ...DISC, radius: [1.5, 1.5], z: 4 }, end),
});

/** Whether it is turned over, or drawn together to next to nothing. */
function isFolded(blend: Blend): boolean {
  const {
    isFolded: turned,
    jacobian,
    jacobianMean,
  } = inside({ pasu: 1, parts: [{ shape: blend }] } as unknown as Sent, 0);
  // A disc ends in a point at its middle.
  return turned || (blend.start.form.startsWith("rectangle") && jacobian < 0.05 * jacobianMean);
}

test("sections clash where the solver finds the inside folded, and nowhere else", () => {
  for (const start of FORMS) {
    for (const end of FORMS) {
      const blend = between(start, end);
      expect(clashOf(blend) !== null, `${start} to ${end}`).toBe(isFolded(blend));
      expect(remediesOf(blend).length > 0).toBe(clashOf(blend) !== null);
    }
  }
});

test("whatever is offered ends it, and leaves heights, tangents and sizes", () => {
  let offered = 0;
  for (const start of FORMS) {
    for (const end of FORMS) {
      const blend = between(start, end);
      for (const remedy of remediesOf(blend)) {
        const made = agreed(blend, remedy);
        expect(clashOf(made), `${start} to ${end}, ${remedy}`).toBeNull();
        expect(isFolded(made), `${start} to ${end}, ${remedy}`).toBe(false);
        for (const at of ["start", "end"] as const) {
          expect(made[at]).toMatchObject({ z: blend[at].z, taper: blend[at].taper, dz: blend[at].dz });
          const widest = (of: Blend) => Math.max(...borderOf(of[at]).map(([x]) => x));
          expect(Math.abs(widest(made) - widest(blend))).toBeLessThan(0.05 * widest(blend));
        }
        offered += 1;
      }
    }
  }
  expect(offered).toBeGreaterThan(12);
  expect(REMEDIES.every((remedy) => remediesOf(between("disc", "rectangle")).includes(remedy))).toBe(true);
});

test("a disc and a rectangle become a disc over a square and a rectangle that goes the same way", () => {
  const made = agreed({ ...between("disc", "rectangle"), method: "exact" }, "disc-in-square");
  expect([made.start.form, made.end.form]).toEqual(["disc-in-square", "rectangle-reversed"]);
  expect(made.method).toBeUndefined();
});
