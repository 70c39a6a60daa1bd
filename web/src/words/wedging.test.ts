import { expect, test } from "vitest";
import { wedging } from "../document/wedging";
import { clayWords, countedWords } from "./wedging";

test("clay is weighed in what lengths are measured in", () => {
  expect(clayWords(640, "cm")).toBe("640\u00a0g");
  expect(clayWords(1234, "mm")).toBe("1.23\u00a0kg");
  expect(clayWords(1234, "in")).toBe("2.72\u00a0lb");
});

test("it is said what is counted", () => {
  const [counted, density] = countedWords(wedging(1000, 0, 20), "cm");
  expect(counted).toContain("1.95\u00a0kg for the pot itself");
  expect(counted).toContain("390\u00a0g to trim off");
  expect(density).toContain("1.95");
  expect(countedWords(wedging(1000, 0, 0), "cm")[0]).not.toContain("trim");
});
