// A network of hundreds of patches under the hand.

import { expect, test } from "vitest";
import { countDrawn, drawn } from "../support/drawn.ts";
import { number } from "../support/network.ts";
import { sheet } from "../support/sheet.ts";
import { stay } from "../support/stay.ts";
import type { Visit } from "../support/visit.ts";

const here = stay();

/** A sheet of 500 patches with its points on the stage: its fingerprint, and where the middle of the stage is. */
async function sheetAtHand() {
  const pot = await here.enter({});
  const first = await pot.fingerprint();
  const large = sheet(20, 25);
  await pot.dropFile("sheet.json", JSON.stringify(large));
  const plain = await pot.fingerprintOtherThan(first);
  await pot.button("Points on the stage").click();
  await pot.page.locator("pasu-network-handles canvas").last().waitFor();
  const box = await pot.page.locator("pasu-network-handles").boundingBox();
  const middle: [number, number] = [(box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2];
  return { pot, plain, middle, large };
}

test("a large network that is dragged, undone and dragged again is drawn as one that is drawn anew", {
  timeout: 120_000,
}, async () => {
  const { pot, plain, middle } = await sheetAtHand();
  const [x, y] = middle;
  const pull = async (from: readonly [number, number], by: readonly [number, number]) => {
    const before = await pot.fingerprint();
    await pot.page.mouse.move(from[0], from[1]);
    await pot.page.mouse.down();
    await pot.page.mouse.move(from[0] + by[0], from[1] + by[1], { steps: 6 });
    await pot.page.mouse.up();
    return await pot.fingerprintOtherThan(before);
  };
  await pull([x, y + 80], [12, -60]);
  const pulled = await pull([x + 60, y + 90], [-10, -40]);
  await pot.undo();
  await pot.undo();
  await pot.shows(plain);
  await pot.redo();
  await pot.redo();
  await pot.shows(pulled);
  expect(await differsFromAnew(pot)).toBe(0);
  await overlay(pot);
  // The tool is put down and taken up: all is drawn anew.
  await pot.button("Points on the stage").click();
  await pot.page.locator("pasu-network-handles").waitFor({ state: "detached" });
  await pot.button("Points on the stage").click();
  await pot.page.locator("pasu-network-handles canvas").last().waitFor();
  // Some pixels at the rims of points may be blended in another order.
  await expect.poll(async () => await overlay(pot)).toBeLessThan(60);
  await pot.leave();
});

test("keys go on with the point of a large network that was clicked", async () => {
  const { pot, plain } = await sheetAtHand();
  interface Points {
    placed: { item: { kind: string }; seen: { x: number; y: number } }[];
  }
  const spots = pot.page.locator("pasu-network-handles");
  const seen = () =>
    spots.evaluate((element) => {
      const { left, top } = element.getBoundingClientRect();
      const found = (element as unknown as Points).placed.filter(({ item: { kind } }) => kind === "vertex");
      const { seen: spot } = found[Math.floor(found.length / 2)] ?? {};
      return spot ? { x: left + spot.x, y: top + spot.y } : null;
    });
  await expect.poll(seen).not.toBeNull();
  const { x = 0, y = 0 } = (await seen()) ?? {};
  await pot.page.mouse.click(x, y);
  await pot.page.getByText("1 point and 0 patches picked").waitFor();
  const held = pot.page.locator("pasu-network-handles button:focus");
  await expect.poll(() => held.count()).toBe(1);
  await pot.page.keyboard.press("ArrowUp");
  await pot.fingerprintOtherThan(plain);
});

test("a point meets the one that the hand is on, and not another beside it", async () => {
  const { pot, plain } = await sheetAtHand();
  await pot.page.getByLabel("To other points").check();
  interface Points {
    placed: { item: { kind: string; index: number }; at: number[]; seen: { x: number; y: number } }[];
  }
  const spots = pot.page.locator("pasu-network-handles");
  /** Where a point is, and where one far from it that has another beside it. */
  const found = () =>
    spots.evaluate((element) => {
      const { left, top } = element.getBoundingClientRect();
      const all = (element as unknown as Points).placed.filter(({ item: { kind } }) => kind === "vertex");
      const far = (one: (typeof all)[0], other: (typeof all)[0]) =>
        Math.hypot(one.seen.x - other.seen.x, one.seen.y - other.seen.y);
      const goal = all.find((each) => all.find((other) => far(each, other) < 10) !== each);
      const from =
        goal && all.find((each) => far(each, goal) > 100 && all.every((o) => o === each || far(each, o) > 3));
      return (
        from &&
        goal && {
          from: [left + from.seen.x, top + from.seen.y],
          to: [left + goal.seen.x, top + goal.seen.y],
          goal: goal.at,
        }
      );
    });
  await expect.poll(found).toBeTruthy();
  const { from = [], to = [], goal } = (await found()) ?? {};
  await pot.page.mouse.move(from[0] ?? 0, from[1] ?? 0);
  await pot.page.mouse.down();
  await pot.page.mouse.move(to[0] ?? 0, to[1] ?? 0, { steps: 5 });
  await pot.page.mouse.up();
  await pot.fingerprintOtherThan(plain);
  expect([await number(pot, "x"), await number(pot, "y"), await number(pot, "z")]).toEqual(
    goal?.map((each) => expect.closeTo(each, 5)),
  );
});

test("a hand on a large network has its points and their numbers drawn, and nothing else of the page", async () => {
  const { pot, plain, middle, large } = await sheetAtHand();
  await countDrawn(pot);
  const [x, y] = [middle[0], middle[1] + 80];
  await pot.page.mouse.move(x, y);
  await pot.page.mouse.down();
  // With the first movements the point is picked, and the bar says that there is something to undo.
  await pot.page.mouse.move(x, y - 12, { steps: 6 });
  await pot.page.locator("pasu-network-place pasu-number").first().waitFor();
  await drawn(pot);
  await pot.page.mouse.move(x, y - 40, { steps: 12 });
  const during = await drawn(pot);
  expect(during).toContain("pasu-network-handles");
  const ours = ["pasu-network-handles", "pasu-network-place", "pasu-number"];
  expect(during.filter((name) => !ours.includes(name))).toEqual([]);
  await pot.page.mouse.up();
  await pot.fingerprintOtherThan(plain);
  // The numbers say where what was moved came to rest: the mean of its points.
  const fields = pot.page.locator("pasu-network-place").getByRole("spinbutton");
  const told = await fields.evaluateAll((all) => all.map((each) => Number(each.ariaValueNow)));
  const were = (large as { parts: { shape: { vertices: number[][] } }[] }).parts[0]?.shape.vertices ?? [];
  const moved = (
    await pot.page.evaluate(() => {
      interface Page {
        designer: { store: { design: { parts: { shape: { vertices: number[][] } }[] } } };
      }
      const { designer } = document.querySelector("pasu-app") as unknown as Page;
      return designer.store.design.parts[0]?.shape.vertices ?? [];
    })
  ).filter((point, at) => point.some((each, axis) => Math.abs(each - (were[at]?.[axis] ?? 0)) > 1e-6));
  expect(moved.length).toBeGreaterThan(0);
  const mean = [0, 1, 2].map((axis) => moved.reduce((sum, point) => sum + (point[axis] ?? 0), 0) / moved.length);
  expect(told).toEqual(mean.map((each) => Number(each.toPrecision(6)) + 0));
  await pot.leave();
});

test("the first movement of a large network is written over in the mesh that stands at rest", async () => {
  const { pot, middle } = await sheetAtHand();
  const [x, y] = [middle[0], middle[1] + 80];
  await pot.page.mouse.move(x, y);
  await pot.page.mouse.down();
  expect(await meshAfter(pot, async () => await pot.page.mouse.move(x, y - 12))).toBe("the same arrays");
  await pot.page.mouse.up();
  await pot.leave();
});

/** Whether what is shown after something is done is in the arrays in which the mesh was before. */
async function meshAfter(pot: Visit, act: () => Promise<void>): Promise<"the same arrays" | "others"> {
  interface Page {
    designer: { surface: { shown: { change: number; solved: { parts: { mesh: { positions: Float32Array } }[] } } } };
  }
  const before = await pot.page.evaluateHandle(
    () => (document.querySelector("pasu-app") as unknown as Page).designer.surface.shown,
  );
  await act();
  const same = await pot.page.waitForFunction((was) => {
    const { shown } = (document.querySelector("pasu-app") as unknown as Page).designer.surface;
    if (shown.change === was.change) return null;
    const [now, then] = [shown, was].map(({ solved }) => solved.parts[0]?.mesh.positions);
    return now === then ? "the same arrays" : "others";
  }, before);
  return (await same.jsonValue()) ?? "others";
}

/** By how much the mesh on the stage is another than one that is sampled as a whole. */
async function differsFromAnew(pot: Visit): Promise<number> {
  return await pot.page.evaluate(async () => {
    interface Solver {
      mesh(
        lane: string,
        design: object,
        rows: number,
        columns: number,
      ): Promise<{ value: { parts: { mesh: Arrays }[] } }>;
    }
    interface Arrays {
      positions: Float32Array;
      normals: Float32Array;
    }
    interface Page {
      designer: {
        solver: Solver;
        store: { design: object };
        surface: {
          grid(design: object): { rows: number; columns: number };
          shown: { solved: { parts: { mesh: Arrays }[] } };
        };
      };
    }
    const { solver, store, surface } = (document.querySelector("pasu-app") as unknown as Page).designer;
    const { rows, columns } = surface.grid(store.design);
    const { value } = await solver.mesh("anew", store.design, rows, columns);
    const [now, anew] = [surface.shown.solved.parts[0]?.mesh, value.parts[0]?.mesh];
    if (!now || !anew || now.positions.length !== anew.positions.length) return Number.NaN;
    let most = 0;
    for (const name of ["positions", "normals"] as const)
      for (const [place, each] of now[name].entries()) most = Math.max(most, Math.abs(each - (anew[name][place] ?? 0)));
    return most;
  });
}

/** How many pixels of what lies over the stage, both canvases on each other, are quite others than when this was asked last. */
async function overlay(pot: Visit): Promise<number> {
  return await pot.page.evaluate(() => {
    const find = (root: Document | ShadowRoot): HTMLElement | null => {
      for (const element of root.querySelectorAll("*")) {
        if (element.localName === "pasu-network-handles") return element as HTMLElement;
        const found = element.shadowRoot && find(element.shadowRoot);
        if (found) return found;
      }
      return null;
    };
    const all = [...(find(document)?.shadowRoot?.querySelectorAll("canvas") ?? [])];
    const { width = 1, height = 1 } = all[0] ?? {};
    const context = new OffscreenCanvas(width, height).getContext("2d");
    for (const each of all) context?.drawImage(each, 0, 0);
    const now = context?.getImageData(0, 0, width, height).data ?? new Uint8ClampedArray();
    const kept = globalThis as unknown as { pasuOverlay?: Uint8ClampedArray };
    const before = kept.pasuOverlay;
    kept.pasuOverlay ??= now;
    let others = 0;
    for (let place = 3; before && place < now.length; place += 4)
      if (Math.abs((now[place] ?? 0) - (before[place] ?? 0)) > 64) others += 1;
    return before?.length === now.length ? others : Number.POSITIVE_INFINITY;
  });
}
