import { expect, test } from "vitest";
import { customaryWords, localVolumeWords, poundsShown } from "./customary";
import { words } from "./quantities";

const plain = (text: string) => text.replaceAll("\u00a0", " ");

test("ounces below a pint, pints below a gallon, gallons from there on", () => {
  expect([330, 473.176473, 3700, 96290].map((each) => plain(customaryWords(each)))).toEqual([
    "11.2 US fl oz",
    "1 US pt",
    "7.82 US pt",
    "25.4 US gal",
  ]);
});

test("a volume is told as it is measured where lengths are in the unit of the design", () => {
  expect(plain(localVolumeWords(1000, "cm", 3))).toBe("1 l");
  expect(plain(localVolumeWords(20, "in", 3))).toBe("11.1 US fl oz");
});

test("a pound has 453.59237 g", () => {
  expect(plain(words(907.18474, poundsShown()))).toBe("2 lb");
});
