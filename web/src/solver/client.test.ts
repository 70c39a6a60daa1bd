import { beforeEach, expect, test } from "vitest";
import type { Design, Part, Shape } from "../document/types";
import type { Told } from "../worker/port";
import { SolverClient } from "./client";
import type { MeshArrays, Reply, Request, SentMesh, SolveOptions, SolverPort } from "./messages";

class FakePort implements SolverPort {
  readonly sent: Request[] = [];
  readonly transferred: Transferable[][] = [];
  stopped = false;
  onmessage: ((event: MessageEvent<Reply | Told>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  postMessage(message: Request, transfer: Transferable[]): void {
    this.sent.push(message);
    this.transferred.push(transfer);
  }
  terminate(): void {
    this.stopped = true;
  }
  reply(reply: object): void {
    this.onmessage?.({ data: reply as Reply } as MessageEvent<Reply>);
  }
}

const OPTIONS: SolveOptions = { rows: 8, columns: 9, lines: false, section: null, settle: false };
const PART = { shape: { kind: "fourth-order" } } as unknown as Part;
const design = (title: string): Design => ({ pasu: 1, title, parts: [PART] });
/** An answer without a mesh: what comes back is what was sent. */
const answer = (name: string) => ({ design: name });
const titles = (port: FakePort) =>
  port.sent.map(({ ask }) =>
    "design" in ask ? (ask.design.title ?? "") : ask.kind === "parse" ? ask.text : ask.order,
  );

let ports: FakePort[];
let client: SolverClient;
const port = (index = ports.length - 1) => ports[index] as FakePort;

beforeEach(() => {
  ports = [];
  client = new SolverClient(() => {
    ports.push(new FakePort());
    return port();
  });
});

test("one under way, one waiting, the latest wins", async () => {
  const outcomes = ["a", "b", "c", "d"].map((title) => client.solve(design(title), OPTIONS));
  expect(titles(port())).toEqual(["a"]);
  port().reply({ id: port().sent[0]?.id, ok: true, answer: answer("A") });
  expect(titles(port())).toEqual(["a", "d"]);
  port().reply({ id: port().sent[1]?.id, ok: true, answer: answer("D") });
  expect(await Promise.all(outcomes)).toEqual([
    { state: "done", value: answer("A") },
    { state: "superseded" },
    { state: "superseded" },
    { state: "done", value: answer("D") },
  ]);
});

test("lanes do not wait for each other, and parsing is never superseded", () => {
  void client.solve(design("main"), OPTIONS);
  void client.mesh("compare", design("other"), 8, 9);
  void client.parse("one");
  void client.parse("two");
  expect(titles(port())).toEqual(["main", "other", "one", "two"]);
});

test("a vase in another order comes as it was sent, the latest of its lane", async () => {
  const shape: Shape = { kind: "second-order", r: [1, 0, 0.6, 0] };
  const first = client.convert("switch", shape, "mixed-order");
  const second = client.convert("switch", shape, "mixed-order");
  const third = client.convert("switch", shape, "fourth-order");
  const beside = client.convert("compare", shape, "mixed-order");
  expect(titles(port())).toEqual(["mixed-order", "mixed-order"]);
  const converted = { shape, lost: ["petals"] };
  for (const index of [0, 1, 2]) port().reply({ id: port().sent[index]?.id, ok: true, answer: converted });
  const done = { state: "done", value: converted };
  expect(await Promise.all([first, second, third, beside])).toEqual([done, { state: "superseded" }, done, done]);
  expect(titles(port())).toEqual(["mixed-order", "mixed-order", "fourth-order"]);
});

test("a refusal comes back as it was said", async () => {
  const outcome = client.parse("#1/nonsense");
  const refusal = { code: "damaged-link", path: "", message: "No." };
  port().reply({ id: port().sent[0]?.id, ok: false, refusal, broken: false });
  expect(await outcome).toEqual({ state: "refused", refusal });
});

test("a trapped module is replaced, the one to blame refused, the rest asked again", async () => {
  const blamed = client.solve(design("bad"), OPTIONS);
  const innocent = client.parse("good");
  const waiting = client.solve(design("next"), OPTIONS);
  port().reply({
    id: port().sent[0]?.id,
    ok: false,
    refusal: { code: "internal", path: "", message: "" },
    broken: true,
  });
  expect(port(0).stopped).toBe(true);
  expect(ports.length).toBe(2);
  expect(await blamed).toMatchObject({ state: "refused", refusal: { code: "solver-stopped" } });
  expect(titles(port()).sort()).toEqual(["good", "next"]);
  for (const { id } of [...port().sent]) port().reply({ id, ok: true, answer: answer(String(id)) });
  expect((await innocent).state).toBe("done");
  expect((await waiting).state).toBe("done");
});

test("a worker that dies is replaced too", async () => {
  const outcome = client.solve(design("bad"), OPTIONS);
  port().onerror?.({} as ErrorEvent);
  expect(await outcome).toMatchObject({ state: "refused" });
  void client.solve(design("next"), OPTIONS);
  expect(titles(port())).toEqual(["next"]);
});

test("late replies of an old worker are ignored", async () => {
  const first = client.solve(design("bad"), OPTIONS);
  const id = port().sent[0]?.id;
  port().onerror?.({} as ErrorEvent);
  port(0).reply({ id, ok: true, answer: answer("late") });
  expect(await first).toMatchObject({ state: "refused" });
});

const made = (topology: string, vertices: number, whole: boolean): SentMesh => ({
  positions: new Float32Array(3 * vertices),
  normals: new Float32Array(3 * vertices),
  topology,
  ware: { texels: new Float32Array(4), rows: 1, columns: 1 },
  bounds: null,
  lattice: whole
    ? { uvs: new Float32Array(2 * vertices), indices: new Uint32Array(3), groups: new Uint32Array(3) }
    : null,
});

/** Asks for a mesh of so many vertices and gets it. */
async function solved(sent: SentMesh): Promise<MeshArrays> {
  const outcome = client.solve(design(""), OPTIONS);
  port().reply({ id: port().sent.at(-1)?.id, ok: true, answer: { mesh: sent } });
  const value = await outcome;
  if (value.state !== "done") throw new Error(value.state);
  return value.value.mesh;
}

test("what depends on the grid alone comes once, and every mesh has the very same arrays", async () => {
  const first = await solved(made("a", 72, true));
  expect(port().sent[0]?.known).toEqual([]);
  const second = await solved(made("a", 72, false));
  expect(port().sent[1]?.known).toEqual(["a"]);
  expect(second.indices).toBe(first.indices);
  expect(second.uvs).toBe(first.uvs);
  for (const topology of ["b", "c", "a", "d"]) await solved(made(topology, 72, topology !== "a"));
  void client.solve(design(""), OPTIONS);
  expect(port().sent.at(-1)?.known).toEqual(["c", "a", "d"]);
});

test("arrays that are given back travel to the worker, once, when the size is right", async () => {
  const mesh = await solved(made("a", 72, true));
  client.recycle(mesh);
  client.recycle(await solved(made("b", 6, true)));
  const { sent, transferred } = port();
  // The first was on its way with the second request.
  expect(sent[1]?.spare?.positions).toBe(mesh.positions);
  expect(transferred[1]).toEqual([mesh.positions.buffer, mesh.normals.buffer, mesh.ware.texels.buffer]);
  await solved(made("a", 72, false));
  expect(sent[2]?.spare).toBeNull();
  expect(transferred[2]).toEqual([]);
});

test("a lattice that others put out meanwhile is still there for a mesh under way", async () => {
  const first = await solved(made("a", 72, true));
  const late = client.solve(design(""), OPTIONS);
  const id = port().sent.at(-1)?.id;
  for (const topology of ["b", "c", "d"]) {
    const other = client.mesh(topology, design(""), 8, 9);
    port().reply({ id: port().sent.at(-1)?.id, ok: true, answer: made(topology, 72, true) });
    await other;
  }
  port().reply({ id, ok: true, answer: { mesh: made("a", 72, false) } });
  expect(await late).toMatchObject({ state: "done", value: { mesh: { indices: first.indices } } });
});
