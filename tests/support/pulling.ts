// A hand on the pot: the tool that pulls, the rings that stand over the stage, and fingers.

import type { Locator } from "playwright-core";
import type { Visit } from "./visit.ts";

export interface Spot {
  readonly x: number;
  readonly y: number;
}

/** Takes up the tool that pulls, and waits until it is there. */
export async function takeUp(pot: Visit): Promise<void> {
  await pot.button("Pull").click();
  await pot.page.locator("pasu-pull-bar .bar").waitFor();
}

/** The ring of a number from the first end on. */
export function ring(pot: Visit, index: number): Locator {
  return pot.page.locator(`pasu-pull [data-curve="${index}"]`);
}

/** Where a ring is seen at the right, in the window. */
export async function spotOf(handle: Locator): Promise<Spot> {
  await handle.waitFor();
  const box = await handle.boundingBox();
  if (!box) throw new Error("this ring cannot be seen");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** A point of the stage, as shares of it. */
export async function onStage(pot: Visit, x: number, y: number): Promise<Spot> {
  const box = await pot.page.locator("pasu-stage").boundingBox();
  if (!box) throw new Error("there is no stage");
  return { x: box.x + x * box.width, y: box.y + y * box.height };
}

/** Drags with the first button, or another; `held` runs before the release. */
export async function dragFrom(
  pot: Visit,
  from: Spot,
  by: Spot,
  { button = "left", held }: { readonly button?: "left" | "right"; readonly held?: () => Promise<void> } = {},
): Promise<void> {
  const { mouse } = pot.page;
  await mouse.move(from.x, from.y);
  await mouse.down({ button });
  for (const share of [0.25, 0.5, 0.75, 1]) await mouse.move(from.x + share * by.x, from.y + share * by.y);
  await held?.();
  await mouse.up({ button });
}

/** Fingers that come down together, move, and go: each from where to where. */
export async function fingers(pot: Visit, ways: readonly { readonly from: Spot; readonly to: Spot }[]): Promise<void> {
  const session = await pot.context.newCDPSession(pot.page);
  const at = (share: number) =>
    ways.map(({ from, to }, id) => ({
      x: from.x + share * (to.x - from.x),
      y: from.y + share * (to.y - from.y),
      id,
    }));
  await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: at(0) });
  for (const share of [0.25, 0.5, 0.75, 1])
    await session.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: at(share) });
  await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await session.detach();
}

/** How many rings and ends stand over the stage. */
export async function ringsOf(pot: Visit): Promise<number> {
  return await pot.page.locator("pasu-pull .ring").count();
}
