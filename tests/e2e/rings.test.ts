// A pot of rings in the panel: its cards, sliders for the whole pot, its numbers, and its rings on the profile.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { stay } from "../support/stay.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();
const BOTTLE = "#1/rings";

test("a ring is said in a potter's words, and added and taken away where nothing changes by it", async () => {
  const pot = await here.enter({ link: BOTTLE });
  const plain = await pot.fingerprint();
  const cards = pot.page.locator("pasu-ring-cards li");
  await cards.nth(3).waitFor();
  await pot.type("Radius, Ring 1", "7 cm");
  const wide = await pot.fingerprintOtherThan(plain);
  expect(await pot.address()).toContain("r=3,7,1.6,2.2&");
  await cards.nth(2).getByText("Oval, petals, tilt and waves").click();
  await pot.type("Number, Petals, Ring 1", "6");
  await pot.type("Depth, Petals, Ring 1", "0.5");
  const petals = await pot.fingerprintOtherThan(wide);
  expect(await pot.address()).toContain("r=3,7~6:.5,1.6,2.2&");
  await cards.nth(2).getByText("6 petals").waitFor();
  await cards.nth(2).getByRole("button", { name: "Change Ring 1" }).click();
  await pot.button("Make it round").click();
  await pot.shows(wide);
  await pot.undo();
  await pot.shows(petals);
  await pot.undo();
  // A ring more where the wall is.
  await cards.nth(2).getByRole("button", { name: "Change Ring 1" }).click();
  await pot.button("Add a ring above").click();
  await expect.poll(() => cards.count()).toBe(5);
  await expect.poll(() => pot.address()).toContain("u=.35,.525,.7");
  await cards.nth(2).getByRole("button", { name: "Change Ring 2" }).click();
  await pot.button("Delete").click();
  await pot.shows(wide);
  // Sharp, and back by its checkbox.
  await pot.page.getByRole("checkbox", { name: "Sharp" }).last().check();
  await pot.fingerprintOtherThan(wide);
  expect(await pot.address()).toContain("sharp=1");
  await pot.page.getByRole("checkbox", { name: "Sharp" }).last().uncheck();
  await pot.shows(wide);
  expect(await findings(pot)).toEqual([]);
});

test("sliders of the whole pot move every ring, there and back, each in one step", async () => {
  const pot = await here.enter({ link: "#1/rings?r=3,6~3:.4,1.6,2.2" });
  const before = await pot.fingerprint();
  await pot.page.locator("pasu-whole-pot summary").click();
  await pot.type("Height", "30");
  const tall = await pot.fingerprintOtherThan(before);
  expect(await pot.address()).toContain("z=0,9,22.5,30");
  await pot.drag("Twist", 0.7);
  const twisted = await pot.fingerprintOtherThan(tall);
  await pot.drag("Twist", 0.5);
  await pot.shows(tall);
  await pot.undo();
  await pot.shows(twisted);
  await pot.undo();
  await pot.shows(tall);
  await pot.type("Depth of the petals", "20");
  const petals = await pot.fingerprintOtherThan(tall);
  await pot.page.getByRole("radio", { name: "Rim" }).check();
  await pot.fingerprintOtherThan(petals);
  await pot.type("Depth of the petals", "0");
  await pot.shows(tall);
  await pot.type("Depth of the flutes", "8");
  const fluted = await pot.fingerprintOtherThan(tall);
  await pot.type("Flutes", "12");
  const dozen = await pot.fingerprintOtherThan(fluted);
  // What is counted is not rounded, and not made what is nearest.
  for (const wrong of ["12.5", "1000", "0"]) {
    await pot.type("Flutes", wrong);
    await pot.page.getByText(/Type a whole number from \d+ to \d+\./).waitFor();
  }
  await pot.shows(dozen);
  await pot.type("Depth of the flutes", "0");
  await pot.shows(tall);
  await pot.type("Height", "20");
  await pot.shows(before);
  expect(await findings(pot)).toEqual([]);
});

test("on the profile rings are dragged, put where the wall is clicked on twice, and moved by keys", async () => {
  const pot = await here.enter({ link: BOTTLE });
  const before = await pot.fingerprint();
  await pot.tab("Profile");
  const belly = pot.page.locator('pasu-profile [data-handle="ring-1"]');
  await belly.waitFor();
  const spot = async () => {
    const box = await belly.boundingBox();
    return { x: (box?.x ?? 0) + (box?.width ?? 0) / 2, y: (box?.y ?? 0) + (box?.height ?? 0) / 2 };
  };
  const { mouse, keyboard } = pot.page;
  const from = await spot();
  await mouse.move(from.x, from.y);
  await mouse.down();
  await mouse.move(from.x + 10, from.y - 8, { steps: 3 });
  await mouse.up();
  const dragged = await pot.fingerprintOtherThan(before);
  expect(await pot.address()).toMatch(/^#1\/rings\?r=3,6\.\d+,1\.6,2\.2&z=0,6\.\d+,15,20/);
  await pot.undo();
  await pot.shows(before);
  await pot.redo();
  await pot.shows(dragged);
  await belly.focus();
  await keyboard.press("ArrowLeft");
  const keyed = await pot.fingerprintOtherThan(dragged);
  await keyboard.press("+");
  await pot.page.locator('pasu-profile [data-handle="ring-3"]').waitFor();
  await pot.page.locator('pasu-profile [data-handle="ring-2"]').focus();
  await keyboard.press("Delete");
  await pot.page.locator('pasu-profile [data-handle="ring-3"]').waitFor({ state: "detached" });
  await pot.shows(keyed);
  // Half way between the foot and the belly.
  const [low, high] = [await pot.page.locator('pasu-profile [data-handle="foot"]').boundingBox(), await spot()];
  await mouse.dblclick(
    ((low?.x ?? 0) + (low?.width ?? 0) / 2 + high.x) / 2 + 6,
    ((low?.y ?? 0) + (low?.height ?? 0) / 2 + high.y) / 2,
  );
  await pot.page.locator('pasu-profile [data-handle="ring-3"]').waitFor();
  expect(await findings(pot)).toEqual([]);
});

test("in inches the numbers are those, and everything is from the catalogue", async () => {
  const pot = await here.enter({ link: `${PSEUDO}${BOTTLE}?unit=in` });
  await pot.fingerprint();
  await pot.page.locator("pasu-whole-pot summary").click();
  for (const each of await pot.page.locator("pasu-ring-cards summary").all()) {
    if ((await each.locator("xpath=..").getAttribute("open")) === null) await each.click();
  }
  await pot.page.locator("pasu-rings ol").waitFor();
  expect(await unmarked(pot)).toEqual([]);
  await pot.page.getByRole("tab").nth(1).click();
  await pot.page.locator('pasu-profile [data-handle="ring-1"]').waitFor();
  expect(await unmarked(pot)).toEqual([]);
});

/** A bottle as boundary data, with two rings between its edges. */
function written(): string {
  const equation = { order: 4, s: 1, t: 2, w: 1, free: "both" };
  const round = (name: "cos" | "sin") => ({
    ...equation,
    modes: [{ n: 1, [name]: { start: 3, end: 2.2, rings: [6, 1.6] } }],
  });
  const z = { ...equation, modes: [{ n: 0, cos: { start: 0, end: 20, rings: [6, 15] } }] };
  const shape = {
    kind: "boundary-value",
    span: "2pi",
    rings: [{ u: 0.35 }, { u: 0.7 }],
    x: round("cos"),
    y: round("sin"),
    z,
  };
  return JSON.stringify({ pasu: 1, parts: [{ shape }] });
}

test("rings of boundary data are cards too: wider, higher, elsewhere, sharp and gone, each in one step", async () => {
  const pot = await here.enter({ link: PSEUDO });
  const first = await pot.fingerprint();
  await pot.dropFile("bottle.json", written());
  const before = await pot.fingerprintOtherThan(first);
  const cards = pot.page.locator("pasu-written-rings li");
  await expect.poll(() => cards.count()).toBe(2);
  expect(await unmarked(pot)).toEqual([]);
  expect(await findings(pot)).toEqual([]);
  const fields = cards.first().getByRole("spinbutton");
  expect(await Promise.all([0, 1, 2].map((i) => fields.nth(i).inputValue()))).toEqual(["6", "6", "0.35"]);
  let last = before;
  for (const [index, text] of [
    [0, "7"],
    [1, "5.5"],
    [2, "0.4"],
  ] as const) {
    await fields.nth(index).fill(text);
    await fields.nth(index).press("Enter");
    const next = await pot.fingerprintOtherThan(last);
    await pot.page.locator("pasu-top-bar button").first().focus();
    await pot.page.keyboard.press("Control+z");
    await pot.shows(last);
    await pot.page.keyboard.press("Control+Shift+z");
    await pot.shows(next);
    expect(await fields.nth(index).inputValue()).toBe(text);
    last = next;
  }
  await cards.first().getByRole("checkbox").press("Space");
  const sharp = await pot.fingerprintOtherThan(last);
  await cards.first().getByRole("button").press("Enter");
  await pot.fingerprintOtherThan(sharp);
  expect(await cards.count()).toBe(1);
  expect(await fields.nth(0).inputValue()).toBe("1.6");
});
