import { expect, test } from "vitest";
import { rewrite, Written } from "./written";

test("ranges of triples are put where they belong", () => {
  const all = Float32Array.from({ length: 12 }, (_, place) => place);
  rewrite(all, Float32Array.of(-1, -2, -3, -4, -5, -6), Uint32Array.of(0, 1, 3, 1));
  expect([...all]).toEqual([-1, -2, -3, 3, 4, 5, 6, 7, 8, -4, -5, -6]);
});

test("what was written since a revision is told, as long as that is known", () => {
  const written = new Written();
  expect(written.since(3)).toBeNull();
  const ranges = Array.from({ length: 20 }, (_, place) => Uint32Array.of(place, 1));
  for (const [place, each] of ranges.entries()) written.note(3 + 2 * place, 5 + 2 * place, each);
  // The newest first of all, those that are too long ago not any more.
  expect(written.since(41)).toEqual([ranges[19]]);
  expect(written.since(37)).toEqual(ranges.slice(17));
  expect(written.since(3)).toBeNull();
  expect(written.since(42)).toBeNull();
  expect(written.since(43)).toBeNull();
});
