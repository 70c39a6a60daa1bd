import { expect, test } from "vitest";
import {
  angleWords,
  areaWords,
  degreesWords,
  errorWords,
  lengthWords,
  massShown,
  volumeWords,
  words,
} from "./quantities";

const plain = (text: string) => text.replaceAll("\u00a0", " ");

test.each([
  [lengthWords(12.345678, "cm"), "12.35 cm"],
  [areaWords(0.5, "in"), "0.5 in²"],
  [volumeWords(820.04, "cm"), "820 ml"],
  [volumeWords(999.6, "cm"), "0.9996 l"],
  [volumeWords(1_500_000, "mm"), "1.5 l"],
  [volumeWords(100, "mm"), "0.1 ml"],
  [volumeWords(61.0237, "in"), "1 l"],
  [words(412.34, massShown(412.34)), "412.3 g"],
  [words(2300, massShown(2300)), "2.3 kg"],
  [angleWords(61.96), "62°"],
  [angleWords(-4.04), "−4°"],
  [degreesWords(1.2), "1 degree"],
  [degreesWords(61.6), "62 degrees"],
  [errorWords(0), "exact"],
  [errorWords(2.1e-13), "± 3 × 10⁻¹³"],
  [errorWords(9.9e-13), "± 10⁻¹²"],
  [errorWords(0.02), "± 0.02"],
  [errorWords(1e-10), "± 10⁻¹⁰"],
  [errorWords(Number.NaN), ""],
])("%s", (text, wanted) => {
  expect(plain(text)).toBe(wanted);
});
