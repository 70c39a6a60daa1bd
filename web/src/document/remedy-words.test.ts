import { expect, test } from "vitest";
import { remedyWords } from "./remedy-words";
import type { Wall } from "./types";

const plain: Wall = { thickness: 0.4, base: 0.5 };
const asked: Wall = { ...plain, foot: [0.45, 0.43], drain: 1 };
const words = (wall: Wall, from: Wall = asked) => remedyWords(from, wall, "cm").replaceAll("\u00a0", " ");

test("a button says what is different and nothing else", () => {
  expect(words({ ...asked, foot: [0.9, 0.21] })).toBe("Make it with a ring 0.9 cm wide and 0.21 cm high");
  expect(words(plain)).toBe("Make it with no ring and no drain");
  expect(words({ ...asked, thickness: 0.12 })).toBe("Make it with a wall of 0.12 cm");
  expect(words({ ...asked, base: 0.25, drain: 0.5 })).toBe("Make it with a base of 0.25 cm and a drain of 0.5 cm");
  expect(words({ ...asked, side: "outside" })).toBe("Make it with the clay laid outwards");
});

test("what is left out is the same as what is usual", () => {
  expect(words({ ...plain, rim: "flat" }, { ...plain, side: "outside", rim: "rounded" })).toBe(
    "Make it with the clay laid inwards and a flat rim",
  );
  expect(words({ ...plain, side: "inside", rim: "flat", drain: 0, thickness: 0.1 }, plain)).toBe(
    "Make it with a wall of 0.1 cm",
  );
});
