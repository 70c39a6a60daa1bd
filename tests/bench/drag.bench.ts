// The way of a change from the hand to the screen, in the built designer: where its milliseconds go, grid by grid, and how
// many frames the pot is behind the pointer on a slow machine.

import type { Browser } from "playwright-core";
import { test } from "vitest";
import { launch } from "../support/browser.ts";
import { movements, slowDown, watchDrags } from "../support/drag.ts";
import { ISOLATED, serve } from "../support/server.ts";
import { type Visit, type VisitOptions, visit } from "../support/visit.ts";
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

/** One change; times in milliseconds. */
interface Passage {
  /** From the event to the question put to the worker: controls, document. */
  readonly input: number;
  /** From the page to the worker. */
  readonly there: number;
  /** The mesh, in the worker: what it takes, and the same for the coarse mesh of the glaze. */
  readonly mesh: number;
  readonly coarse: number;
  readonly coarseVertices: number;
  /** What the picture needs besides: glaze, bounds, words. */
  readonly glaze: number;
  /** The page's thread is not done with the controls when the answer is. */
  readonly busy: number;
  /** From the worker to the page, or from when its thread is free. */
  readonly back: number;
  /** From the answer to the stage: page, panels. */
  readonly page: number;
  /** Until the browser began the frame. */
  readonly frame: number;
  /** Vertices and glaze into the buffers of the GPU, until they are there. */
  readonly upload: number;
  /** The rest of the frame, until the GPU has drawn it. */
  readonly draw: number;
  /** From the event until the GPU has drawn the frame. */
  readonly whole: number;
}

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

/** What is put into the page to measure there. */
interface Measuring {
  pasuTrace(
    moment: string,
    change: number,
    times?: { begun: number; meshed: number; glazed: number; done: number },
  ): void;
  /** The next change that is drawn. */
  pasuPassage(): Promise<Passage>;
}

/** Follows changes through the page; to be called before it opens. */
async function watchPassages(pot: Visit): Promise<void> {
  await pot.context.addInitScript(() => {
    const now = () => performance.timeOrigin + performance.now();
    const moments = new Map<string, number>();
    let times = { begun: 0, meshed: 0, glazed: 0, done: 0 };
    let changed = 0;
    let event = 0;
    let upload = 0;
    let uploading = false;
    const after = new MessageChannel();
    after.port2.onmessage = ({ data }) => {
      if (data === changed) moments.set("free", now());
    };
    let resolve: ((passage: Passage) => void) | null = null;
    addEventListener(
      "pointermove",
      ({ timeStamp }) => {
        event = performance.timeOrigin + timeStamp;
      },
      { capture: true },
    );
    // Reading back waits until everything asked before is done.
    const finish = (gl: WebGL2RenderingContext) => {
      const before = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING);
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      gl.bindFramebuffer(gl.READ_FRAMEBUFFER, before);
    };
    const methods = WebGL2RenderingContext.prototype as unknown as Record<
      string,
      (this: WebGL2RenderingContext, ...parameters: unknown[]) => unknown
    >;
    for (const name of ["bufferSubData", "texSubImage2D"]) {
      const real = methods[name];
      methods[name] = function (...given) {
        if (!uploading || !real) return real?.apply(this, given);
        finish(this);
        const idle = now();
        finish(this);
        const began = now();
        real.apply(this, given);
        finish(this);
        // The trip to the GPU's process and back is not part of it.
        upload += Math.max(0, now() - began - (began - idle));
        if (!moments.has("frame")) moments.set("frame", idle);
        return undefined;
      };
    }
    const measuring = globalThis as unknown as Measuring;
    measuring.pasuTrace = (moment, change, given) => {
      if (moment === "asked") {
        changed = change;
        moments.clear();
        upload = 0;
        // The browser lays out and paints the controls in the task that told of the event: this comes after it.
        after.port1.postMessage(change);
      }
      if (change !== changed || moments.has(moment)) return;
      moments.set(moment, now());
      if (given) times = given;
      if (moment === "shown") uploading = true;
      if (moment !== "drawn") return;
      uploading = false;
      const stage = document.querySelector("pasu-app")?.shadowRoot?.querySelector("pasu-stage");
      const gl = stage?.shadowRoot?.querySelector("canvas")?.getContext("webgl2");
      if (gl) finish(gl);
      const drawn = now();
      const { designer } = document.querySelector("pasu-app") as unknown as {
        designer: {
          surface: { shown: { solved: { parts: { mesh: { ware: { rows: number; columns: number } } }[] } } };
        };
      };
      const { rows, columns } = designer.surface.shown.solved.parts[0]?.mesh.ware ?? { rows: 0, columns: 0 };
      const at = (name: string) => moments.get(name) ?? Number.NaN;
      resolve?.({
        input: at("asked") - event,
        there: times.begun - at("asked"),
        mesh: times.meshed - times.begun,
        coarse: times.glazed - times.meshed,
        coarseVertices: rows * columns,
        glaze: times.done - times.glazed,
        busy: Math.max(0, (moments.get("free") ?? 0) - times.done),
        back: at("solved") - Math.max(times.done, moments.get("free") ?? 0),
        page: at("shown") - at("solved"),
        frame: at("frame") - at("shown"),
        upload,
        draw: drawn - at("frame") - upload,
        whole: drawn - event,
      });
      resolve = null;
    };
    measuring.pasuPassage = () =>
      new Promise((settle) => {
        resolve = settle;
      });
  });
}

/** Drags the slider with a grid of this many vertices either way. */
async function dragAt(pot: Visit, size: number): Promise<readonly Passage[]> {
  await pot.page.evaluate((side) => {
    const { designer } = document.querySelector("pasu-app") as unknown as {
      designer: { surface: { grid: () => object } };
    };
    designer.surface.grid = () => ({ rows: side, columns: side });
  }, size);
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
