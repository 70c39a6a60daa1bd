// The way of a change from the hand to the screen, in the built designer: where its milliseconds go, grid by grid, and how
// many frames the pot is behind the pointer on a slow machine.

import type { Browser } from "playwright-core";
import { test } from "vitest";
import { launch } from "../support/browser.ts";
import { movements, slowDown, watchDrags } from "../support/drag.ts";
import { ISOLATED, serve } from "../support/server.ts";
import { type Visit, type VisitOptions, visit } from "../support/visit.ts";
import { gridOf, type Measuring, type Passage, watchPassages } from "./passages.ts";
import { QUICK, record } from "./rows.ts";

const SIZES = [64, 128, 256, 512];
const TURNS = QUICK ? 2 : 6;
/** Changes of one size in a turn; the first ones make what later ones find. */
const WARM = 3;
const CHANGES = QUICK ? 4 : 10;
const SLIDER = "Height";
const LINK = "#1/second-order";
/** What the software that stands in for a GPU draws is not the point here: a small stage. */
const SMALL: VisitOptions = { link: LINK, viewport: { width: 860, height: 480 } };

const SMALL_PARTS: VisitOptions = { ...SMALL, before: watchPassages };

test("drag", async () => {
  const site = await serve(undefined, 0, () => ISOLATED);
  const browser = await launch();
  try {
    const passages = await measured(browser, site.url);
    for (const size of SIZES) tell(size, passages);
    await among(browser, site.url);
    await frames(browser, site.url);
  } finally {
    await browser.close();
    await site.close();
  }
});

/** Changes of all sizes, in turns. */
async function measured(browser: Browser, url: string): Promise<ReadonlyMap<number, readonly Passage[]>> {
  const pot = await visit(browser, url, { ...SMALL, before: watchPassages });
  await pot.fingerprint();
  const passages = new Map<number, Passage[]>(SIZES.map((size) => [size, []]));
  for (let turn = 0; turn < TURNS; turn += 1) {
    for (const size of SIZES) {
      const some = await dragAt(pot, size);
      passages.get(size)?.push(...some.slice(WARM));
    }
  }
  await pot.leave();
  return passages;
}

/** So many pots stand beside the one that is dragged. */
const OTHERS = 19;
const AMONG = 128;

/** The way of a change of one part among many, beside that of the same part alone, in turns. */
async function among(browser: Browser, url: string): Promise<void> {
  const [alone, many] = [await visit(browser, url, SMALL_PARTS), await visit(browser, url, SMALL_PARTS)];
  for (const [pot, count] of [
    [alone, 1],
    [many, OTHERS + 1],
  ] as const) {
    const first = await pot.fingerprint();
    await pot.dropFile("row.json", JSON.stringify(rowOf(count)));
    await pot.fingerprintOtherThan(first);
  }
  const passages: [Passage[], Passage[]] = [[], []];
  for (let turn = 0; turn < TURNS; turn += 1) {
    passages[0].push(...(await dragAt(alone, AMONG)).slice(WARM));
    passages[1].push(...(await dragAt(many, AMONG)).slice(WARM));
  }
  await alone.leave();
  await many.leave();
  const way = ({ mesh, coarse, glaze, back, page, upload }: Passage) => mesh + coarse + glaze + back + page + upload;
  const row = (name: string, index: 0 | 1, of: (passage: Passage) => number) => ({
    name,
    samples: passages[index].map(of),
  });
  record({
    group: `one part from the hand to the screen, ${AMONG} x ${AMONG}`,
    unit: "ms",
    tail: true,
    rows: [
      row("alone, solve to upload", 0, way),
      {
        ...row("among twenty, solve to upload", 1, way),
        against: "alone, solve to upload",
        at_most: 2,
        note: "The others are neither solved nor sent nor uploaded.",
      },
      row("alone, event to drawn", 0, ({ whole }) => whole),
      { ...row("among twenty, event to drawn", 1, ({ whole }) => whole), against: "alone, event to drawn" },
    ],
  });
}

/** Pots in a row, each of another height. */
function rowOf(count: number): object {
  const parts = Array.from({ length: count }, (_, index) => ({
    shape: { kind: "second-order", r: [1, 0.1, 0.6, 0.06], height: 2 + index / 100 },
    place: { shift: [3 * index, 0, 0] },
  }));
  return { pasu: 1, parts };
}

/** Drags the slider with a grid of this many vertices either way. */
async function dragAt(pot: Visit, size: number): Promise<readonly Passage[]> {
  await gridOf(pot, size);
  await pot.slider(SLIDER).scrollIntoViewIfNeeded();
  const box = await pot.slider(SLIDER).boundingBox();
  if (!box) throw new Error("the slider cannot be seen");
  const { mouse } = pot.page;
  const y = box.y + box.height / 2;
  const passages: Passage[] = [];
  await mouse.move(box.x + 0.3 * box.width, y);
  await mouse.down();
  for (let i = 1; i <= WARM + CHANGES; i += 1) {
    const passage = pot.page.evaluate(() => (globalThis as unknown as Measuring).pasuPassage());
    await mouse.move(box.x + (0.3 + (0.5 * i) / (WARM + CHANGES)) * box.width, y);
    passages.push(await passage);
  }
  await mouse.up();
  await pot.fingerprint();
  return passages;
}

/** Hands over the parts of the way of one size. */
function tell(size: number, all: ReadonlyMap<number, readonly Passage[]>): void {
  const passages = all.get(size) ?? [];
  const solve = solving(all.get(Math.max(...SIZES)) ?? []);
  const samples = (of: (passage: Passage) => number) => passages.map(of);
  record({
    group: `from the hand to the screen, ${size} x ${size}`,
    unit: "ms",
    tail: true,
    rows: [
      { name: "event to question", samples: samples(({ input }) => input) },
      { name: "hand-over", samples: samples(({ there, back }) => there + back) },
      {
        name: "solve",
        samples: samples(() => solve),
        note: "Solving and sampling are told apart by two meshes of the same design, of which the finer is 512 x 512: sampling takes as long as there are vertices, solving the same for both.",
      },
      { name: "sample", samples: samples(({ mesh }) => Math.max(0, mesh - solve)) },
      { name: "glaze and bounds", samples: samples(({ coarse, glaze }) => coarse + glaze) },
      { name: "wait for the page's thread", samples: samples(({ busy }) => busy) },
      { name: "page and panels", samples: samples(({ page }) => page) },
      { name: "wait for a frame", samples: samples(({ frame }) => frame) },
      { name: "upload", samples: samples(({ upload }) => upload) },
      { name: "draw", samples: samples(({ draw }) => draw), note: "By software: SwiftShader." },
      { name: "event to drawn", samples: samples(({ whole }) => whole) },
      {
        name: "solve to upload",
        samples: samples(({ mesh, coarse, glaze, back, page, upload }) => mesh + coarse + glaze + back + page + upload),
        ...(size === 256 ? { median_at_most: 2 } : {}),
      },
    ],
  });
}

/** What solving takes, from the times of two meshes of different sizes, in the median. */
function solving(passages: readonly Passage[]): number {
  const fine = Math.max(...SIZES) ** 2;
  const each = passages.map(({ mesh, coarse, coarseVertices }) => {
    const perVertex = (mesh - coarse) / (fine - coarseVertices);
    return Math.max(0, coarse - perVertex * coarseVertices);
  });
  return each.sort((a, b) => a - b)[each.length >> 1] ?? Number.NaN;
}

/** How far behind the pointer the pot is on a machine six times slower, on the grid that it chooses. */
async function frames(browser: Browser, url: string): Promise<void> {
  const pot = await visit(browser, url, { ...SMALL, before: watchDrags });
  await pot.fingerprint();
  await slowDown(pot, 6);
  const steps = QUICK ? 20 : 60;
  for (const share of [0.9, 0.2, 0.8]) {
    await movements(pot);
    await pot.drag(SLIDER, share, { steps });
  }
  const samples = (await movements(pot)).map(({ behind }) => behind);
  await slowDown(pot, 1);
  await pot.leave();
  record({
    group: "behind the pointer",
    unit: "frames",
    tail: true,
    rows: [{ name: "on a processor 6 times slower", samples, median_at_most: 2 }],
  });
}
