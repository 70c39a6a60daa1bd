// What lies under a point of the stage, one behind the other: by the alt key, the second button, a finger that stays, and keys.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { takeParts } from "../support/placing.ts";
import { onStage, type Spot } from "../support/pulling.ts";
import { stay } from "../support/stay.ts";
import { PHONE, type Visit, type VisitOptions } from "../support/visit.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();

const block = (name: string, object: number, y: number) => ({
  name,
  object,
  shape: { kind: "octant", exponents: [20, 20, 20] },
  place: { scale: [2, 1, 2], shift: [-1, y, -1] },
});
/** Seen from the front one hides the next. */
const ROW = [block("Front", 0, -4), block("Middle", 1, -1), block("Back", 2, 2)];

async function row(options: VisitOptions = {}, parts: readonly object[] = ROW): Promise<Visit> {
  const pot = await here.enter(options);
  const first = await pot.fingerprint();
  await pot.dropFile("row.json", JSON.stringify({ pasu: 1, title: "Row", parts }));
  await pot.fingerprintOtherThan(first);
  await pot.page.locator("pasu-parts [role=option]").nth(2).waitFor();
  // From the front, at once.
  await pot.page.emulateMedia({ reducedMotion: "reduce" });
  await pot.page.locator("pasu-stage .host").focus();
  await pot.page.keyboard.press("2");
  return pot;
}

const list = (pot: Visit) => pot.page.locator("pasu-under [role=menu]");
const names = async (pot: Visit) => {
  await list(pot).waitFor();
  return await list(pot).locator("button > span").allInnerTexts();
};
const middle = (pot: Visit): Promise<Spot> => onStage(pot, 0.5, 0.5);
const selected = (pot: Visit) => pot.page.locator("pasu-parts [aria-selected=true] > span:first-child").allInnerTexts();
const focused = (pot: Visit) =>
  pot.page.locator("pasu-under").evaluate((element) => element.shadowRoot?.activeElement?.textContent?.trim() ?? "");

test("with the alt key and by the second button parts are listed from front to back, and one is chosen", async () => {
  const pot = await row();
  const { keyboard, mouse } = pot.page;
  const { x, y } = await middle(pot);
  await keyboard.down("Alt");
  await mouse.click(x, y);
  await keyboard.up("Alt");
  expect(await names(pot)).toEqual(["Front", "Middle", "Back"]);
  // The blocks stand three units from each other, seen along a line that leans a little.
  expect(await list(pot).locator("small").allInnerTexts()).toEqual([
    expect.stringMatching(/^3\scm behind$/),
    expect.stringMatching(/^6\scm behind$/),
  ]);
  expect(await findings(pot)).toEqual([]);
  await list(pot).getByText("Back").click();
  await list(pot).waitFor({ state: "detached" });
  expect(await selected(pot)).toEqual(["Back"]);
  await mouse.click(x, y, { button: "right" });
  expect(await names(pot)).toEqual(["Front", "Middle", "Back"]);
  await list(pot)
    .getByText("Middle")
    .click({ modifiers: ["Shift"] });
  await expect.poll(() => selected(pot)).toEqual(["Middle", "Back"]);
  // The second button still moves the view, and lists nothing by that.
  await mouse.move(x, y);
  await mouse.down({ button: "right" });
  await mouse.move(x + 40, y);
  await mouse.up({ button: "right" });
  expect(await list(pot).count()).toBe(0);
  expect(await selected(pot)).toEqual(["Middle", "Back"]);
});

test("keys list what lies in the middle, and the focus comes back", async () => {
  const pot = await row();
  const { keyboard } = pot.page;
  await keyboard.press("u");
  expect(await names(pot)).toEqual(["Front", "Middle", "Back"]);
  await expect.poll(() => focused(pot)).toBe("Front");
  await keyboard.press("ArrowDown");
  await keyboard.press("ArrowDown");
  await expect.poll(() => focused(pot)).toMatch(/^Back/);
  await keyboard.press("ArrowDown");
  await expect.poll(() => focused(pot)).toBe("Front");
  await keyboard.press("ArrowUp");
  await keyboard.press("Enter");
  await list(pot).waitFor({ state: "detached" });
  expect(await selected(pot)).toEqual(["Back"]);
  // The keys of the stage work at once.
  await keyboard.press("Shift+F10");
  await list(pot).waitFor();
  await keyboard.press("Escape");
  await list(pot).waitFor({ state: "detached" });
  expect(await selected(pot)).toEqual(["Back"]);
});

test("what is hidden is not listed, beside the parts nothing is, and a press elsewhere closes", async () => {
  const pot = await row();
  await pot.page.locator("pasu-parts [role=option]").filter({ hasText: "Middle" }).click();
  await pot.button("Hide").click();
  await pot.page.locator("pasu-stage .host").focus();
  await pot.page.keyboard.press("u");
  expect(await names(pot)).toEqual(["Front", "Back"]);
  const { x, y } = await onStage(pot, 0.04, 0.06);
  await pot.page.mouse.click(x, y, { button: "right" });
  await pot.page.locator("pasu-under").getByText("Nothing lies here.").waitFor();
  await pot.page.mouse.click(x, y + 60);
  await pot.page.locator("pasu-under").waitFor({ state: "detached" });
});

test("a finger that stays lists, one that moves turns, and while parts are moved the alt key lists", async () => {
  const pot = await row({ ...PHONE, colorScheme: "dark" });
  const { x, y } = await middle(pot);
  const session = await pot.context.newCDPSession(pot.page);
  await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y, id: 0 }] });
  expect(await names(pot)).toEqual(["Front", "Middle", "Back"]);
  await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  expect(await names(pot)).toEqual(["Front", "Middle", "Back"]);
  expect(await findings(pot)).toEqual([]);
  await list(pot).getByText("Middle").tap();
  expect(await selected(pot)).toEqual(["Middle"]);
  await takeParts(pot);
  await pot.page.keyboard.down("Alt");
  await pot.page.mouse.click(x, y + 24);
  await pot.page.keyboard.up("Alt");
  await list(pot).getByText("Front").click();
  await expect.poll(() => selected(pot)).toEqual(["Front"]);
});

test("thirty parts under one point are scrolled to by a finger and by keys, within the stage of a phone", async () => {
  const parts = Array.from({ length: 30 }, (_, at) => block(`Block ${at + 1}`, at, 3 * at - 45));
  const pot = await row({ ...PHONE, colorScheme: "dark" }, parts);
  pot.page.setDefaultTimeout(20_000);
  await pot.page.keyboard.press("u");
  expect(await names(pot)).toHaveLength(30);
  expect(await findings(pot)).toEqual([]);
  const sheet = pot.page.locator("pasu-under .list");
  const [box, stage] = [await sheet.boundingBox(), await pot.page.locator("pasu-under").boundingBox()];
  if (!box || !stage) throw new Error("nothing is listed");
  expect(box.x).toBeGreaterThanOrEqual(stage.x);
  expect(box.x + box.width).toBeLessThanOrEqual(stage.x + stage.width);
  expect(box.y).toBeGreaterThanOrEqual(stage.y);
  expect(box.y + box.height).toBeLessThanOrEqual(stage.y + stage.height);
  const scrolled = () => sheet.evaluate((element) => element.scrollTop);
  const session = await pot.context.newCDPSession(pot.page);
  const [x, y] = [box.x + box.width / 2, box.y + box.height - 30];
  await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y, id: 0 }] });
  for (let up = 20; up <= 200; up += 20)
    await session.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [{ x, y: y - up, id: 0 }] });
  await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await expect.poll(scrolled).toBeGreaterThan(100);
  await pot.page.keyboard.press("End");
  await expect.poll(() => focused(pot)).toMatch(/^Block 30/);
  const last = await list(pot).locator("button").last().boundingBox();
  expect((last?.y ?? 0) + (last?.height ?? 0)).toBeLessThanOrEqual(box.y + box.height);
  await list(pot).locator("button").last().tap();
  expect(await selected(pot)).toEqual(["Block 30"]);
});

test("a pot of one part has no list, and the words are those of the catalogue", async () => {
  const pot = await here.enter({ link: "#1/second-order" });
  await pot.fingerprint();
  await pot.page.locator("pasu-stage .host").focus();
  await pot.page.keyboard.press("u");
  expect(await pot.page.locator("pasu-under").count()).toBe(0);
  const named = ROW.map((part, at) => ({ ...part, name: String(at + 1) }));
  const other = await row({ link: PSEUDO }, named);
  await other.page.keyboard.press("u");
  expect(await names(other)).toEqual(["1", "2", "3"]);
  expect((await unmarked(other)).filter((text) => !text.includes("Row"))).toEqual([]);
});
