// Octants: begun from a picture, changed by their exponents, and placed by numbers, as every part among others is.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { stay } from "../support/stay.ts";
import { PHONE } from "../support/visit.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();

async function begun(id: string, options = {}) {
  const pot = await here.enter(options);
  const first = await pot.fingerprint();
  await pot.command("New");
  await pot.page.locator("pasu-new details.octants summary").click();
  const tile = pot.page.locator(`pasu-new button[data-exhibit="${id}"]`);
  await tile.scrollIntoViewIfNeeded();
  await expect.poll(() => tile.locator("canvas").getAttribute("data-drawn")).toBe("true");
  await tile.click();
  return { pot, shown: await pot.fingerprintOtherThan(first) };
}

test("an octant begins as a picture, and its exponents change it", async () => {
  const { pot, shown: ball } = await begun("own-octant-ball");
  const panel = pot.page.locator("pasu-octant");
  await panel.waitFor();
  const pressed = () => panel.locator("[aria-pressed=true]").allInnerTexts();
  expect(await pressed()).toEqual(["Round"]);
  await pot.button("Box").click();
  const box = await pot.fingerprintOtherThan(ball);
  expect(await pressed()).toEqual(["Box"]);
  await pot.type("Exponent of z", "1");
  const roof = await pot.fingerprintOtherThan(box);
  expect(await pressed()).toEqual([]);
  // What no octant has is said beside the number, and the solid stays.
  await pot.type("Exponent of z", "0.01");
  await panel.getByText("a number from 0.05 to 50").first().waitFor();
  await pot.undo();
  await pot.shows(roof);
  await pot.undo();
  await pot.shows(box);
  expect(await findings(pot)).toEqual([]);
});

test("an octant is as large as its placement, and is turned and moved by numbers", async () => {
  const { pot, shown: ball } = await begun("own-octant-ball");
  await pot.type("Width", "9");
  const wide = await pot.fingerprintOtherThan(ball);
  await pot.type("Turned", "90");
  await pot.type("Moved along z", "4");
  const moved = await pot.fingerprintOtherThan(wide);
  await pot.page.locator("pasu-place").getByRole("button", { name: "Put it back" }).click();
  await pot.fingerprintOtherThan(moved);
  expect(await pot.field("Width").inputValue()).toBe("9");
  expect(await pot.field("Moved along z").inputValue()).toBe("0");
});

test("a part among others is placed by numbers too", async () => {
  const { pot, shown: star } = await begun("own-octant-star");
  await expect.poll(() => pot.page.locator("pasu-parts [role=option]").count()).toBe(8);
  await pot.type("Moved along x", "5");
  const apart = await pot.fingerprintOtherThan(star);
  await pot.undo();
  await pot.shows(star);
  expect(apart).not.toBe(star);
});

test("what is chosen in New may join what stands there, to its right and on the same table", async () => {
  const pot = await here.enter();
  const first = await pot.fingerprint();
  await pot.command("New");
  await pot.page.locator('pasu-new button[data-exhibit="form-bowl"]').click();
  const jar = await pot.fingerprintOtherThan(first);
  await pot.command("New");
  await pot.page.getByLabel("Beside the present pot").check();
  expect(await findings(pot)).toEqual([]);
  await pot.page.locator('pasu-new button[data-exhibit="form-cup"]').click();
  await pot.page.locator("pasu-new").waitFor({ state: "detached" });
  const both = await pot.fingerprintOtherThan(jar);
  await expect.poll(() => pot.page.locator("pasu-parts [role=option]").count()).toBe(2);
  expect(await pot.page.locator("pasu-parts [aria-selected=true] > span:first-child").innerText()).toBe("Part 2");
  // Nothing of one is within the other, and nothing hangs in the air.
  await pot.tab("Measures");
  await pot.page.getByText("The mesh is closed, every edge is shared").waitFor();
  expect(await pot.page.locator("pasu-measures .sentences li.error").allInnerTexts()).toEqual([]);
  await pot.undo();
  await pot.shows(jar);
  expect(both).not.toBe(jar);
});

test("everything is from the catalogue", async () => {
  const pot = await here.enter({ link: PSEUDO });
  await pot.fingerprint();
  await pot.dropFile(
    "octant.json",
    JSON.stringify({ pasu: 1, parts: [{ shape: { kind: "octant", exponents: [2, 3, 4] } }] }),
  );
  await pot.page.locator("pasu-place").waitFor();
  await pot.page.locator("pasu-octant pasu-number").first().waitFor();
  expect(await unmarked(pot)).toEqual([]);
});

test("on a phone everything fits", async () => {
  const { pot } = await begun("own-octant-cushion", PHONE);
  await pot.page.locator("pasu-octant").waitFor({ state: "attached" });
  const over = await pot.page.evaluate(() => (document.scrollingElement?.scrollWidth ?? 0) - innerWidth);
  expect(over).toBeLessThanOrEqual(0);
});

test("what is no pot is described and measured on the stage, and its copy stands beside all of it", async () => {
  const pot = await here.enter();
  const first = await pot.fingerprint();
  const wide = { kind: "octant", exponents: [2, 2, 2] };
  const parts = [0, 6].map((x, object) => ({ object, shape: wide, place: { scale: [5, 4, 3], shift: [x, 0, 0] } }));
  await pot.dropFile("one.json", JSON.stringify({ pasu: 1, parts: parts.slice(0, 1) }));
  const one = await pot.fingerprintOtherThan(first);
  const caption = () => pot.page.locator("pasu-stage #description").innerText();
  await expect.poll(caption).toMatch(/^3\scm high and [\d.]+\scm wide\.$/);
  await pot.button("Overlays").click();
  await pot.page.getByRole("checkbox", { name: "Axes and dimensions" }).check();
  // Of what has no foot and no rim there are no lines from one to the other.
  for (const [name, none] of [
    ["Lines round the pot (u)", true],
    ["Rim, foot and tangents", true],
    ["Wireframe", false],
  ] as const)
    expect(await pot.page.getByRole("checkbox", { name }).isDisabled()).toBe(none);
  await pot.page.keyboard.press("Escape");
  await pot.page
    .locator("pasu-stage")
    .getByText(/^3\scm$/)
    .first()
    .waitFor();
  await pot.dropFile("two.json", JSON.stringify({ pasu: 1, parts }));
  const two = await pot.fingerprintOtherThan(one);
  await expect.poll(caption).toMatch(/^Two parts, 3\scm high and [\d.]+\scm wide together\.$/);
  await pot.page.getByRole("listbox", { name: "Parts" }).focus();
  await pot.page.keyboard.press("d");
  await pot.fingerprintOtherThan(two);
  // Eleven wide, and a tenth of that beside it.
  await pot.page.getByText("No two objects run into each other.").waitFor();
});
