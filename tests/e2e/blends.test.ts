// A blend: its two sections in the panel.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { stay } from "../support/stay.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();

/** An oval foot and a round rim, eight wide and twelve high, without a wall. */
const OVAL = JSON.stringify({
  pasu: 1,
  parts: [
    {
      shape: {
        kind: "blend",
        start: { form: "disc", radius: [4, 3], z: 0, taper: 0.5, dz: 12 },
        end: { form: "disc", radius: [3, 3], z: 12, taper: 0, dz: 12 },
        weights: [1, 0.004, 1],
      },
    },
  ],
});

async function opened() {
  const pot = await here.enter();
  const first = await pot.fingerprint();
  await pot.dropFile("oval.json", OVAL);
  return { pot, plain: await pot.fingerprintOtherThan(first) };
}

test("each section is changed by its numbers, and undo takes a step back", async () => {
  const { pot, plain } = await opened();
  const lower = pot.page.locator("pasu-blend-cards li[data-end=start]");
  await lower.waitFor();
  await pot.type("Half width, Lower section", "6 cm");
  const wide = await pot.fingerprintOtherThan(plain);
  await pot.type("Turn, Lower section", "30");
  const turned = await pot.fingerprintOtherThan(wide);
  // What is turned is an outline now, and as wide as it was.
  expect(await lower.locator("select").inputValue()).toBe("outline");
  expect(await pot.page.getByRole("spinbutton", { name: "Half width, Lower section" }).inputValue()).toBe("6");
  await pot.type("How many, Lower section", "6");
  await pot.type("Petals, Lower section", "15");
  const petals = await pot.fingerprintOtherThan(turned);
  await pot.type("Corners, Lower section", "50");
  await pot.fingerprintOtherThan(petals);
  await pot.undo();
  await pot.shows(petals);
  await pot.undo();
  await pot.shows(turned);
  await pot.undo();
  await pot.shows(wide);
  await pot.undo();
  await pot.shows(plain);
  expect(await findings(pot)).toEqual([]);
});

test("a section takes another form, and the blend is solved another way", async () => {
  const { pot, plain } = await opened();
  const upper = pot.page.locator("pasu-blend-cards li[data-end=end]");
  await upper.locator("select").selectOption("rectangle");
  const box = await pot.fingerprintOtherThan(plain);
  await pot.button("Make it an outline").click();
  await pot.fingerprintOtherThan(box);
  expect(await upper.locator("select").inputValue()).toBe("outline");
  await pot.undo();
  await pot.shows(box);
  await pot.page.getByText("How it is solved").click();
  expect(await pot.page.getByRole("radio", { name: "Modal" }).isChecked()).toBe(true);
  // What sines add vanishes on the skin: the design is another one, and looks the same.
  const before = await pot.address();
  await pot.type("Terms, along u", "7");
  await expect.poll(() => pot.address()).not.toBe(before);
  const finer = await pot.address();
  await pot.type("round, b", "0.5");
  await expect.poll(() => pot.address()).not.toBe(finer);
  await pot.shows(box);
  await pot.page.getByRole("radio", { name: "Collocation" }).check();
  await pot.page.getByRole("spinbutton", { name: "Terms, along w" }).waitFor();
  expect(await findings(pot)).toEqual([]);
});

test("everything is from the catalogue", async () => {
  const pot = await here.enter({ link: PSEUDO });
  const first = await pot.fingerprint();
  await pot.dropFile("oval.json", OVAL);
  await pot.fingerprintOtherThan(first);
  await pot.page.locator("pasu-blend-cards li").first().waitFor();
  await pot.page.locator("pasu-blend-solving summary").click();
  expect(await unmarked(pot)).toEqual([]);
});

test("a new blend is two pictures of sections, and a pot of the gallery opens with its wall", async () => {
  const pot = await here.enter();
  const first = await pot.fingerprint();
  await pot.command("New");
  await pot.page.getByText("From one section into another").click();
  await pot.page.getByRole("group", { name: "At the foot" }).getByRole("radio", { name: "Star" }).check();
  await pot.page.getByRole("group", { name: "At the rim" }).getByRole("radio", { name: "Oval" }).check();
  expect(await findings(pot)).toEqual([]);
  await pot.button("Begin with Star to Oval").click();
  const begun = await pot.fingerprintOtherThan(first);
  await pot.page.locator("pasu-new").waitFor({ state: "detached" });
  const lower = pot.page.locator("pasu-blend-cards li[data-end=start]");
  await lower.waitFor();
  expect(await pot.page.getByRole("spinbutton", { name: "How many, Lower section" }).inputValue()).toBe("5");
  await pot.undo();
  await pot.shows(first);
  await pot.command("Gallery");
  await pot.page.locator('pasu-gallery button[data-exhibit="own-twisted-square"]').click();
  expect(await pot.fingerprintOtherThan(first)).not.toBe(begun);
  await expect.poll(() => pot.page.getByRole("spinbutton", { name: "Turn, Upper section" }).inputValue()).toBe("75");
});
