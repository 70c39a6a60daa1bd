import { expect, test } from "vitest";
import { marked, markedAll } from "./pseudo";

test("no letter of a text stays as it is, and its places to be filled do", () => {
  const text = marked("The quick brown fox jumps over THE LAZY DOG {0}, 12 % · “Jar”");
  expect(text.replace(/\{\d+\}/g, "")).not.toMatch(/[a-z]/i);
  expect(text).toMatch(/^⟦.*\{0\}.*⟧$/);
  expect(marked("")).toBe("");
});

test("lists, groups and what functions say are changed alike", () => {
  const words = markedAll({
    a: "b",
    list: ["c"],
    say: (name: string, count: number) => ({ text: `${name} ${count}` }),
  });
  expect(words.a).toBe("⟦ƀ⟧");
  expect(words.list).toEqual(["⟦ç⟧"]);
  expect(words.say("jar", 3)).toEqual({ text: "⟦ĵåŕ 3⟧" });
});

test("words that a function is given stay as they came: they have to be of the catalogue by themselves", () => {
  const { joined } = markedAll({ joined: (all: readonly string[], last: string) => `${all.join(", ")} and ${last}` });
  expect(joined(["cm", "⟦åŕéå⟧", "hard-coded"], "last")).toBe("⟦çɱ, ⟦åŕéå⟧, hard-coded åñð last⟧");
});
