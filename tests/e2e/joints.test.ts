// Sliders of the scene: numbers of a placement by which parts are moved, within limits.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { standing } from "../support/placing.ts";
import { unreachable } from "../support/reach.ts";
import { stay } from "../support/stay.ts";
import { PHONE, type Visit, type VisitOptions } from "../support/visit.ts";

const here = stay();

const block = (name: string, object: number, shift: readonly number[], more: object = {}) => ({
  name,
  object,
  shape: { kind: "octant", exponents: [20, 20, 20] },
  place: { scale: [2, 2, 2], shift },
  ...more,
});
const CABINET = {
  pasu: 1,
  title: "Cabinet",
  parts: [
    block("Case", 0, [0, 0, 0]),
    block("Drawer", 1, [4, 0, 0], { joints: { x: { label: "Pull the drawer", limits: [4, 6], glued: true } } }),
    block("Knob", 1, [5.5, 0, 0.5]),
  ],
};

async function scene(
  design: { readonly parts: readonly object[]; readonly unit?: string },
  options: VisitOptions = {},
): Promise<Visit> {
  const pot = await here.enter(options);
  const first = await pot.fingerprint();
  await pot.dropFile("scene.json", JSON.stringify(design));
  await pot.fingerprintOtherThan(first);
  await pot.page.locator("pasu-joints [data-joint]").first().waitFor();
  return pot;
}

const slider = (pot: Visit, name: string) => pot.page.locator("pasu-joints").getByRole("slider", { name, exact: true });
const field = (pot: Visit, name: string) =>
  pot.page.locator("pasu-joints").getByRole("spinbutton", { name, exact: true });
const alongX = async (pot: Visit) => (await standing(pot)).map(({ shift }) => Math.round(1e3 * (shift[0] ?? 0)) / 1e3);
const settings = (pot: Visit, name: string) => pot.page.locator("pasu-joints summary").filter({ hasText: name });

test("a drag of a slider takes along what is glued, and is one step", async () => {
  const pot = await scene(CABINET);
  const before = await pot.fingerprint();
  const box = await slider(pot, "Pull the drawer").boundingBox();
  if (!box) throw new Error("the slider cannot be seen");
  const y = box.y + box.height / 2;
  const { mouse } = pot.page;
  await mouse.move(box.x + 9, y);
  await mouse.down();
  for (const share of [0.3, 0.5, 0.8, 1]) await mouse.move(box.x + 9 + share * (box.width - 12), y);
  // Under the hand already.
  await expect.poll(() => alongX(pot)).toEqual([0, 6, 7.5]);
  await mouse.up();
  await pot.fingerprintOtherThan(before);
  await pot.undo();
  await pot.shows(before);
  expect(await alongX(pot)).toEqual([0, 4, 5.5]);
});

test("keys move it, and it travels in the link", async () => {
  const pot = await scene(CABINET);
  await slider(pot, "Pull the drawer").focus();
  await pot.page.keyboard.press("ArrowRight");
  await pot.page.keyboard.press("PageUp");
  await expect.poll(() => alongX(pot)).toEqual([0, 4.11, 5.61]);
  const link = await pot.copyLink();
  const opened = await here.enter({ link: new URL(link).hash });
  await slider(opened, "Pull the drawer").waitFor();
  await expect.poll(() => field(opened, "Pull the drawer").inputValue()).toBe("4.11");
});

test("one part alone is moved by the sliders that it has, until the last is taken away", async () => {
  const joints = { z: { label: "Lift", limits: [0, 3] } };
  const vase = { name: "Vase", shape: { kind: "second-order", r: [1, 0, 0.6, 0.06], height: 2 }, joints };
  const pot = await scene({ ...CABINET, parts: [vase] });
  await slider(pot, "Lift").focus();
  await pot.page.keyboard.press("End");
  await expect.poll(async () => (await standing(pot))[0]?.shift[2]).toBe(3);
  expect(await findings(pot)).toEqual([]);
  await settings(pot, "Lift").click();
  await pot.page.getByRole("button", { name: "Take this slider away" }).focus();
  await pot.page.keyboard.press("Enter");
  await expect.poll(() => pot.page.locator("pasu-place").count()).toBe(0);
  expect(await pot.page.evaluate(() => document.activeElement?.localName)).not.toBe("body");
  await pot.undo();
  await slider(pot, "Lift").waitFor();
});

test("a number of the placement becomes a slider, with a label and limits of its own, and goes again", async () => {
  const pot = await scene(CABINET);
  await pot.page.locator("pasu-parts [role=option]").filter({ hasText: "Case" }).click();
  const place = pot.page.locator("pasu-place");
  const toggle = place.getByRole("button", { name: "Slider of the scene: Turned", exact: true });
  await toggle.click();
  expect(await toggle.getAttribute("aria-pressed")).toBe("true");
  await slider(pot, "Case turned").waitFor();
  await settings(pot, "Case turned").click();
  const card = pot.page.locator("pasu-joints [data-joint='0-turn']");
  await card.getByRole("textbox", { name: "Label" }).fill("Swing");
  await slider(pot, "Swing").waitFor();
  await card.getByRole("spinbutton", { name: "To" }).fill("45");
  await card.getByRole("spinbutton", { name: "To" }).press("Enter");
  // An octant whose edges are taken in another order is turned by a quarter more: within less than that there is one reading.
  await card.getByRole("spinbutton", { name: "From" }).fill("10");
  await card.getByRole("spinbutton", { name: "From" }).press("Enter");
  await card.getByRole("combobox", { name: "Turns about" }).selectOption({ label: "x" });
  await field(pot, "Swing").fill("30");
  await field(pot, "Swing").press("Enter");
  const [first] = await standing(pot);
  expect(first?.axis).toEqual([1, 0, 0]);
  expect(first?.angle).toBeCloseTo(Math.PI / 6, 10);
  // Beyond its limits it stays, and that is said.
  await field(pot, "Swing").fill("60");
  await field(pot, "Swing").press("Enter");
  await card.getByText("It is outside its limits").waitFor();
  // What is no range is refused where it was typed.
  await card.getByRole("spinbutton", { name: "To" }).fill("-120");
  await card.getByRole("spinbutton", { name: "To" }).press("Enter");
  await card.getByText("It has to be a number greater than 10, and is −120.").first().waitFor();
  await pot.undo();
  expect(await findings(pot)).toEqual([]);
  await card.getByRole("button", { name: "Take this slider away" }).click();
  await expect.poll(() => toggle.getAttribute("aria-pressed")).toBe("false");
  await pot.undo();
  await slider(pot, "Swing").waitFor();
});

test("where a slider is taken away the focus stays among the others, and then with the parts", async () => {
  const [drawer, ...others] = CABINET.parts.toReversed();
  const door = block("Door", 2, [0, 4, 0], { joints: { z: { limits: [0, 1] } } });
  const pot = await scene({ ...CABINET, parts: [...others, door, ...(drawer ? [drawer] : [])] });
  for (const [name, left] of [
    ["Door along z", "pasu-joints h3:focus"],
    ["Pull the drawer", "pasu-parts [role=listbox]:focus"],
  ] as const) {
    await settings(pot, name).click();
    await pot.page.locator("pasu-joints details[open] > button").focus();
    await pot.page.keyboard.press("Enter");
    await expect.poll(() => pot.page.locator(left).count()).toBe(1);
  }
});

/** In the link its edges are in another order, which turns it otherwise. */
test("a door of an octant is as far open in its link as it was", async () => {
  const limits = [0, Math.PI / 2];
  const door = block("Door", 1, [6, 0, 0], {
    place: { scale: [3, 0.4, 2], shift: [6, 0, 0] },
    joints: { turn: { label: "Open the door", limits } },
  });
  const pot = await scene({ ...CABINET, parts: [block("Case", 0, [0, 0, 0]), door] });
  await field(pot, "Open the door").fill("60");
  await field(pot, "Open the door").press("Enter");
  const link = await pot.copyLink();
  const opened = await here.enter({ link: new URL(link).hash });
  await slider(opened, "Open the door").waitFor();
  expect((await standing(opened))[0]?.angle).not.toBeCloseTo(Math.PI / 3, 3);
  await expect.poll(() => field(opened, "Open the door").inputValue()).toBe("60");
});

test("what is locked stays, and inches are inches", async () => {
  const pot = await scene({ ...CABINET, unit: "in" });
  await expect.poll(() => slider(pot, "Pull the drawer").getAttribute("aria-valuetext")).toContain("4");
  expect(await slider(pot, "Pull the drawer").getAttribute("aria-valuetext")).toContain("in");
  await pot.page.locator("pasu-parts [role=option]").filter({ hasText: "Knob" }).click();
  await pot.page.keyboard.press("l");
  await pot.page.getByText("It moves what is locked.").waitFor();
  expect(await pot.page.locator("pasu-joints [inert]").count()).toBe(1);
});

test("on a phone it is moved by a finger", async () => {
  const pot = await scene(CABINET, PHONE);
  const row = slider(pot, "Pull the drawer");
  await row.scrollIntoViewIfNeeded();
  const box = await row.boundingBox();
  if (!box) throw new Error("the slider cannot be seen");
  await pot.page.touchscreen.tap(box.x + 0.5 * box.width, box.y + box.height / 2);
  await expect.poll(async () => (await alongX(pot))[1]).toBeGreaterThan(4.5);
  expect(await findings(pot)).toEqual([]);
});

test("on a narrow phone the settings of a slider with a long label are no wider than the panel", async () => {
  const label = "Pull the drawer as far out as it goes without falling, twice";
  const [first, drawer, knob] = CABINET.parts;
  const parts = [first, { ...drawer, joints: { x: { label, limits: [4, 6], glued: true } } }, knob] as object[];
  const pot = await scene({ ...CABINET, parts }, { ...PHONE, viewport: { width: 320, height: 640 } });
  await settings(pot, label).click();
  await pot.button("Take this slider away").waitFor();
  expect(await unreachable(pot)).toEqual([]);
});

test("the slider of a copy, which has the same label, is told from the first by its part", async () => {
  const pot = await scene(CABINET);
  await pot.page.locator("pasu-parts [role=option]").filter({ hasText: "Drawer" }).click();
  await pot.button("Duplicate").click();
  await slider(pot, "Pull the drawer (Drawer along x)").waitFor();
  await slider(pot, "Pull the drawer (Drawer 2 along x)").waitFor();
  await pot.undo();
  await slider(pot, "Pull the drawer").waitFor();
});
