// How far a scene of 200 parts is behind the pointer that moves, tilts or scales one of them, in the built designer on a slow machine, and what the page's thread does for one movement.

import type { Browser } from "playwright-core";
import { test } from "vitest";
import { launch } from "../support/browser.ts";
import { movements, slowDown, watchDrags } from "../support/drag.ts";
import { grip, handling, takeParts } from "../support/placing.ts";
import { ISOLATED, serve } from "../support/server.ts";
import { type Visit, visit } from "../support/visit.ts";
import { busyOfDrags } from "./busy.ts";
import { QUICK, record } from "./rows.ts";

/** Pots one way and the other: 200. */
const [ROWS, COLUMNS] = [10, 20];
const SLOWER = 6;
const DRAGS = 2;
const STEPS = QUICK ? 10 : 12;
const STEP = 1;

/** Its wall goes along with a part that is moved; that of one that is tilted or scaled is made anew. */
const HANDLES = [
  ["moved", "Move", "free"],
  ["tilted", "Turn", "turn-x"],
  ["scaled", "Scale", "scale-all"],
] as const;

/** Pots on a table, every other one with a wall. */
function table() {
  const wall = { thickness: 0.4, base: 0.5 };
  const parts = Array.from({ length: ROWS * COLUMNS }, (_, at) => ({
    shape: { kind: "second-order", r: [8, 0, 5, 0], height: 14 + (at % 7) },
    ...(at % 2 === 0 && { wall }),
    object: at,
    place: { shift: [24 * (at % COLUMNS), 24 * Math.floor(at / COLUMNS), 0] },
  }));
  return { pasu: 1, title: "Table", parts };
}

test("scene", async () => {
  const site = await serve(undefined, 0, () => ISOLATED);
  const browser = await launch();
  try {
    const rows = [];
    for (const [name, kind, handle] of HANDLES) {
      const pot = await opened(browser, site.url, SLOWER, watchDrags);
      await handling(pot, kind);
      for (let turn = 0; turn < DRAGS; turn += 1) await dragged(pot, handle);
      rows.push({ name, moved: await movements(pot) });
      await slowDown(pot, 1);
      await pot.leave();
    }
    const uncounted = await opened(browser, site.url, 1);
    const busy = await busyOfDrags(browser, DRAGS, SLOWER, () => dragged(uncounted, "free"));
    await uncounted.leave();
    record({
      group: `behind the pointer, one of ${ROWS * COLUMNS} parts on a processor ${SLOWER} times slower`,
      unit: "frames",
      tail: true,
      rows: rows.map(({ name, moved }) => ({ name, samples: moved.map(({ behind }) => behind), median_at_most: 2 })),
    });
    record({
      group: `from the pointer to the picture, one of ${ROWS * COLUMNS} parts on a processor ${SLOWER} times slower`,
      unit: "ms",
      tail: true,
      rows: rows.map(({ name, moved }) => ({ name, samples: moved.map(({ after }) => after) })),
    });
    record({
      group: `one of ${ROWS * COLUMNS} parts under the hand, the page's thread ${SLOWER} times slower`,
      unit: "ms",
      tail: true,
      rows: [{ name: "the page's thread, for one movement", samples: busy }],
    });
  } finally {
    await browser.close();
    await site.close();
  }
});

/** The table on a page whose thread is slow, with the handles of its first part. */
async function opened(browser: Browser, url: string, slower: number, watch?: (pot: Visit) => Promise<void>) {
  // What the software that stands in for a GPU draws is not the point here: a small stage.
  const pot = await visit(browser, url, {
    viewport: { width: 860, height: 480 },
    before: async (there) => watch?.(there),
  });
  const first = await pot.fingerprint();
  await pot.dropFile("table.json", JSON.stringify(table()));
  await pot.fingerprintOtherThan(first);
  await takeParts(pot);
  if (slower > 1) await slowDown(pot, slower);
  return pot;
}

/** Takes the selected part by a handle and takes that back. */
async function dragged(pot: Visit, handle: string): Promise<void> {
  const { page } = pot;
  const before = await pot.fingerprint();
  const box = await grip(pot, handle).boundingBox();
  if (!box) throw new Error("the handle cannot be seen");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let step = 1; step <= STEPS; step += 1) await page.mouse.move(x + step * STEP, y);
  await page.mouse.up();
  await pot.fingerprintOtherThan(before);
  await pot.undo();
  await pot.shows(before);
}
