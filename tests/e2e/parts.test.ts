// A pot of several parts: which one is changed, what they are called, their order, copies, and away with one.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { stay } from "../support/stay.ts";
import type { Visit, VisitOptions } from "../support/visit.ts";

const here = stay();

const part = (radius: number, rest: object) => ({
  shape: { kind: "second-order", r: [radius, 0.1, 0.6, 0.06], height: 2 },
  ...rest,
});

const SCENE = {
  pasu: 1,
  title: "Three",
  parts: [
    part(1, { name: "Body" }),
    part(1.2, { name: "Lid", place: { shift: [3, 0, 0] } }),
    part(1.4, { place: { shift: [6, 0, 0] } }),
  ],
};

/** The designer with three pots, and the fingerprint of these. */
async function three(options: VisitOptions = {}): Promise<{ readonly pot: Visit; readonly scene: string }> {
  const pot = await here.enter(options);
  const first = await pot.fingerprint();
  await pot.dropFile("three.json", JSON.stringify(SCENE));
  const scene = await pot.fingerprintOtherThan(first);
  await list(pot).waitFor();
  return { pot, scene };
}

const list = (pot: Visit) => pot.page.getByRole("listbox", { name: "Parts" });
const options = (pot: Visit) => pot.page.getByRole("option");
const names = async (pot: Visit) => (await options(pot).allInnerTexts()).map((text) => text.trim());
const selected = (pot: Visit) => pot.page.locator("pasu-parts [aria-selected=true]").innerText();
const radius = (pot: Visit) => pot.field("Rim radius").inputValue();
const vertices = async (pot: Visit) => Number(await pot.app.getAttribute("data-vertices"));

test("a pot of one part has no list", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  await pot.fingerprint();
  await pot.field("Rim radius").waitFor();
  expect(await list(pot).count()).toBe(0);
});

test("parts are selected, ordered, copied and deleted by keys alone, and every step is taken back", async () => {
  const { pot, scene } = await three();
  const { keyboard } = pot.page;
  const one = (await vertices(pot)) / 3;
  expect(await names(pot)).toEqual(["Body", "Lid", "Part 3"]);
  await list(pot).focus();
  await keyboard.press("ArrowDown");
  expect(await selected(pot)).toBe("Lid");
  await expect.poll(() => radius(pot)).toBe("1.2");
  await keyboard.press("Alt+ArrowDown");
  await pot.fingerprintOtherThan(scene);
  expect(await names(pot)).toEqual(["Body", "Part 2", "Lid"]);
  expect(await selected(pot)).toBe("Lid");
  expect(await radius(pot)).toBe("1.2");
  await pot.undo();
  await pot.shows(scene);
  expect(await selected(pot)).toBe("Lid");
  await list(pot).focus();
  await keyboard.press("d");
  const four = await pot.fingerprintOtherThan(scene);
  expect(await names(pot)).toEqual(["Body", "Lid", "Lid 2", "Part 4"]);
  expect(await selected(pot)).toBe("Lid 2");
  expect(await vertices(pot)).toBe(4 * one);
  await keyboard.press("Delete");
  await pot.shows(scene);
  expect(await selected(pot)).toBe("Part 3");
  await pot.undo();
  await pot.shows(four);
  await list(pot).focus();
  for (const left of [3, 2]) {
    await keyboard.press("Delete");
    expect(await options(pot).count()).toBe(left);
  }
  // With the last but one the list goes, and the keys are where they were of use before.
  await keyboard.press("Delete");
  await list(pot).waitFor({ state: "detached" });
  expect(await pot.page.getByRole("tab", { name: "Shape" }).evaluate((tab) => tab.matches(":focus"))).toBe(true);
  for (let step = 0; step < 4; step += 1) await pot.undo();
  await pot.shows(scene);
});

test("a change is one of the selected part, wherever it stands by then", async () => {
  const { pot, scene } = await three();
  await options(pot).filter({ hasText: "Lid" }).click();
  await pot.type("Rim radius", "1.5");
  const wider = await pot.fingerprintOtherThan(scene);
  await pot.button("Move up").click();
  await pot.fingerprintOtherThan(wider);
  expect(await names(pot)).toEqual(["Lid", "Body", "Part 3"]);
  expect(await pot.button("Move up").isDisabled()).toBe(true);
  expect(await radius(pot)).toBe("1.5");
  await options(pot).filter({ hasText: "Body" }).click();
  await expect.poll(() => radius(pot)).toBe("1");
  await pot.undo();
  await pot.shows(wider);
  expect(await selected(pot)).toBe("Body");
});

test("a part is named, and never as another one", async () => {
  const { pot } = await three();
  const { keyboard } = pot.page;
  await options(pot).filter({ hasText: "Part 3" }).click();
  await list(pot).focus();
  await keyboard.press("F2");
  await keyboard.type("Lid");
  await pot.page.getByText("Another part has this name.").waitFor();
  await keyboard.type(" ring");
  expect(await pot.page.getByText("Another part has this name.").count()).toBe(0);
  await keyboard.press("Enter");
  expect(await names(pot)).toEqual(["Body", "Lid", "Lid ring"]);
  await keyboard.press("F2");
  await keyboard.type("Body");
  await keyboard.press("Enter");
  expect(await names(pot)).toEqual(["Body", "Lid", "Lid ring"]);
  expect(await pot.page.getByLabel("Name of the part").inputValue()).toBe("Lid ring");
  await pot.page.reload();
  await pot.fingerprint();
  await expect.poll(() => names(pot)).toEqual(["Body", "Lid", "Lid ring"]);
});

test("the list is there for everybody", async () => {
  for (const colorScheme of ["light", "dark"] as const) {
    const { pot } = await three({ colorScheme });
    expect(await findings(pot)).toEqual([]);
  }
});
