import { beforeEach, expect, test } from "vitest";
import type { Design } from "../document/types";
import { type Port, SolverClient } from "./client";
import type { Reply, Request } from "./messages";

class FakePort implements Port {
  readonly sent: Request[] = [];
  stopped = false;
  onmessage: ((event: MessageEvent<Reply>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  postMessage(message: Request): void {
    this.sent.push(message);
  }
  terminate(): void {
    this.stopped = true;
  }
  reply(reply: object): void {
    this.onmessage?.({ data: reply as Reply } as MessageEvent<Reply>);
  }
}

const OPTIONS = { rows: 8, columns: 9, lines: false, part: 0, settle: false };
const design = (title: string): Design => ({ pasu: 1, title, parts: [] });
const titles = (port: FakePort) =>
  port.sent.map(({ ask }) => (ask.kind === "parse" ? ask.text : (ask.design.title ?? "")));

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
  port().reply({ id: port().sent[0]?.id, ok: true, answer: "A" });
  expect(titles(port())).toEqual(["a", "d"]);
  port().reply({ id: port().sent[1]?.id, ok: true, answer: "D" });
  expect(await Promise.all(outcomes)).toEqual([
    { state: "done", value: "A" },
    { state: "superseded" },
    { state: "superseded" },
    { state: "done", value: "D" },
  ]);
});

test("lanes do not wait for each other, and parsing is never superseded", () => {
  void client.solve(design("main"), OPTIONS);
  void client.mesh("compare", design("other"), 8, 9);
  void client.parse("one");
  void client.parse("two");
  expect(titles(port())).toEqual(["main", "other", "one", "two"]);
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
  for (const { id } of [...port().sent]) port().reply({ id, ok: true, answer: id });
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
  port(0).reply({ id, ok: true, answer: "late" });
  expect(await first).toMatchObject({ state: "refused" });
});
