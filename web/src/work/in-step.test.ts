import { beforeEach, expect, test } from "vitest";
import type { Design, Part } from "../document/types";
import { MakerClient } from "../maker/client";
import type { Ask, MakerPort, Quick, Reply, Request } from "../maker/messages";
import type { Solved } from "../solver/messages";
import type { Outcome } from "../worker/port";
import type { Designer } from "./designer";
import { InStep } from "./in-step";
import type { Piece } from "./workshop";

const WALLED = { shape: { kind: "fourth-order" }, wall: { thickness: 1, base: 1 } } as unknown as Part;
const design = (title: string, part: Part = WALLED): Design => ({
  pasu: 1,
  title,
  parts: [{ ...part, shape: { ...part.shape } }],
});

/** What the solver answers, as far as this looks at it; the mesh is known by its name. */
const solved = (name: string): Outcome<Solved> =>
  ({ state: "done", value: { mesh: { name, bounds: null }, facts: null } }) as unknown as Outcome<Solved>;

const quick = (took = 10): Quick => {
  const positions = new Float32Array(3);
  const solid = { positions, normals: positions, wares: positions, indices: new Uint32Array(3), bounds: null };
  return { solid, water: null, took } as unknown as Quick;
};

let sent: Request[];
let answer: (value: Quick | null) => Promise<void>;
let clocks: (() => void)[];
let pieces: Piece<Quick>[];
let recycled: unknown[];
let now: { shown: Design; inGesture: boolean };
let inStep: InStep;

/** Lets promises settle. */
const settle = async () => {
  for (let i = 0; i < 20; i += 1) await Promise.resolve();
};

beforeEach(() => {
  sent = [];
  clocks = [];
  pieces = [];
  recycled = [];
  now = { shown: design("shown"), inGesture: true };
  const designer = {
    get shown() {
      return { design: now.shown, solved: { facts: { height: 150, width: 70, depth: 70 } } };
    },
    get store() {
      return { inGesture: now.inGesture };
    },
    state: { session: { fill: null } },
    solver: { recycle: (mesh: unknown) => recycled.push(mesh) },
  } as unknown as Designer;
  const maker = new MakerClient(
    () => {
      const port: MakerPort = {
        onmessage: null,
        onerror: null,
        postMessage: (message: Request) => void sent.push(message),
        terminate: () => {},
      };
      answer = async (value) => {
        const id = sent.at(-1)?.id ?? 0;
        const refusal = { code: "no-room", path: "parts[0].wall", message: "There is no room." };
        const reply: Reply = value ? { id, ok: true, answer: value } : { id, ok: false, refusal, broken: false };
        port.onmessage?.({ data: reply } as MessageEvent<Reply>);
        await settle();
      };
      return port;
    },
    () => () => {},
  );
  const later = (run: () => void) => {
    clocks.push(run);
    return () => {
      clocks = clocks.filter((each) => each !== run);
    };
  };
  inStep = new InStep(designer, maker, (piece) => pieces.push(piece), later);
});

type QuickAsk = Extract<Ask, { kind: "quick" }>;
const titles = () => sent.map(({ ask }) => (ask as QuickAsk).design.title);
const last = () => sent.at(-1)?.ask as QuickAsk;

test("a surface is shown with its wall, not before", async () => {
  let shown: Outcome<Solved> | null = null;
  void inStep.join(design("a"), Promise.resolve(solved("mesh")))?.then((outcome) => {
    shown = outcome;
  });
  await settle();
  expect(titles()).toEqual(["a"]);
  expect(shown).toBeNull();
  await answer(quick());
  expect(shown).toEqual(solved("mesh"));
  expect(pieces).toMatchObject([{ problem: null, key: "quick" }]);
});

test("one pair is under way at a time, and what waits is run after it", async () => {
  void inStep.join(design("a"), Promise.resolve(solved("mesh")));
  const runs: string[] = [];
  expect(inStep.waits(() => runs.push("older"))).toBe(true);
  expect(inStep.waits(() => runs.push("latest"))).toBe(true);
  await answer(quick());
  expect(runs).toEqual(["latest"]);
  expect(inStep.waits(() => runs.push("free"))).toBe(false);
});

test("surfaces without a wall, changes of the wall alone and changes without a hand are not held back", () => {
  const solving = Promise.resolve(solved("mesh"));
  const { wall: _, ...bare } = WALLED;
  expect(inStep.join(design("a", bare as Part), solving)).toBeNull();
  const rewalled = {
    ...now.shown,
    parts: now.shown.parts.map((part) => ({ ...part, wall: { thickness: 2, base: 1 } })),
  };
  expect(inStep.join(rewalled, solving)).toBeNull();
  now.inGesture = false;
  expect(inStep.join(design("b"), solving)).toBeNull();
  expect(sent).toEqual([]);
});

test("letting go settles with a wall, and what was under way is thrown away", async () => {
  const first = inStep.join(design("a"), Promise.resolve(solved("a")));
  now.inGesture = false;
  expect(inStep.waits(() => {})).toBe(false);
  const last = inStep.join(design("b"), Promise.resolve(solved("b")));
  expect(last).not.toBeNull();
  await answer(quick());
  expect(await first).toEqual({ state: "superseded" });
  expect(recycled).toMatchObject([{ name: "a" }]);
  expect(pieces).toEqual([]);
  await answer(quick());
  expect(await last).toEqual(solved("b"));
  expect(pieces).toHaveLength(1);
  // The next change without a hand is none of a drag.
  expect(inStep.join(design("c"), Promise.resolve(solved("c")))).toBeNull();
});

test("what cannot be a pot is shown bare, with the reason", async () => {
  const shown = inStep.join(design("a"), Promise.resolve(solved("mesh")));
  await answer(null);
  expect(await shown).toEqual(solved("mesh"));
  expect(pieces).toMatchObject([{ value: null, problem: { code: "no-room" } }]);
});

test("a surface does not wait for long, nor at all while the maker is busy with an older wall", async () => {
  const shown = inStep.join(design("a"), Promise.resolve(solved("mesh")));
  for (const run of [...clocks]) run();
  expect(await shown).toEqual(solved("mesh"));
  expect(pieces).toEqual([]);
  expect(inStep.join(design("b"), Promise.resolve(solved("mesh")))).toBeNull();
  await answer(quick(400));
  expect(inStep.join(design("c"), Promise.resolve(solved("mesh")))).not.toBeNull();
});

test("walls are made as coarsely as it takes, and left out for the rest of a drag when even that takes too long", async () => {
  const tolerances: number[] = [];
  for (let i = 0; i < 20; i += 1) {
    if (!inStep.join(design(`${i}`), Promise.resolve(solved("mesh")))) break;
    tolerances.push(last().tolerance);
    await answer(quick(130));
  }
  expect(Math.max(...tolerances)).toBe(0.5);
  expect(tolerances).toEqual([...tolerances].sort((a, b) => a - b));
  expect(tolerances.length).toBeLessThan(10);
  // The next drag tries again.
  now.inGesture = false;
  expect(inStep.join(design("let go"), Promise.resolve(solved("mesh")))).toBeNull();
  now.inGesture = true;
  expect(inStep.join(design("again"), Promise.resolve(solved("mesh")))).not.toBeNull();
});

test("arrays that are not shown any more go back to be written over", async () => {
  const { solid } = quick();
  inStep.recycle(solid);
  void inStep.join(design("a"), Promise.resolve(solved("mesh")));
  expect(last().spare?.positions).toBe(solid.positions);
});
