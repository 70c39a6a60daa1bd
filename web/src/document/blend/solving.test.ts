import { expect, test } from "vitest";
import type { Blend } from "../types";
import {
  methodOf,
  methodsFor,
  settled,
  termsOf,
  unseenOf,
  weightsOf,
  withEnoughTerms,
  withMethod,
  withTerm,
  withWeight,
} from "./solving";

const level = { z: 0, taper: 0, dz: 1 };
const ROUND: Blend = {
  kind: "blend",
  start: { form: "disc", radius: [1, 1], ...level },
  end: { form: "disc", radius: [2, 2], ...level, z: 3 },
};

test("what holds anyway is not written into the document", () => {
  expect(methodOf(ROUND)).toBe("exact");
  const modal = withMethod(ROUND, "modal");
  expect(modal.method).toBe("modal");
  expect(withMethod(modal, "exact")).toEqual(ROUND);
  const weighted = withWeight(ROUND, 1, 0.1);
  expect(weighted.weights).toEqual([1, 0.1, 1]);
  expect(weightsOf(weighted)).toEqual([1, 0.1, 1]);
  expect(withWeight(weighted, 1, 1)).toEqual(ROUND);
  expect(withWeight(ROUND, 1, 1)).toBe(ROUND);
  const finer = withTerm(ROUND, 0, 8);
  expect(termsOf(finer)).toEqual([8, 4, 3]);
  expect(withTerm(finer, 0, 4)).toEqual(ROUND);
});

test("terms are whole, at least one, and no more than the solver takes", () => {
  expect(termsOf(withTerm(ROUND, 0, 2.6))[0]).toBe(3);
  expect(termsOf(withTerm(ROUND, 1, -4))[1]).toBe(1);
  expect(termsOf(withTerm(ROUND, 2, 1e9))[2]).toBe(64);
});

test("a rectangle is modal where nothing is said, and a disc over a square has no closed form", () => {
  const box: Blend = { ...ROUND, start: { ...ROUND.start, form: "rectangle", radius: [1, 1] } };
  expect(methodOf(box)).toBe("modal");
  expect(methodsFor(box)).toEqual(["exact", "modal", "collocation"]);
  const laid: Blend = { ...ROUND, start: { ...ROUND.start, form: "disc-in-square", radius: [1, 1] } };
  expect(methodsFor(laid)).toEqual(["modal", "collocation"]);
});

test("a method goes with the sections that it does not solve, and where it would hold anyway", () => {
  const laid: Blend = { ...ROUND, start: { ...ROUND.start, form: "disc-in-square", radius: [1, 1] } };
  expect(settled({ ...laid, method: "exact" })).toEqual(laid);
  expect(settled({ ...ROUND, method: "exact" })).toEqual(ROUND);
  const box: Blend = { ...ROUND, method: "exact", start: { ...ROUND.start, form: "rectangle", radius: [1, 1] } };
  expect(settled(box)).toBe(box);
  const modal: Blend = { ...ROUND, method: "modal" };
  expect(settled(modal)).toBe(modal);
  expect(settled(ROUND)).toBe(ROUND);
});

test("waves that the terms along v do not see are told, with as many as see them", () => {
  const petals = (n: number): Blend => ({
    ...ROUND,
    start: {
      form: "outline",
      x: [
        { n: 1, sin: 1 },
        { n, sin: 0.1 },
      ],
      y: [{ n: 1, cos: 1 }],
      ...level,
    },
  });
  expect(unseenOf(petals(5))).toBe(null);
  const modal = withMethod(petals(5), "modal");
  expect(unseenOf(modal)).toEqual({ waves: 5, terms: 4 });
  const enough = withEnoughTerms(modal);
  expect(enough && termsOf(enough)).toEqual([4, 10, 3]);
  expect(enough && unseenOf(enough)).toBe(null);
  expect(withEnoughTerms(withMethod(petals(129), "modal"))).toBe(null);
  expect(withEnoughTerms(withTerm(withMethod(petals(128), "modal"), 0, 17))).toBe(null);
  expect(unseenOf(withMethod(ROUND, "collocation"))).toBe(null);
});
