import { expect, test } from "vitest";
import type { Provenance } from "../document/types";
import { isDocument, readFile } from "./open-file";
import type { Workshop } from "./workshop";

test.each([
  ["vase.json", "milk, eggs", true],
  ["link.txt", "anything", true],
  ["vase", ' {"pasu": 1}', true],
  ["vase", "\ufeff{", true],
  ["vase.url", "https://example.org/#1/second-order", true],
  ["vase", "#1/second-order?height=5", true],
  ["vase", "1~abcd", true],
  ["vase.obj", "# Pasu 1\nv 0 0 0", false],
  ["vase.stl", "\0\0\0", false],
  ["vase.step", "ISO-10303-21;", false],
  ["vase.svg", "<svg", false],
])("%s beginning with %j", (name, beginning, document) => {
  expect(isDocument(name, beginning)).toBe(document);
});

/** A workshop that finds this in every file. */
const finding = (value: Provenance | null) => async () =>
  ({ maker: { ask: async () => ({ state: "done", value }) } }) as unknown as Workshop;

test.each([
  ["vase.STL", /^“vase\.STL” cannot be opened: an STL holds triangles/],
  ["vase.3mf", /^“vase\.3mf” cannot be opened: it holds no design, because Pasu did not save it/],
])("%s without a design says why there is nothing to open", async (name, why) => {
  const file = new File([new Uint8Array(84)], name);
  expect(await readFile(file, finding(null))).toMatchObject({
    refusal: { code: "no-design", message: expect.stringMatching(why) },
  });
  const made = { product: "solid", shrinkage: 12 } as const;
  expect(await readFile(file, finding({ link: "1/second-order", making: made }))).toEqual({
    text: "1/second-order",
    made,
  });
  expect(await readFile(file, finding({ link: "1/x", making: null }))).toEqual({ text: "1/x", made: null });
});

test("a document does not say how it is to be made", async () => {
  const file = new File(['{"pasu": 1}'], "vase.json");
  expect(await readFile(file, finding(null))).toEqual({ text: '{"pasu": 1}', made: null });
});
