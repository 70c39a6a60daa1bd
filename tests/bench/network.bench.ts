// How far a network of 2,000 patches is behind the pointer that drags one of its points, in the built designer on a slow machine, and what the page's thread does for one movement.

import type { Browser } from "playwright-core";
import { test } from "vitest";
import { launch } from "../support/browser.ts";
import { movements, slowDown, watchDrags } from "../support/drag.ts";
import { ISOLATED, serve } from "../support/server.ts";
import { sheet } from "../support/sheet.ts";
import { type Visit, visit } from "../support/visit.ts";
import { busyOfDrags } from "./busy.ts";
import { QUICK, record } from "./rows.ts";

/** Patches one way and the other: 2,000. */
const [ROWS, COLUMNS] = [40, 50];
const SLOWER = 6;
const DRAGS = QUICK ? 2 : 3;
const STEPS = QUICK ? 10 : 16;
const STEP = 1;

/** When each movement was told, when the frame with it was done, and what the worker took. */
interface Timed {
  pasuTimed: { readonly change: number; readonly event: number; drawn: number | null }[];
  pasuSolved: number[];
  pasuTrace(moment: string, change: number, times?: { begun: number; done: number }): void;
}

test("network", async () => {
  const site = await serve(undefined, 0, () => ISOLATED);
  const browser = await launch();
  try {
    const pot = await opened(browser, site.url, SLOWER, watchDrags, watchTimes);
    for (let turn = 0; turn < DRAGS; turn += 1) await dragged(pot);
    const behind = (await movements(pot)).map((each) => each.behind);
    const { late, solved } = await times(pot);
    await slowDown(pot, 1);
    await pot.leave();
    const uncounted = await opened(browser, site.url, 1);
    const busy = await busyOfDrags(browser, DRAGS, SLOWER, () => dragged(uncounted));
    await uncounted.leave();
    record({
      group: `behind the pointer, a point of ${ROWS * COLUMNS} patches`,
      unit: "frames",
      tail: true,
      rows: [{ name: `on a processor ${SLOWER} times slower`, samples: behind, median_at_most: 2 }],
    });
    record({
      group: `a point of ${ROWS * COLUMNS} patches under the hand, the page's thread ${SLOWER} times slower`,
      unit: "ms",
      tail: true,
      rows: [
        {
          name: "the page's thread, for one movement",
          samples: busy,
          note: "Its processor time until the next movement, six times, without what it waits for software to draw: without a GPU, Chromium's page waits until every frame is read back.",
        },
        { name: "the worker, for one change, not slowed down", samples: solved },
        { name: "event to drawn, by software", samples: late },
      ],
    });
  } finally {
    await browser.close();
    await site.close();
  }
});

/** The sheet on a page whose thread is slow, with its points over it. */
async function opened(
  browser: Browser,
  url: string,
  slower: number,
  ...watchers: readonly ((pot: Visit) => Promise<void>)[]
) {
  // What the software that stands in for a GPU draws is not the point here: a small stage.
  const pot = await visit(browser, url, {
    viewport: { width: 860, height: 480 },
    before: async (there) => {
      for (const watch of watchers) await watch(there);
    },
  });
  const first = await pot.fingerprint();
  await pot.dropFile("sheet.json", JSON.stringify(sheet(ROWS, COLUMNS)));
  await pot.fingerprintOtherThan(first);
  await pot.button("Points on the stage").click();
  await pot.page.locator("pasu-network-handles canvas").last().waitFor();
  if (slower > 1) await slowDown(pot, slower);
  return pot;
}

/** Drags the point in the middle out and takes it back. */
async function dragged(pot: Visit): Promise<void> {
  const { page } = pot;
  const before = await pot.fingerprint();
  const box = await page.locator("pasu-network-handles").boundingBox();
  if (!box) throw new Error("the network cannot be seen");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let step = 1; step <= STEPS; step += 1) await page.mouse.move(x, y - step * STEP);
  await page.mouse.up();
  await pot.fingerprintOtherThan(before);
  await pot.undo();
  await pot.shows(before);
}

async function watchTimes(pot: Visit): Promise<void> {
  await pot.context.addInitScript(() => {
    const watched = globalThis as unknown as Timed;
    watched.pasuTimed = [];
    watched.pasuSolved = [];
    let event: number | null = null;
    addEventListener(
      "pointermove",
      ({ timeStamp }) => {
        event = timeStamp;
      },
      { capture: true },
    );
    const before = watched.pasuTrace;
    watched.pasuTrace = (moment, change, times) => {
      before?.(moment, change);
      if (moment === "asked" && event !== null) {
        watched.pasuTimed.push({ change, event, drawn: null });
        event = null;
      }
      const ours = watched.pasuTimed.some((each) => each.change === change);
      if (moment === "solved" && times && ours) watched.pasuSolved.push(times.done - times.begun);
      if (moment !== "drawn") return;
      for (const each of watched.pasuTimed)
        if (each.drawn === null && each.change <= change) each.drawn = performance.now();
    };
  });
}

/** How long after its event each movement was drawn, and how long the worker took for each change, in milliseconds. */
async function times(pot: Visit): Promise<{ readonly late: readonly number[]; readonly solved: readonly number[] }> {
  return await pot.page.evaluate(() => {
    const { pasuTimed, pasuSolved } = globalThis as unknown as Timed;
    const late = pasuTimed.flatMap(({ event, drawn }) => (drawn === null ? [] : [drawn - event]));
    return { late, solved: pasuSolved };
  });
}
