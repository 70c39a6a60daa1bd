import { expect, test } from "vitest";
import { filled } from "./filled";

test("what is more than text stands where the sentence has its place, in the order of the language", () => {
  const [first, second] = [{ cite: "one" }, { cite: "two" }];
  expect(filled("After {0} and {1}.", [first, second])).toEqual(["After ", first, " and ", second, "."]);
  expect(filled("{1}, {0}", [first, second])).toEqual([second, ", ", first]);
  expect(filled("Nothing to fill in.", [first])).toEqual(["Nothing to fill in."]);
  expect(filled("{2} is not there", [first])).toEqual([" is not there"]);
});
