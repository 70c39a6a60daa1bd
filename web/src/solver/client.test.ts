import { beforeEach, expect, test } from "vitest";
import type { Design, Part, Shape } from "../document/types";
import type { Told } from "../worker/port";
import { SolverClient } from "./client";
import type { Desk, SolveOptions } from "./desk";
import type { PartMesh, Reply, Request, SentMesh, SentParts, SolverPort } from "./messages";

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
/** A design whose part has a shape of its own, by which one knows it again. */
const design = (name: string): Design => ({
  pasu: 1,
  parts: [{ shape: { ...PART.shape, name } as unknown as Part["shape"] }],
});
const scene = (name: string) => ({ design: design(name), ids: [0] });
const titles = (port: FakePort) =>
  port.sent.map(({ ask }) => {
    if (ask.kind === "parts") return ask.parts.map(({ shape }) => (shape as unknown as { name: string }).name).join();
    if (ask.kind === "read") return ask.kind;
    return ask.kind === "parse" ? ask.text : ask.order;
  });

const made = (topology: string, vertices: number, whole: boolean): SentMesh => ({
  positions: new Float32Array(3 * vertices),
  normals: new Float32Array(3 * vertices),
  topology,
  ware: { texels: new Float32Array(4), rows: 1, columns: 1 },
  lattice: whole ? { uvs: new Float32Array(2 * vertices), indices: new Uint32Array(3) } : null,
});

/** An answer with one mesh. */
const answer = (mesh: SentMesh = made("a", 72, true)): SentParts => ({
  parts: [
    {
      id: 0,
      mesh,
      told: { reach: new Float32Array(3), bounds: null, body: null, closed: true },
      lines: null,
      section: null,
    },
  ],
  whole: null,
  times: { begun: 0, meshed: 0, glazed: 0, done: 0 },
});

let ports: FakePort[];
let client: SolverClient;
let desk: Desk;
const port = (index = ports.length - 1) => ports[index] as FakePort;

beforeEach(() => {
  ports = [];
  client = new SolverClient(() => {
    ports.push(new FakePort());
    return port();
  });
  desk = client.desk();
});

test("one under way, one waiting, the latest wins", async () => {
  const outcomes = ["a", "b", "c", "d"].map((title) => desk.solve(scene(title), OPTIONS));
  expect(titles(port())).toEqual(["a"]);
  port().reply({ id: port().sent[0]?.id, ok: true, answer: answer() });
  expect(titles(port())).toEqual(["a", "d"]);
  port().reply({ id: port().sent[1]?.id, ok: true, answer: answer() });
  const states = (await Promise.all(outcomes)).map(({ state }) => state);
  expect(states).toEqual(["done", "superseded", "superseded", "done"]);
});

test("lanes do not wait for each other, and parsing is never superseded", () => {
  void desk.solve(scene("main"), OPTIONS);
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
  const blamed = desk.solve(scene("bad"), OPTIONS);
  const innocent = client.parse("good");
  const waiting = desk.solve(scene("next"), OPTIONS);
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
  for (const { id } of [...port().sent]) port().reply({ id, ok: true, answer: answer() });
  expect((await innocent).state).toBe("done");
  expect((await waiting).state).toBe("done");
});

test("a worker that dies is replaced too", async () => {
  const outcome = desk.solve(scene("bad"), OPTIONS);
  port().onerror?.({} as ErrorEvent);
  expect(await outcome).toMatchObject({ state: "refused" });
  void desk.solve(scene("next"), OPTIONS);
  expect(titles(port())).toEqual(["next"]);
});

test("late replies of an old worker are ignored", async () => {
  const first = desk.solve(scene("bad"), OPTIONS);
  const id = port().sent[0]?.id;
  port().onerror?.({} as ErrorEvent);
  port(0).reply({ id, ok: true, answer: answer() });
  expect(await first).toMatchObject({ state: "refused" });
});

/** Asks for a mesh of so many vertices and gets it. */
async function solved(sent: SentMesh): Promise<PartMesh> {
  const outcome = desk.solve(scene(""), OPTIONS);
  port().reply({ id: port().sent.at(-1)?.id, ok: true, answer: answer(sent) });
  const value = await outcome;
  const part = value.state === "done" ? value.value.parts[0] : undefined;
  if (!part) throw new Error(value.state);
  return part.mesh;
}

test("what depends on the grid alone comes once, and every mesh has the very same arrays", async () => {
  const first = await solved(made("a", 72, true));
  expect(port().sent[0]?.known).toEqual([]);
  const second = await solved(made("a", 72, false));
  expect(port().sent[1]?.known).toEqual(["a"]);
  expect(second.indices).toBe(first.indices);
  expect(second.uvs).toBe(first.uvs);
  for (const topology of ["b", "c", "d", "e", "f", "a", "g"]) await solved(made(topology, 72, topology !== "a"));
  void desk.solve(scene(""), OPTIONS);
  expect(port().sent.at(-1)?.known).toEqual(["c", "d", "e", "f", "a", "g"]);
});

test("arrays that are given back travel to the worker, once, when the size is right", async () => {
  const mesh = await solved(made("a", 72, true));
  client.recycle(mesh);
  client.recycle(await solved(made("b", 6, true)));
  const { sent, transferred } = port();
  // The first was on its way with the second request.
  expect(sent[1]?.spares[0]?.positions).toBe(mesh.positions);
  expect(transferred[1]).toEqual([mesh.positions.buffer, mesh.normals.buffer, mesh.ware.texels.buffer]);
  await solved(made("a", 72, false));
  expect(sent[2]?.spares).toEqual([null]);
  expect(transferred[2]).toEqual([]);
});

test("a lattice that others put out meanwhile is still there for a mesh under way", async () => {
  const first = await solved(made("a", 72, true));
  const late = desk.solve(scene(""), OPTIONS);
  const id = port().sent.at(-1)?.id;
  for (const topology of ["b", "c", "d", "e", "f", "g"]) {
    const other = client.mesh(topology, design(""), 8, 9);
    port().reply({ id: port().sent.at(-1)?.id, ok: true, answer: answer(made(topology, 72, true)) });
    await other;
  }
  port().reply({ id, ok: true, answer: answer(made("a", 72, false)) });
  expect(await late).toMatchObject({ state: "done", value: { parts: [{ mesh: { indices: first.indices } }] } });
});
