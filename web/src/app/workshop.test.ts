import { beforeEach, expect, test } from "vitest";
import type { Design, Part } from "../document/types";
import { MakerClient, type Port } from "../maker/client";
import type { Ask, Reply, Request } from "../maker/messages";
import { NEW_SESSION, type Session } from "../state/session";
import type { Designer } from "./designer";
import { Workshop } from "./workshop";

class FakePort implements Port {
  onmessage: ((event: MessageEvent<Reply>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  constructor(private readonly sent: Request[]) {}
  postMessage(message: Request): void {
    this.sent.push(message);
  }
  terminate(): void {}
  answer(answer: unknown): void {
    const id = this.sent.at(-1)?.id;
    this.onmessage?.({ data: { id, ok: true, answer } as Reply } as MessageEvent<Reply>);
  }
}

const PART = { shape: { kind: "fourth-order" } } as unknown as Part;
const WALLED: Part = { ...PART, wall: { thickness: 1, base: 1 } };
const design = (part: Part = WALLED): Design => ({ pasu: 1, parts: [part] });
const MEASURES = { capacity: { floor: 1, spill: { level: { value: 5, error: 0 } } } };

let sent: Request[];
let port: FakePort;
let listeners: (() => void)[];
let workshop: Workshop;
let now: { design: Design; session: Session; settled: boolean };

/** The designer as far as the workshop looks at it. */
function designer(): Designer {
  return {
    get state() {
      return { design: now.design, session: now.session };
    },
    get shown() {
      return { design: now.design, settled: now.settled };
    },
    grid: () => ({ rows: 3, columns: 4 }),
    subscribe: (listener: () => void) => listeners.push(listener),
    touched: () => {},
  } as unknown as Designer;
}

function change(next: Partial<typeof now>): void {
  now = { ...now, ...next };
  for (const listener of listeners) listener();
}

const asks = () => sent.map(({ ask }) => ask.kind);
const last = () => sent.at(-1)?.ask as Ask;
/** Answers what is under way; what it leads to happens before the next line. */
async function answer(value: unknown): Promise<void> {
  port.answer(value);
  await Promise.resolve();
  await Promise.resolve();
}

beforeEach(() => {
  sent = [];
  listeners = [];
  now = { design: design(), session: NEW_SESSION, settled: true };
  const maker = new MakerClient(
    () => {
      port = new FakePort(sent);
      return port;
    },
    () => () => {},
  );
  workshop = new Workshop(designer(), maker);
});

test("a pot at rest is made once, and nothing else before it is looked at", async () => {
  change({});
  expect(asks()).toEqual(["solid"]);
  await answer("a solid");
  expect(workshop.solid).toMatchObject({ value: "a solid", of: now.design, problem: null });
  change({});
  expect(asks()).toEqual(["solid"]);
});

test("nothing is made while the shape changes, everything once it rests", async () => {
  await answer("a solid");
  change({ design: design({ ...WALLED, shape: { kind: "bloor-wilson" } as Part["shape"] }), settled: false });
  expect(asks()).toEqual(["solid"]);
  change({ settled: true });
  expect(asks()).toEqual(["solid", "solid"]);
});

test("a wall that changes is followed under the hand", async () => {
  await answer("a solid");
  change({ design: design({ ...WALLED, wall: { thickness: 2, base: 1 } }), settled: false });
  expect(asks()).toEqual(["solid", "solid"]);
});

test("a surface without a wall has no solid, and one that was there goes", async () => {
  await answer("a solid");
  change({ design: design(PART) });
  expect(workshop.solid.value).toBeNull();
  expect(asks()).toEqual(["solid"]);
});

test("the panel's measures and checks are asked for while it is open", async () => {
  await answer("a solid");
  change({ session: { ...NEW_SESSION, tab: "measures" } });
  await answer(MEASURES);
  await answer("a report");
  expect(asks()).toEqual(["solid", "measure", "check"]);
  expect(workshop.measures.value).toBe(MEASURES);
  expect(workshop.report.value).toBe("a report");
  expect(workshop.busy).toBe(false);
});

test("water waits for its range and then follows its level", async () => {
  await answer("a solid");
  change({ session: { ...NEW_SESSION, fill: 0.5 } });
  expect(asks()).toEqual(["solid", "measure"]);
  await answer(MEASURES);
  expect(last()).toMatchObject({ kind: "water", level: 3 });
  await answer({ volume: 7 });
  expect(workshop.water.value).toEqual({ volume: 7 });
  change({ session: { ...NEW_SESSION, fill: 1 } });
  expect(last()).toMatchObject({ kind: "water", level: 5 });
  change({ session: NEW_SESSION });
  expect(workshop.water.value).toBeNull();
});

test("a map is painted on the grid of the stage, and another one when it is chosen", async () => {
  await answer("a solid");
  change({ session: { ...NEW_SESSION, map: "overhang" } });
  expect(last()).toMatchObject({ kind: "paint", map: "overhang", rows: 3, columns: 4 });
  await answer("painted");
  change({ session: { ...NEW_SESSION, map: "mean-curvature" } });
  expect(last()).toMatchObject({ kind: "paint", map: "mean-curvature" });
  change({ session: NEW_SESSION });
  expect(workshop.painted.value).toBeNull();
});

test("why there is no pot is kept in words", async () => {
  const refusal = { code: "no-opening", path: "parts[0]", message: "There is no opening." };
  const id = sent.at(-1)?.id ?? 0;
  port.onmessage?.({ data: { id, ok: false, refusal, broken: false } } as MessageEvent<Reply>);
  await Promise.resolve();
  await Promise.resolve();
  expect(workshop.solid).toMatchObject({ value: null, problem: refusal });
});
