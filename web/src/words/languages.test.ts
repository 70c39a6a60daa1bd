import { afterEach, expect, test } from "vitest";
import { ENGLISH, speak, spokenTag } from "../language";
import type { Catalogue } from "./catalogue";
import { help } from "./english/help";
import { page } from "./english/page";
import { choose, languageOf, tagFor } from "./languages";

afterEach(() => speak(ENGLISH));

test("the first language that is wanted and known is spoken, whatever its region", () => {
  expect(tagFor(["fr-CA", "de-AT", "en"], ["de", "pt-BR"])).toBe("de");
  expect(tagFor(["pt-br"], ["de", "pt-BR"])).toBe("pt-BR");
  expect(tagFor(["en-GB", "de"], ["de"])).toBe("en");
  expect(tagFor(["ja"], ["de"])).toBe("en");
  expect(tagFor([], ["de"])).toBe("en");
});

test("a catalogue takes the place of the English words, room by room", () => {
  const catalogue = { page: { ...page, undo: "Rückgängig", part: (number: number) => `Teil ${number}` } } as Catalogue;
  speak(languageOf("de", catalogue));
  expect([page.undo, page.part(2), help.heading]).toEqual(["Rückgängig", "Teil 2", "Help"]);
});

test("English is there at once, and what nobody knows is English", () => {
  expect(choose(null, ["en-GB", "en"])).toBeNull();
  expect(choose("tlh", ["ja"])).toBeNull();
  expect(spokenTag()).toBe("en");
});

test("the pseudo-language of the tests is fetched when it is asked for by name, and never preferred", async () => {
  expect(choose(null, ["en-XA"])).toBeNull();
  await choose("en-XA", ["en"]);
  expect(spokenTag()).toBe("en-XA");
  expect(page.undo).toBe("⟦Ûñðö⟧");
});
