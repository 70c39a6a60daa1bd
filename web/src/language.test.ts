import { afterEach, expect, test } from "vitest";
import { decimal, ENGLISH, either, grouped, isolated, listed, phrases, plural, speak } from "./language";

const german = { ...ENGLISH, tag: "de" };

afterEach(() => speak(ENGLISH));

test("numbers, counts and lists are those of the language", () => {
  const said = () => [decimal(-1234.5678, 6), grouped(1234567), listed(["a", "b", "c"]), either(["a", "b"])];
  expect(said()).toEqual(["−1234.57", "1,234,567", "a, b, and c", "a or b"]);
  speak(german);
  expect(said()).toEqual(["−1234,57", "1.234.567", "a, b und c", "a oder b"]);
  // Digits that can be typed again.
  speak({ ...ENGLISH, tag: "ar" });
  expect(decimal(12.5, 6)).toMatch(/^12.5$/);
});

test("the form of a word goes with the count, by the rules of the language", () => {
  const forms = { one: "one", few: "few", many: "many", other: "other" };
  const said = () => [0, 1, 2, 5, 22].map((count) => plural(count, forms));
  expect(said()).toEqual(["other", "one", "other", "other", "other"]);
  speak({ ...ENGLISH, tag: "pl" });
  expect(said()).toEqual(["many", "one", "few", "many", "few"]);
  expect(plural(2, { other: "all" })).toBe("all");
});

test("words are those of the language that is spoken when they are read", () => {
  const greeting = phrases("greeting", { hello: "Hello", to: (name: string) => `Hello, ${name}` });
  expect([greeting.hello, greeting.to("Ada")]).toEqual(["Hello", "Hello, Ada"]);
  speak({
    tag: "de",
    say: <T extends object>(room: string, english: T) =>
      room === "greeting" ? ({ hello: "Hallo", to: (name: string) => `Hallo, ${name}` } as unknown as T) : english,
  });
  expect([greeting.hello, greeting.to("Ada")]).toEqual(["Hallo", "Hallo, Ada"]);
});

test("foreign text cannot turn the sentence round that it stands in", () => {
  expect(isolated("Krug 2, größer")).toBe("Krug 2, größer");
  expect(isolated("כד")).toBe("\u2068כד\u2069");
  expect(isolated("jar\u202egnp")).toBe("\u2068jar\u202egnp\u2069");
  // A mark of its own does not end the isolation.
  expect(isolated("a\u2069\u202eb")).toBe("\u2068a\u202eb\u2069");
});
