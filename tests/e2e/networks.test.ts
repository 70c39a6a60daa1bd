// A network of patches: its points on the stage, what is built with it, and what pushes it.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { stay } from "../support/stay.ts";
import type { Visit } from "../support/visit.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();

/** Eight points: a leaf of 12 by 12. */
const LEAF = JSON.stringify({
  pasu: 1,
  parts: [
    {
      shape: {
        kind: "vertex-frame",
        vertices: [
          [-6, -6, 0],
          [0, -7, 3],
          [6, -6, 0],
          [7, 0, -2],
          [6, 6, 0],
          [0, 7, 3],
          [-6, 6, 0],
          [-7, 0, -2],
        ],
        patches: [{ frame: [0, 1, 2, 3, 4, 5, 6, 7] }],
      },
    },
  ],
});

async function opened(options: Parameters<typeof here.enter>[0] = {}) {
  const pot = await here.enter(options);
  const first = await pot.fingerprint();
  await pot.dropFile("leaf.json", LEAF);
  const plain = await pot.fingerprintOtherThan(first);
  await pot.page.locator("pasu-network-panel").waitFor();
  return { pot, plain };
}

const item = (pot: Visit, name: string) => pot.page.locator(`pasu-network-handles [data-item="${name}"]`);

async function middle(pot: Visit, name: string): Promise<readonly [number, number]> {
  const box = await item(pot, name).boundingBox();
  return [(box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2];
}

async function drag(pot: Visit, name: string, dx: number, dy: number): Promise<void> {
  const [x, y] = await middle(pot, name);
  await pot.page.mouse.move(x, y);
  await pot.page.mouse.down();
  await pot.page.mouse.move(x + dx, y + dy, { steps: 4 });
  await pot.page.mouse.up();
}

async function points(pot: Visit): Promise<void> {
  await pot.button("Points on the stage").click();
  await item(pot, "vertex 0").waitFor();
}

const number = async (pot: Visit, name: string) =>
  Number((await pot.page.getByRole("spinbutton", { name, exact: true }).inputValue()).replace("\u2212", "-"));

test("points are dragged by the mouse, along axes too, and a drag is one step", async () => {
  const { pot, plain } = await opened();
  await points(pot);
  expect(await findings(pot)).toEqual([]);
  await drag(pot, "vertex 2", 30, -40);
  const dragged = await pot.fingerprintOtherThan(plain);
  expect(await item(pot, "vertex 2").getAttribute("aria-pressed")).toBe("true");
  await pot.undo();
  await pot.shows(plain);
  await pot.redo();
  await pot.shows(dragged);
  await pot.page.getByRole("radio", { name: "z", exact: true }).check();
  const [x, y] = [await number(pot, "x"), await number(pot, "y")];
  await drag(pot, "vertex 2", 0, -40);
  await pot.fingerprintOtherThan(dragged);
  expect([await number(pot, "x"), await number(pot, "y")]).toEqual([x, y]);
  // Typed to a place.
  await pot.type("z", "9");
  expect(await item(pot, "vertex 2").getAttribute("aria-label")).toMatch(/, 9 cm$/);
});

test("everything is from the catalogue", async () => {
  const pot = await here.enter({ link: PSEUDO });
  const first = await pot.fingerprint();
  await pot.dropFile("leaf.json", LEAF);
  await pot.fingerprintOtherThan(first);
  await pot.page.locator("pasu-network-panel [data-pick=all]").click();
  await pot.page.locator("pasu-network-patch .acts button").first().click();
  await pot.page.locator("pasu-network-patch .force").waitFor();
  expect(await unmarked(pot)).toEqual([]);
});
