// Ten thousand changes later the page holds what it held before.
//
// The longest of the browser tests: a leak of a few bytes a change, which is what one forgotten listener costs, shows above what engines keep for
// themselves only after that many.

import { expect, test } from "vitest";
import { type Holding, holding, watchMemory } from "../support/memory.ts";
import { stay } from "../support/stay.ts";
import type { Visit } from "../support/visit.ts";

const here = stay();
const CHANGES = 10_000;
/** Enough for everything to have been made that is made once, compiled code too. */
const FIRST = 1000;

/** What the test asks of the designer behind the page. */
interface Designer {
  readonly surface: { grid: () => { rows: number; columns: number } };
  readonly state: { readonly design: { readonly parts: readonly { readonly shape: object }[] } };
  readonly store: { endGesture(): void };
  apply(change: object): void;
}

/**
 * Changes one number so many times. One change is being solved and one waits for it, so that none is skipped and neither
 * thread rests. Says how many were solved.
 */
async function change(pot: Visit, times: number): Promise<number> {
  const solved = await pot.page.evaluate(async (count) => {
    const { designer } = document.querySelector("pasu-app") as unknown as { designer: Designer };
    // A small grid, because it is the number of changes that counts: a buffer that is left behind is seen at any size.
    designer.surface.grid = () => ({ rows: 13, columns: 25 });
    let asked = 0;
    const next = () => {
      asked += 1;
      const { design } = designer.state;
      const [part] = design.parts;
      const shape = { ...part?.shape, height: 3 + ((asked * 0.618) % 1) };
      designer.apply({ design: { ...design, parts: [{ ...part, shape }] }, undo: "merge", key: "height" });
    };
    let done = 0;
    await new Promise<void>((resolve) => {
      const hooked = globalThis as { pasuTrace?: (moment: string) => void };
      hooked.pasuTrace = (moment) => {
        if (moment !== "solved") return;
        done += 1;
        if (asked < count) next();
        else if (done === count) resolve();
      };
      next();
      next();
    });
    designer.store.endGesture();
    return done;
  }, times);
  await pot.fingerprint();
  return solved;
}

test("10,000 changes leave memory where it was", { timeout: 1_200_000 }, async ({ annotate }) => {
  // A small stage, because frames are drawn all the while.
  const pot = await here.enter({
    link: "#1/second-order",
    before: watchMemory,
    viewport: { width: 400, height: 300 },
  });
  await pot.fingerprint();
  await change(pot, FIRST);
  const before = await holding(pot);
  const began = performance.now();
  expect(await change(pot, CHANGES)).toBe(CHANGES);
  const seconds = (performance.now() - began) / 1000;
  const after = await holding(pot);
  const grown = Object.fromEntries(
    (Object.keys(before) as (keyof Holding)[]).map((key) => [key, after[key] - before[key]]),
  ) as unknown as Holding;
  await annotate(`${seconds.toFixed(1)} s; before ${JSON.stringify(before)}; grown by ${JSON.stringify(grown)}`);
  // To the byte where nothing but leaks can add anything; on heaps, where code is compiled meanwhile, to a
  // fraction of what one small object for each change would take.
  expect(grown.wasm).toBe(0);
  expect(grown.gpuBytes).toBe(0);
  expect(grown.gpuThings).toBe(0);
  expect(grown.arrays).toBeLessThan(10 * CHANGES);
  expect(grown.pageHeap).toBeLessThan(40 * CHANGES);
  expect(grown.workerHeap).toBeLessThan(20 * CHANGES);
});
