// Whether the parts of a scene fit together: what is wrong is said in words, shown on the stage, and mended by a press.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { standing } from "../support/placing.ts";
import { stay } from "../support/stay.ts";
import { PHONE, type Visit, type VisitOptions } from "../support/visit.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();

const block = (name: string, object: number, scale: readonly number[], shift: readonly number[]) => ({
  name,
  object,
  shape: { kind: "octant", exponents: [20, 20, 20] },
  place: { scale, shift },
});
const JAR = block("Jar", 0, [4, 4, 3], [0, 0, 0]);
const LID = block("Lid", 1, [3, 3, 1], [0.5, 0.5, 2.7]);
const HANDLE = block("Handle", 0, [1, 1, 1], [6, 1, 1]);
const PEBBLE = block("Pebble", 2, [1, 1, 1], [1, 1, 1]);
const scene = (...parts: readonly object[]) => JSON.stringify({ pasu: 1, title: "Fit", parts });

async function entered(text: string, options: VisitOptions = {}): Promise<Visit> {
  const pot = await here.enter(options);
  const first = await pot.fingerprint();
  await pot.dropFile("fit.json", text);
  await pot.fingerprintOtherThan(first);
  return pot;
}

const card = (pot: Visit) => pot.page.locator("pasu-constraints");
/** What is said of the scene on the screen, once it is of that. */
async function told(pot: Visit): Promise<readonly string[]> {
  await card(pot).locator("section[aria-busy=false]").waitFor();
  return (await card(pot).locator("li").allInnerTexts()).map((text) => text.replace(/\s+/g, " ").trim());
}
const report = (pot: Visit, code: string) => card(pot).locator(`li[data-code=${code}]`);
const mend = (pot: Visit, code: string, name: string) => report(pot, code).locator(`[data-mend=${name}]`);
const mark = (pot: Visit) => pot.page.locator("pasu-witness .mark");
const selected = async (pot: Visit) =>
  (await pot.page.locator("pasu-parts [aria-selected=true] > span:first-child").allInnerTexts()).map((text) =>
    text.trim(),
  );

test("what is wrong is said with names, its place is marked on the stage, and goes with the design", async () => {
  const pot = await entered(scene(JAR, LID, HANDLE));
  await expect.poll(() => told(pot)).toHaveLength(2);
  expect((await told(pot)).join(" ")).toMatch(
    /Lid runs into Jar\. .*Handle is glued to Jar, but is 2.cm away from it at least\./,
  );
  await report(pot, "not-connected").locator(".told").click();
  await mark(pot).waitFor();
  expect(await mark(pot).innerText()).toMatch(/^2\scm$/);
  expect(await selected(pot)).toEqual(["Jar", "Handle"]);
  const stage = await pot.page.locator("pasu-stage").boundingBox();
  const at = await mark(pot).boundingBox();
  if (!stage || !at) throw new Error("the mark cannot be seen");
  expect(at.x).toBeGreaterThan(stage.x);
  expect(at.x).toBeLessThan(stage.x + stage.width);
  expect(at.y).toBeGreaterThan(stage.y);
  expect(at.y).toBeLessThan(stage.y + stage.height);
  expect(await findings(pot)).toEqual([]);
  // By keys: another one takes its place, and pressed again it goes.
  const other = report(pot, "interference").locator(".told");
  await other.focus();
  await pot.page.keyboard.press("Enter");
  await expect.poll(() => selected(pot)).toEqual(["Jar", "Lid"]);
  await expect.poll(() => mark(pot).boundingBox()).not.toEqual(at);
  await pot.page.keyboard.press("Enter");
  await mark(pot).waitFor({ state: "detached" });
  await pot.page.keyboard.press("Enter");
  await mark(pot).waitFor();
  await mend(pot, "interference", "glue").click();
  await mark(pot).waitFor({ state: "detached" });
  await expect.poll(async () => (await told(pot)).join(" ")).not.toContain("runs into");
});

test("the focus stays in the card when what was pressed has mended something", async () => {
  const pot = await entered(scene(JAR, LID, HANDLE));
  const heading = pot.page.locator("pasu-constraints h4:focus");
  for (const [code, name] of [
    ["interference", "apart"],
    ["not-connected", "together"],
    ["not-connected", "separate"],
    ["interference", "glue"],
  ] as const) {
    await mend(pot, code, name).focus();
    await pot.page.keyboard.press("Enter");
    await report(pot, code).waitFor({ state: "detached" });
    await told(pot);
    await expect.poll(() => heading.count()).toBe(1);
    await pot.undo();
    await report(pot, code).waitFor();
  }
});

test("where all reports are asked for, the first that was not listed has the focus", async () => {
  const loose = Array.from({ length: 7 }, (_, i) => block(`Crumb ${i}`, 0, [1, 1, 1], [10 + 5 * i, 0, 0]));
  const pot = await entered(scene(JAR, ...loose));
  await told(pot);
  await card(pot).getByRole("button", { name: "Show all 7" }).focus();
  await pot.page.keyboard.press("Enter");
  await expect.poll(() => card(pot).locator("li").count()).toBe(7);
  await expect.poll(() => card(pot).locator("li:nth-child(6) .told:focus").count()).toBe(1);
});

test("two objects are moved apart and what is loose is brought, each by one step", async () => {
  const pot = await entered(scene(JAR, LID, HANDLE));
  const before = await standing(pot);
  await mend(pot, "interference", "apart").click();
  await pot.page.getByText(/^Lid was moved by/).waitFor();
  await expect.poll(async () => (await told(pot)).join(" ")).not.toContain("runs into");
  const [jar, lid] = await standing(pot);
  expect(jar).toEqual(before[0]);
  expect(lid?.shift.slice(0, 2)).toEqual([0.5, 0.5]);
  expect(lid?.shift[2]).toBeGreaterThan(3);
  expect(lid?.shift[2]).toBeLessThan(3.01);
  await mend(pot, "not-connected", "together").click();
  await expect
    .poll(() => told(pot))
    .toEqual(["No two objects run into each other, and what is glued together touches."]);
  expect((await standing(pot))[2]?.shift[0]).toBeLessThan(4.01);
  expect(await findings(pot)).toEqual([]);
  await pot.undo();
  await pot.undo();
  await expect.poll(() => standing(pot)).toEqual(before);
});

test("a part that nobody sees is taken away, and one that is loose becomes an object of its own", async () => {
  const pot = await entered(scene(JAR, PEBBLE, HANDLE));
  await expect.poll(async () => (await told(pot)).join(" ")).toContain("All of Pebble lies inside Jar");
  expect((await told(pot)).join(" ")).not.toContain("runs into");
  await mend(pot, "within", "remove").click();
  await expect.poll(() => pot.page.locator("pasu-parts [role=option]").count()).toBe(2);
  await mend(pot, "not-connected", "separate").click();
  await expect.poll(() => told(pot)).toEqual(["No two objects run into each other."]);
});

test("what hangs together is named, selected, brought and set free together", async () => {
  const knob = block("Knob", 0, [1, 1, 1], [6.9, 1.2, 1.2]);
  const stand = block("Stand", 0, [3, 3, 1], [0.5, 0.5, -0.9]);
  const pot = await entered(scene(JAR, stand, HANDLE, knob));
  await expect
    .poll(async () => (await told(pot)).join(" "))
    .toMatch(/Handle and Knob hang together and are glued to Jar, but Handle is 2.cm away from it at least\./);
  await report(pot, "not-connected").locator(".told").click();
  expect(await selected(pot)).toEqual(["Jar", "Handle", "Knob"]);
  await mark(pot).waitFor();
  const before = await standing(pot);
  await mend(pot, "not-connected", "together").click();
  await pot.page.getByText(/^2 parts were moved by/).waitFor();
  await expect.poll(() => told(pot)).toEqual(["What is glued together touches."]);
  const after = await standing(pot);
  expect((after[3]?.shift[0] ?? 0) - (after[2]?.shift[0] ?? 0)).toBeCloseTo(0.9, 6);
  await pot.undo();
  await expect.poll(() => standing(pot)).toEqual(before);
  await mend(pot, "not-connected", "separate").click();
  await expect
    .poll(() => told(pot))
    .toEqual(["No two objects run into each other, and what is glued together touches."]);
});

test("nothing of an earlier scene is said while a hand moves a part", async () => {
  const pot = await entered(scene(JAR, LID));
  await expect.poll(async () => (await told(pot)).join(" ")).toContain("runs into");
  await pot.page.locator("pasu-parts [role=option]").filter({ hasText: "Lid" }).click();
  const slider = pot.page.locator("pasu-place input[type=range]").last();
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox();
  if (!box) throw new Error("there is no slider");
  const { mouse } = pot.page;
  await mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await mouse.down();
  await mouse.move(box.x + box.width * 0.6, box.y + box.height / 2);
  await card(pot).locator("section[aria-busy=true]").waitFor();
  expect(await card(pot).locator("li").count()).toBe(0);
  await mouse.up();
  expect((await told(pot)).length).toBeGreaterThan(0);
});

test("a file of a scene that does not fit is not called good", async () => {
  const pot = await entered(scene(JAR, LID));
  await told(pot);
  const said = pot.page.locator("pasu-export .outcome .sentences");
  await pot.command("Export");
  await said.locator("li").first().waitFor();
  expect(await said.innerText()).toContain("Lid runs into Jar");
  expect(await said.locator(".good").count()).toBe(0);
  // It can be saved all the same: a slicer may know better.
  await expect.poll(() => pot.button(/^Save/).last().isEnabled()).toBe(true);
  await pot.page.keyboard.press("Escape");
  await mend(pot, "interference", "apart").click();
  await expect.poll(() => told(pot)).toEqual(["No two objects run into each other."]);
  await pot.command("Export");
  await said.locator(".good").waitFor();
});

test("on a phone, in the dark, in every language", async () => {
  const pot = await entered(
    scene(JAR, LID, HANDLE)
      .replace(/"(Fit|Jar|Lid|Handle)"/g, '"1"')
      .replace('"name":"1"', '"name":"2"')
      .replace('"name":"1"', '"name":"3"'),
    {
      ...PHONE,
      colorScheme: "dark",
      link: PSEUDO,
    },
  );
  await told(pot);
  expect(await unmarked(pot)).toEqual([]);
  const first = report(pot, "not-connected").locator(".told");
  await first.scrollIntoViewIfNeeded();
  await first.tap();
  await mark(pot).waitFor();
  expect(await unmarked(pot)).toEqual([]);
  expect(await findings(pot)).toEqual([]);
  const over = await pot.page.evaluate(() => (document.scrollingElement?.scrollWidth ?? 0) - innerWidth);
  expect(over).toBeLessThanOrEqual(0);
});
