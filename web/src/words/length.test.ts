import { expect, it } from "vitest";
import { lengthLabel } from "./length";

it("writes lengths in three digits with their unit", () => {
  for (const [length, text] of [
    [12.4, "12.4 cm"],
    [12.4321, "12.4 cm"],
    [3.3, "3.3 cm"],
    [3, "3 cm"],
    [0, "0 cm"],
    [0.0512, "0.0512 cm"],
    [999.6, "1000 cm"],
    [12345, "12300 cm"],
    [2.5e6, "2.5 × 10^6 cm"],
    [0.0000314159, "3.14 × 10^−5 cm"],
    [-1.5, "−1.5 cm"],
    [Number.NaN, "– cm"],
  ] as const) {
    expect(lengthLabel(length, "cm")).toBe(text);
  }
  expect(lengthLabel(2, "in")).toBe("2 in");
});
