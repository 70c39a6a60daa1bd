import { expect, test } from "vitest";
import type { Wall } from "../document/types";
import { fittedWords, remedyWords } from "./remedies";

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

test("an inside of its own that is given up follows the outside", () => {
  expect(words(plain, { ...plain, lining: { waves: 3 } })).toBe("Make it with an inside that follows the outside");
});

test("what is left out is the same as what is usual", () => {
  expect(words({ ...plain, rim: "flat" }, { ...plain, side: "outside", rim: "rounded" })).toBe(
    "Make it with the clay laid inwards and a flat rim",
  );
  expect(words({ ...plain, side: "inside", rim: "flat", drain: 0, thickness: 0.1 }, plain)).toBe(
    "Make it with a wall of 0.1 cm",
  );
});

test("what was fitted is said with the size that is made", () => {
  const found = (code: string, wall: Wall | null) => {
    const remedy = wall && { path: "parts[0].wall", wall, message: "" };
    const told = fittedWords(
      { code, severity: "warning", part: 0, path: null, message: "", args: {}, at: null, remedy },
      "cm",
    );
    return told?.replaceAll("\u00a0", " ");
  };
  const made = { ...asked, foot: [0.9, 0.21], drain: 0.5 } as const;
  expect(found("fitted-foot", made)).toBe(
    "There is no room for the foot ring that was asked for: it is made 0.9 cm wide and 0.21 cm high.",
  );
  expect(found("fitted-drain", made)).toBe(
    "There is no room for the drain that was asked for: it is made 0.5 cm wide.",
  );
  expect(found("no-room", made)).toBeUndefined();
  expect(found("fitted-foot", null)).toBeUndefined();
});
