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
let now: { design: Design; session: Session; settled: boolean; inGesture: boolean };

/** The designer as far as the workshop looks at it. */
function designer(): Designer {
  return {
    get state() {
      return { design: now.design, session: now.session };
    },
    get shown() {
      return { design: now.design, settled: now.settled, solved: { facts: { height: 150, width: 70, depth: 70 } } };
    },
    get store() {
      return { inGesture: now.inGesture };
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
/** Lets the pot be made, coarsely and finely. */
async function solid(): Promise<void> {
  await answer("coarse");
  await answer("a solid");
  sent.length = 0;
}

/** Answers what is under way; what it leads to happens before the next line. */
async function answer(value: unknown): Promise<void> {
  port.answer(value);
  await Promise.resolve();
  await Promise.resolve();
}

beforeEach(() => {
  sent = [];
  listeners = [];
  now = { design: design(), session: NEW_SESSION, settled: true, inGesture: false };
  const maker = new MakerClient(
    () => {
      port = new FakePort(sent);
      return port;
    },
    () => () => {},
  );
  workshop = new Workshop(designer(), maker);
});

test("a pot at rest is made coarsely, then finely, and nothing else before it is looked at", async () => {
  change({});
  expect(asks()).toEqual(["solid"]);
  expect(last()).toMatchObject({ tolerance: 1, fine: false });
  await answer("a solid");
  expect(workshop.solid).toMatchObject({ value: "a solid", of: now.design, problem: null });
  expect(asks()).toEqual(["solid", "solid"]);
  expect(last()).toMatchObject({ fine: true });
  await answer("a finer one");
  expect(workshop.solid.value).toBe("a finer one");
  change({});
  expect(asks()).toEqual(["solid", "solid"]);
});

test("nothing is made while the shape changes, everything once it rests", async () => {
  await solid();
  change({ design: design({ ...WALLED, shape: { kind: "bloor-wilson" } as Part["shape"] }), settled: false });
  expect(asks()).toEqual([]);
  change({ settled: true });
  expect(asks()).toEqual(["solid"]);
});

test("a drag has the machine for itself: what is under way is ended, and asked again at rest", async () => {
  expect(workshop.busy).toBe(true);
  const other = design({ ...WALLED, shape: { kind: "bloor-wilson" } as Part["shape"] });
  change({ design: other, settled: false, inGesture: true });
  expect(workshop.busy).toBe(false);
  change({ settled: true, inGesture: false });
  expect(last()).toMatchObject({ kind: "solid", design: other });
});

test("a wall that changes is followed under the hand", async () => {
  await solid();
  change({ design: design({ ...WALLED, wall: { thickness: 2, base: 1 } }), settled: false });
  expect(asks()).toEqual(["solid"]);
});

test("what is made of an earlier wall is shown until the latest is there", async () => {
  await solid();
  const thicker = (thickness: number) => design({ ...WALLED, wall: { thickness, base: 1 } });
  change({ design: thicker(2), settled: false });
  change({ design: thicker(3) });
  await answer("earlier");
  expect(workshop.solid.value).toBe("earlier");
  await answer("latest");
  expect(workshop.solid).toMatchObject({ value: "latest", of: now.design });
});

test("a surface without a wall has no solid, and one that was there goes", async () => {
  await solid();
  change({ design: design(PART) });
  expect(workshop.solid.value).toBeNull();
  expect(asks()).toEqual([]);
});

test("the panel's measures and checks are asked for while it is open", async () => {
  await solid();
  change({ session: { ...NEW_SESSION, tab: "measures" } });
  await answer(MEASURES);
  await answer("a report");
  expect(asks()).toEqual(["measure", "check"]);
  expect(workshop.measures.value).toBe(MEASURES);
  expect(workshop.report.value).toBe("a report");
  expect(workshop.busy).toBe(false);
});

test("what a surface would hold is not said of a pot whose wall is new", async () => {
  const WALL = { ...NEW_SESSION, tab: "wall" } as const;
  const holding = (value: number) => ({ capacity: { ...MEASURES.capacity, brim: { value, error: 0 } } });
  change({ design: design(PART), session: WALL });
  await answer(holding(829));
  expect(workshop.holds).toMatch(/^Holds 829.ml to/);
  change({ design: design() });
  expect(workshop.holds).toBeNull();
  await answer("coarse");
  await answer(holding(475));
  expect(workshop.holds).toMatch(/^Holds 475.ml to/);
  await answer("fine");
  // Nor what the wall before held.
  change({ design: design({ ...PART, wall: { thickness: 2, base: 1 } }) });
  expect(workshop.holds).toBeNull();
  expect(workshop.isOfNow(workshop.measures)).toBe(false);
  await answer("coarse");
  await answer(holding(420));
  expect(workshop.holds).toMatch(/^Holds 420.ml to/);
  expect(workshop.isOfNow(workshop.measures)).toBe(true);
});

test("beside the wall's numbers checks are asked for where a ring or a drain may have been fitted", async () => {
  const WALL = { ...NEW_SESSION, tab: "wall" } as const;
  await solid();
  change({ session: WALL });
  await answer(MEASURES);
  expect(asks()).toEqual(["measure"]);
  for (const wall of [
    { thickness: 1, base: 1, foot: [1, 1] as const },
    { thickness: 1, base: 1, drain: 1 },
  ]) {
    change({ design: design({ ...PART, wall }), session: NEW_SESSION });
    await solid();
    change({ session: WALL });
    await answer(MEASURES);
    await answer("a report");
    expect(asks()).toEqual(["measure", "check"]);
    expect(workshop.report.value).toBe("a report");
  }
});

test("water waits for its range and then follows its level", async () => {
  await solid();
  change({ session: { ...NEW_SESSION, fill: 0.5 } });
  expect(asks()).toEqual(["measure"]);
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
  await solid();
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
