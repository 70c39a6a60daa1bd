// A hand on whole parts: the tool that moves, turns and scales them, and what the document says of where they stand.

import type { Locator } from "playwright-core";
import { type StageBehind, stageOf } from "./on-stage.ts";
import type { Spot } from "./pulling.ts";
import type { Visit } from "./visit.ts";

/** Takes up the tool that moves parts, and waits until its handles are there. */
export async function takeParts(pot: Visit): Promise<void> {
  await pot.button("Move").click();
  await pot.page.locator("pasu-place-handles .handles button").first().waitFor();
  await pot.page.locator("pasu-place-bar .bar").waitFor();
}

/** Takes up another kind of handles: "Move", "Turn" or "Scale". */
export async function handling(pot: Visit, name: string): Promise<void> {
  await pot.page.locator("pasu-place-bar").getByRole("radio", { name, exact: true }).check({ force: true });
}

/** A handle by its name: "move-x", "turn-z", "scale-all", "free". */
export function grip(pot: Visit, name: string): Locator {
  return pot.page.locator(`pasu-place-handles [data-grip="${name}"]`);
}

export interface Standing {
  readonly scale: readonly number[];
  readonly axis: readonly number[];
  readonly angle: number;
  readonly shift: readonly number[];
}

/** Where the parts stand by the document. */
export async function standing(pot: Visit): Promise<readonly Standing[]> {
  return await pot.page.evaluate(() => {
    const { designer } = document.querySelector("pasu-app") as unknown as {
      designer: { store: { design: { parts: { place?: object }[] } } };
    };
    const unmoved = { scale: [1, 1, 1], axis: [0, 0, 1], angle: 0, shift: [0, 0, 0] };
    return designer.store.design.parts.map(({ place }) => ({ ...unmoved, ...place }));
  });
}

/** Where a part is seen on the page: the middle of what of it is seen on a grid of points. */
export async function seenPart(pot: Visit, place: number): Promise<Spot> {
  const stage = await stageOf(pot);
  return await stage.evaluate(async (it: StageBehind, wanted) => {
    await it.whenIdle();
    const { designer } = document.querySelector("pasu-app") as unknown as { designer: { store: { ids: number[] } } };
    const { left, top, width, height } = it.root.getBoundingClientRect();
    const found: { x: number; y: number }[] = [];
    for (let i = 0; i < 24; i += 1)
      for (let j = 0; j < 14; j += 1) {
        const spot = { x: ((i + 0.5) / 24) * width, y: ((j + 0.5) / 14) * height };
        if (it.pick(spot.x, spot.y) === designer.store.ids[wanted]) found.push(spot);
      }
    const { x, y } = found[found.length >> 1] ?? { x: Number.NaN, y: Number.NaN };
    return { x: left + x, y: top + y };
  }, place);
}

/** Counts what is asked of workers from now on, by the kind of the question; to be called before the page opens. */
export async function countQuestions(pot: Visit): Promise<void> {
  await pot.context.addInitScript(() => {
    const asked: Record<string, number> = {};
    Object.assign(globalThis, { pasuQuestions: asked });
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (this: Worker, message: unknown, ...more: unknown[]) {
      const kind = (message as { ask?: { kind?: string } })?.ask?.kind ?? "other";
      asked[kind] = (asked[kind] ?? 0) + 1;
      (postMessage as (...given: unknown[]) => void).call(this, message, ...more);
    } as typeof postMessage;
  });
}

/** What was asked since it was last asked for. */
export async function questions(pot: Visit): Promise<Readonly<Record<string, number>>> {
  return await pot.page.evaluate(() => {
    const { pasuQuestions } = globalThis as unknown as { pasuQuestions: Record<string, number> };
    const now = { ...pasuQuestions };
    for (const kind of Object.keys(pasuQuestions)) delete pasuQuestions[kind];
    return now;
  });
}
