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
  const before = await pot.fingerprint();
  const from = await spotOf(ring(pot, 1));
  const passages: Passage[] = [];
  await mouse.move(from.x, from.y);
  await mouse.down();
  for (let i = 0; i < WARM + MOVES; i += 1) {
    const passage = pot.page.evaluate(() => (globalThis as unknown as Measuring).pasuPassage());
    await mouse.move(from.x + (i + 2) * STEP, from.y);
    passages.push(await passage);
  }
  await pot.page.keyboard.press("Escape");
  await mouse.up();
  await pot.shows(before);
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
        name: "hand-over",
        samples: samples(({ there, back }) => there + back),
        note: "Where software draws, the answer waits until the ring under the hand is drawn where it was.",
      },
      { name: "solve and sample", samples: samples(({ mesh }) => mesh) },
      { name: "glaze and bounds", samples: samples(({ coarse, glaze }) => coarse + glaze) },
      { name: "wait for the page's thread", samples: samples(({ busy }) => busy) },
      { name: "page and panels", samples: samples(({ page }) => page) },
      { name: "wait for a frame", samples: samples(({ frame }) => frame) },
      {
        name: "upload and draw",
        samples: samples(({ upload, draw }) => upload + draw),
        note: "By software, SwiftShader: what is drawn of the rings is uploaded among the pot, and waits for it.",
      },
      { name: "event to drawn", samples: samples(({ whole }) => whole) },
    ],
  });
}
