// The way of a pull from the hand to the screen, in the built designer: on a ring of a pot of rings.

import { test } from "vitest";
import { launch } from "../support/browser.ts";
import { ring, spotOf, takeUp } from "../support/pulling.ts";
import { ISOLATED, serve } from "../support/server.ts";
import { type Visit, visit } from "../support/visit.ts";
import { gridOf, type Measuring, type Passage, watchPassages } from "./passages.ts";
import { QUICK, record } from "./rows.ts";

const SIZE = 256;
const TURNS = QUICK ? 2 : 6;
/** Movements of one pull; the first ones make what later ones find. */
const WARM = 3;
const MOVES = QUICK ? 4 : 10;
const STEP = 3;

test("pull", async () => {
  const site = await serve(undefined, 0, () => ISOLATED);
  const browser = await launch();
  try {
    // What the software that stands in for a GPU draws is not the point here: a small stage.
    const pot = await visit(browser, site.url, {
      link: "#1/rings",
      viewport: { width: 860, height: 480 },
      before: watchPassages,
    });
    await pot.fingerprint();
    await gridOf(pot, SIZE);
    await takeUp(pot);
    const passages: Passage[] = [];
    for (let turn = 0; turn < TURNS; turn += 1) passages.push(...(await pulled(pot)).slice(WARM));
    await pot.leave();
    tell(passages);
  } finally {
    await browser.close();
    await site.close();
  }
});

/** Pulls the belly outwards and takes it back. */
async function pulled(pot: Visit): Promise<readonly Passage[]> {
  const { mouse } = pot.page;
  const from = await spotOf(ring(pot, 1));
  const passages: Passage[] = [];
  await mouse.move(from.x, from.y);
  await mouse.down();
  // A hand that has just come down waits for a few pixels before it pulls.
  await mouse.move(from.x + 2 * STEP, from.y);
  for (let i = 0; i < WARM + MOVES; i += 1) {
    const passage = pot.page.evaluate(() => (globalThis as unknown as Measuring).pasuPassage());
    await mouse.move(from.x + (i + 3) * STEP, from.y);
    passages.push(await passage);
  }
  await pot.page.keyboard.press("Escape");
  await mouse.up();
  await pot.fingerprint();
  return passages;
}

function tell(passages: readonly Passage[]): void {
  const samples = (of: (passage: Passage) => number) => passages.map(of);
  record({
    group: `a pull from the hand to the screen, ${SIZE} x ${SIZE}`,
    unit: "ms",
    tail: true,
    rows: [
      {
        name: "event to question",
        samples: samples(({ input }) => input),
        note: "The pull itself among it, in a worker of its own.",
      },
      {
        name: "solve to upload",
        samples: samples(({ mesh, coarse, glaze, back, page, upload }) => mesh + coarse + glaze + back + page + upload),
      },
      { name: "wait for a frame", samples: samples(({ frame }) => frame) },
      { name: "draw", samples: samples(({ draw }) => draw), note: "By software: SwiftShader." },
      { name: "event to drawn", samples: samples(({ whole }) => whole) },
    ],
  });
}
