import { beforeEach, expect, test } from "vitest";
import type { Design } from "../document/types";
import type { Told } from "../worker/port";
import { MakerClient } from "./client";
import type { MakerPort, Reply, Request } from "./messages";

class FakePort implements MakerPort {
  readonly sent: Request[] = [];
  stopped = false;
  onmessage: ((event: MessageEvent<Reply | Told>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  postMessage(message: Request): void {
    this.sent.push(message);
  }
  terminate(): void {
    this.stopped = true;
  }
  tell(done: number, id = this.sent.at(-1)?.id): void {
    this.onmessage?.({ data: { id, done } as Told } as MessageEvent<Told>);
  }
  answer(answer: unknown): void {
    const id = this.sent.at(-1)?.id;
    this.onmessage?.({ data: { id, ok: true, answer } as Reply } as MessageEvent<Reply>);
  }
}

const design = (title: string): Design => ({ pasu: 1, title, parts: [] });

let ports: FakePort[];
let waiting: (() => void)[];
let client: MakerClient;
const port = () => ports.at(-1) as FakePort;
const kinds = () => ports.flatMap(({ sent }) => sent.map(({ ask }) => ask.kind));
const solid = (title: string) => client.ask({ kind: "solid", design: design(title), tolerance: 1, fine: false });
const water = (level: number) => client.ask({ kind: "water", design: design(""), level });
const check = (title: string) => client.ask({ kind: "check", design: design(title), making: {} });

beforeEach(() => {
  ports = [];
  waiting = [];
  client = new MakerClient(
    () => {
      ports.push(new FakePort());
      return port();
    },
    (run) => {
      waiting.push(run);
      return () => {
        waiting = waiting.filter((each) => each !== run);
      };
    },
  );
});

test("a picture is made finer when nothing else is wanted", () => {
  const fine = { kind: "solid", design: design(""), tolerance: 0.1, fine: true } as const;
  void water(1);
  void client.ask(fine);
  void check("a");
  port().answer("wet");
  port().answer("checked");
  expect(kinds()).toEqual(["water", "check", "solid"]);
});

test("no worker is started before something is asked", () => {
  expect(ports).toEqual([]);
  expect(client.busy).toBe(false);
  void solid("a");
  expect(ports).toHaveLength(1);
  expect(client.busy).toBe(true);
});

test("one under way at a time, what is looked at first, the latest of each kind wins", async () => {
  const first = check("a");
  const lost = solid("b");
  const wet = water(1);
  const kept = solid("c");
  expect(kinds()).toEqual(["check"]);
  port().answer("checked");
  port().answer("wet");
  port().answer("solid");
  expect(kinds()).toEqual(["check", "water", "solid"]);
  expect(await first).toEqual({ state: "done", value: "checked" });
  expect(await lost).toEqual({ state: "superseded" });
  expect(await wet).toEqual({ state: "done", value: "wet" });
  expect(await kept).toEqual({ state: "done", value: "solid" });
  expect(client.busy).toBe(false);
});

test("whoever asks for something of its own has a lane of its own", async () => {
  const panel = check("a");
  const dialogue = client.ask({ kind: "check", design: design("b"), making: {} }, "dialogue");
  port().answer("for the panel");
  port().answer("for the dialogue");
  expect(await panel).toEqual({ state: "done", value: "for the panel" });
  expect(await dialogue).toEqual({ state: "done", value: "for the dialogue" });
});

test("what is under way may end by itself within a moment, and is handed over", async () => {
  const old = solid("a");
  const young = solid("b");
  expect(waiting).toHaveLength(1);
  port().answer("old");
  expect(await old).toEqual({ state: "done", value: "old" });
  expect(waiting).toEqual([]);
  port().answer("young");
  expect(await young).toEqual({ state: "done", value: "young" });
  expect(ports).toHaveLength(1);
});

test("what goes on too long is ended with its worker, and others are asked again", async () => {
  const old = check("a");
  const wet = water(2);
  const young = check("b");
  waiting[0]?.();
  expect(ports[0]?.stopped).toBe(true);
  expect(await old).toEqual({ state: "superseded" });
  expect(ports).toHaveLength(2);
  port().answer("wet");
  port().answer("young");
  expect(await wet).toEqual({ state: "done", value: "wet" });
  expect(await young).toEqual({ state: "done", value: "young" });
});

test("cancelling ends what is under way at once and forgets what waits", async () => {
  const written = client.ask({ kind: "write", design: design("a"), format: "stl", making: {} });
  const checked = check("a");
  const drawn = solid("a");
  client.cancel("write", "check");
  expect(ports[0]?.stopped).toBe(true);
  expect(await written).toEqual({ state: "superseded" });
  expect(await checked).toEqual({ state: "superseded" });
  port().answer("drawn");
  expect(await drawn).toEqual({ state: "done", value: "drawn" });
  expect(kinds()).toEqual(["write", "solid"]);
});

test("a trapped module is replaced, the one to blame refused, the next one asked", async () => {
  const blamed = solid("bad");
  const next = water(1);
  const refusal = { code: "internal", path: "", message: "" };
  const id = port().sent[0]?.id ?? 0;
  port().onmessage?.({ data: { id, ok: false, refusal, broken: true } } as MessageEvent<Reply>);
  expect(ports[0]?.stopped).toBe(true);
  expect(await blamed).toMatchObject({ state: "refused", refusal: { code: "maker-stopped" } });
  port().answer("wet");
  expect(await next).toEqual({ state: "done", value: "wet" });
});

test("a refusal comes back as it was said, and late replies of an ended worker are ignored", async () => {
  const lost = solid("a");
  const old = port();
  client.cancel("solid");
  expect(await lost).toEqual({ state: "superseded" });
  const young = solid("b");
  old.answer("late");
  const refusal = { code: "cannot-be-a-pot", path: "parts[0]", message: "The wall does not close." };
  const id = port().sent[0]?.id ?? 0;
  port().onmessage?.({ data: { id, ok: false, refusal, broken: false } } as MessageEvent<Reply>);
  expect(await young).toEqual({ state: "refused", refusal });
});

test("who asked hears how far the work is, until it is done or given up", async () => {
  const heard: number[] = [];
  const first = client.ask({ kind: "check", design: design("a"), making: {} }, "first", (done) => heard.push(done));
  const firstId = port().sent.at(-1)?.id;
  port().tell(0);
  port().tell(0.5);
  expect(heard).toEqual([0, 0.5]);
  port().answer("checked");
  expect(await first).toEqual({ state: "done", value: "checked" });
  void check("b");
  port().tell(0.75, firstId);
  port().tell(0.25);
  expect(heard).toEqual([0, 0.5]);
});
