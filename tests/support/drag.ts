// A drag seen from inside the page: which frame showed which change, and how many frames passed since the hand moved.

import type { Visit } from "./visit.ts";

/** One movement of the pointer that changed the pot. */
export interface Movement {
  /** The number of the change. */
  readonly change: number;
  /** Frames that the page presented between the event and the frame with this change, or a later one. */
  readonly behind: number;
  /** Frames of the stage in between, which showed older changes. */
  readonly older: number;
  /** Milliseconds from the event to when that frame was drawn: while the page's thread is busy there are no frames to be counted. */
  readonly after: number;
}

interface Watched {
  pasuTrace(moment: string, change: number): void;
  /** The wall on the stage, frame by frame: how it was made, and nothing where there is none. */
  pasuWalls: string[];
  pasuMovements: {
    change: number;
    frame: number;
    drawn: number;
    at: number;
    behind: number | null;
    older: number;
    after: number;
  }[];
}

/** Counts frames from now on; to be called before the page opens. */
export async function watchDrags(pot: Visit): Promise<void> {
  await pot.context.addInitScript(() => {
    const watched = globalThis as unknown as Watched;
    watched.pasuMovements = [];
    watched.pasuWalls = [];
    const wall = () =>
      document.querySelector("pasu-app")?.shadowRoot?.querySelector<HTMLElement>("pasu-stage")?.dataset.wall ?? "";
    let frame = 0;
    let drawn = 0;
    const count = () => {
      frame += 1;
      requestAnimationFrame(count);
    };
    requestAnimationFrame(count);
    let moved: { readonly frame: number; readonly drawn: number; readonly at: number } | null = null;
    addEventListener(
      "pointermove",
      () => {
        moved = { frame, drawn, at: performance.now() };
      },
      { capture: true },
    );
    watched.pasuTrace = (moment, change) => {
      if (moment === "asked" && moved !== null) {
        watched.pasuMovements.push({ change, ...moved, behind: null, older: 0, after: 0 });
        moved = null;
      }
      if (moment !== "drawn") return;
      watched.pasuWalls.push(wall());
      for (const each of watched.pasuMovements) {
        if (each.behind !== null || each.change > change) continue;
        // The frame right after the event is the first that could show it: it is not between.
        each.behind = Math.max(0, frame - each.frame - 1);
        each.older = drawn - each.drawn;
        each.after = performance.now() - each.at;
      }
      drawn += 1;
    };
  });
}

/** The movements of all drags so far that were drawn, and forgets them. */
export async function movements(pot: Visit): Promise<readonly Movement[]> {
  return await pot.page.evaluate(() =>
    (globalThis as unknown as Watched).pasuMovements
      .splice(0)
      .flatMap(({ change, behind, older, after }) => (behind === null ? [] : [{ change, behind, older, after }])),
  );
}

/** The wall in every frame since it was last asked: "quick" under the hand, "coarse" and then "fine" at rest, nothing where there is none. */
export async function walls(pot: Visit): Promise<readonly string[]> {
  return await pot.page.evaluate(() => (globalThis as unknown as Watched).pasuWalls.splice(0));
}

/** Waits until the wall of a pot stands finished on the stage. */
export async function fineWall(pot: Visit): Promise<void> {
  await pot.page.locator('pasu-stage[data-wall="fine"]').waitFor({ state: "attached" });
}

/** Runs the page's thread so many times slower than it is. */
export async function slowDown(pot: Visit, rate: number): Promise<void> {
  const session = await pot.context.newCDPSession(pot.page);
  await session.send("Emulation.setCPUThrottlingRate", { rate });
}
