import { expect, test } from "vitest";
import { settled } from "../../testing/held-worker";
import { JAR } from "../../testing/jar";
import { realMaker } from "../../testing/real-maker";
import { realSolver } from "../../testing/real-solver";
import { refusalWords } from "../words/refusals";
import { isDocument, readFile } from "./open-file";

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

const none = async () => null;

const readers = (maker: Parameters<typeof readFile>[1]["maker"] = none) => ({
  solver: realSolver({ free: true }).solver,
  maker,
});

test.each([
  ["vase.STL", /^“vase\.STL” cannot be opened: an STL holds triangles/],
  ["vase.3mf", /^“vase\.3mf” cannot be opened: it holds no design, because Pasu did not save it/],
])("%s without a design says why there is nothing to open", async (name, why) => {
  const { maker } = realMaker({ free: true });
  const file = new File([new Uint8Array(84)], name);
  const found = await readFile(
    file,
    readers(async () => maker),
  );
  if (found === null || !("refusal" in found)) throw new Error("opened");
  expect(refusalWords(found.refusal)).toMatch(why);
});

test("what Pasu saved opens again, and says how it was made", async () => {
  const { maker } = realMaker({ free: true });
  const making = { product: "solid", shrinkage: 12 } as const;
  const written = await maker.ask({ kind: "write", design: JAR, format: "glb", making });
  if (written.state !== "done") throw new Error(JSON.stringify(written));
  const found = await readFile(
    new File([written.value.bytes], "jar.glb"),
    readers(async () => maker),
  );
  expect(found).toMatchObject({ text: expect.stringContaining("fourth-order"), made: making });
});

test("nothing is opened where the maker cannot be fetched, or was asked for something newer", async () => {
  const file = new File([new Uint8Array(84)], "vase.glb");
  expect(await readFile(file, readers())).toBeNull();
  const { maker } = realMaker();
  const reading = readFile(
    file,
    readers(async () => maker),
  );
  await settled();
  maker.cancel("open");
  expect(await reading).toBeNull();
});

test.each([
  ["model.gltf", '{"asset":{"version":"2.0"}}'],
  ["holiday.json", '\ufeff\n{ "beach": true }'],
])("JSON of another program, as %s, is told to be no design", async (name, text) => {
  const found = await readFile(new File([text], name), readers());
  if (found === null || !("refusal" in found)) throw new Error("opened");
  expect(refusalWords(found.refusal)).toContain(`“${name}” cannot be opened: it holds no design`);
});

test.each([
  ["little", true],
  ["big", false],
])("a document in UTF-16, the %s end first, is read as any other", async (_, little) => {
  const text = '\ufeff{"pasu": 1}';
  const bytes = new DataView(new ArrayBuffer(2 * text.length));
  for (let i = 0; i < text.length; i += 1) bytes.setUint16(2 * i, text.charCodeAt(i), little);
  for (const name of ["vase.json", "vase"])
    expect(await readFile(new File([bytes], name), readers())).toEqual({ text: '{"pasu": 1}', made: null });
});

test.each(["pots", "pots.json", "pot.url"])("a folder called %s is told to be unreadable", async (name) => {
  const folder = new File([], name);
  const arrayBuffer = () => Promise.reject(new DOMException("it is a folder", "NotFoundError"));
  Object.assign(folder, { arrayBuffer, slice: () => folder });
  const found = await readFile(folder, readers());
  if (found === null || !("refusal" in found)) throw new Error("opened");
  expect(refusalWords(found.refusal)).toContain(`“${name}” cannot be read: it is a folder`);
});

test("a document does not say how it is to be made", async () => {
  const file = new File(['{"pasu": 1}'], "vase.json");
  expect(await readFile(file, readers())).toEqual({ text: '{"pasu": 1}', made: null });
});

test("of a text about a link the link is opened, and what holds none is read as it is", async () => {
  const read = (text: string) => readFile(new File([text], "mail.txt"), readers());
  const link = "https://pasu.example/?view=1,80,2#1/second-order?height=5";
  expect(await read(`See ${link}, and tell me.`)).toEqual({ text: link, made: null });
  for (const text of ["milk, eggs", "1/second-order?height=5", '{"pasu": 1, "title": "#1/ and more"}'])
    expect(await read(text)).toEqual({ text, made: null });
});
