import { expect, test } from "vitest";
import { wedging } from "../document/wedging";
import { clayWords, countedWords } from "./wedging";

test("clay is weighed in what lengths are measured in", () => {
  expect(clayWords(640, "cm")).toBe("640\u00a0g");
  expect(clayWords(1234, "mm")).toBe("1.23\u00a0kg");
  expect(clayWords(1234, "in")).toBe("2.72\u00a0lb");
});

test("it is said what is counted", () => {
  const [counted, density] = countedWords(wedging(1000, 0, 20), 1900, "cm");
  expect(counted).toContain("1.95\u00a0kg for the pot itself");
  expect(counted).toContain("390\u00a0g to trim off");
  expect(density).toContain("1.95");
  expect(countedWords(wedging(1000, 0, 0), 1900, "cm")[0]).not.toContain("trim");
});

test("clay that would gain weight in the kiln is said to", () => {
  // What is fired weighs 2.3 g/cm³: at less than some 5 % it would weigh more than when it was wet.
  expect(countedWords(wedging(1000, 0, 20), 2300, "cm")[0]).toContain("Fired, the pot weighs 2.3\u00a0kg");
  expect(countedWords(wedging(1000, 5, 20), 2300, "cm")[0]).toContain("gains weight");
  expect(countedWords(wedging(1000, 6, 20), 2300, "cm")[0]).toContain("for the pot itself");
});
