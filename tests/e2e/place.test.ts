// Whole parts under a hand: moved, turned and scaled on the stage by mouse, finger and keys.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { fineWall, walls, watchDrags } from "../support/drag.ts";
import { countDrawn, drawn } from "../support/drawn.ts";
import { countQuestions, grip, handling, questions, seenPart, standing, takeParts } from "../support/placing.ts";
import { dragFrom, fingers, spotOf } from "../support/pulling.ts";
import { unreachable } from "../support/reach.ts";
import { atRest } from "../support/sight.ts";
import { stay } from "../support/stay.ts";
import { PHONE, QUICK, type Visit, type VisitOptions } from "../support/visit.ts";

const here = stay();

const part = (name: string, shift: readonly number[]) => ({
  name,
  shape: { kind: "second-order", r: [1, 0.1, 0.6, 0.06], height: 2 },
  place: { shift },
});
const SCENE = {
  pasu: 1,
  title: "Three",
  parts: [part("Body", [0, 0, 0]), part("Lid", [3, 0, 0]), part("Foot", [6, 0, 0])],
};

async function three(options: VisitOptions = {}): Promise<Visit> {
  const pot = await here.enter(options);
  const first = await pot.fingerprint();
  await pot.dropFile("three.json", JSON.stringify(SCENE));
  await pot.fingerprintOtherThan(first);
  await pot.page.locator("pasu-parts [role=option]").nth(2).waitFor();
  return pot;
}

const shifts = async (pot: Visit) => (await standing(pot)).map(({ shift }) => [...shift]);
const undone = async (pot: Visit) =>
  expect.poll(() => shifts(pot)).toEqual(SCENE.parts.map(({ place }) => [...place.shift]));
const choose = (pot: Visit, name: string) =>
  pot.page.locator("pasu-parts [role=option]").filter({ hasText: name }).click();

/** Whether its parts fit together has been found out: nothing is asked any more unless somebody does something. */
const judged = (pot: Visit) => pot.page.locator("pasu-constraints .reports").waitFor({ state: "attached" });

/** Opens the three with walls, which are finished, and takes hold of the lid. */
async function openWalled(pot: Visit): Promise<void> {
  const first = await pot.fingerprint();
  const parts = SCENE.parts.map((each) => ({ ...each, wall: { thickness: 0.08, base: 0.1 } }));
  await pot.dropFile("walled.json", JSON.stringify({ ...SCENE, parts }));
  await pot.fingerprintOtherThan(first);
  await choose(pot, "Lid");
  await takeParts(pot);
  await fineWall(pot);
  await judged(pot);
}

test("a handle moves the part along its axis, one drag is one step, and costs no solving", async () => {
  const pot = await three({ before: countQuestions });
  await choose(pot, "Lid");
  await takeParts(pot);
  const handle = grip(pot, "move-x");
  const from = await spotOf(handle);
  await judged(pot);
  await questions(pot);
  let during: Readonly<Record<string, number>> = {};
  const scene = await pot.fingerprint();
  await dragFrom(
    pot,
    from,
    { x: 50, y: 0 },
    {
      held: async () => {
        during = await questions(pot);
        expect(await pot.page.locator("pasu-place-handles output").innerText()).toMatch(/^x −?[\d.]+\scm$/);
      },
    },
  );
  expect(during).toEqual({});
  const moved = await pot.fingerprintOtherThan(scene);
  const [body, lid, foot] = await shifts(pot);
  expect([body, foot]).toEqual([
    [0, 0, 0],
    [6, 0, 0],
  ]);
  expect(lid?.[0]).toBeGreaterThan(3);
  expect(lid?.slice(1)).toEqual([0, 0]);
  // The handle went with the part, under the hand.
  const to = await spotOf(handle);
  expect(Math.hypot(to.x - from.x - 50, to.y - from.y)).toBeLessThan(25);
  await pot.undo();
  await undone(pot);
  await pot.history("Redo").click();
  await pot.shows(moved);
});

test("walls go along with parts that are moved: none is made under the hand, and all stay on the stage", async () => {
  const pot = await here.enter({
    before: async (there) => {
      await countQuestions(there);
      await watchDrags(there);
    },
  });
  await openWalled(pot);
  for (const name of ["move-x", "free"]) {
    const from = await spotOf(grip(pot, name));
    await walls(pot);
    await questions(pot);
    let during: Readonly<Record<string, number>> = {};
    const scene = await pot.fingerprint();
    const held = async () => {
      during = await questions(pot);
      await pot.page.locator("pasu-place-handles output:not([hidden])").waitFor();
    };
    await dragFrom(pot, from, { x: 40, y: 0 }, { held });
    expect(during).toEqual({});
    await pot.fingerprintOtherThan(scene);
    const seen = await walls(pot);
    expect(seen.length).toBeGreaterThan(0);
    expect([...new Set(seen)]).toEqual(["fine"]);
    // At rest it is made as it is there, and once.
    await judged(pot);
    await expect.poll(async () => (await questions(pot)).solid ?? 0).toBe(1);
    await fineWall(pot);
  }
  await pot.leave();
});

/** Of which parts walls were made since those of the others, and whether they are there. */
const madeAnew = (pot: Visit) =>
  pot.page.evaluate(() => {
    const { made } = (
      document.querySelector("pasu-app") as unknown as {
        designer: { made: { changed: { parts: readonly number[]; value: { groups: Uint32Array } | null } } };
      }
    ).designer;
    const { parts, value } = made.changed;
    return [[...parts], value && [...new Set([...value.groups].filter((_, i) => i % 3 === 2))]];
  });

test("the wall of a part that is tilted or scaled is made anew under the hand, and those of the others stay", async () => {
  const pot = await here.enter({ before: watchDrags });
  await openWalled(pot);
  for (const [kind, name] of [
    ["Turn", "turn-x"],
    ["Scale", "scale-all"],
  ] as const) {
    await handling(pot, kind);
    // The view may still glide to where all of it fits.
    await atRest(pot);
    const from = await spotOf(grip(pot, name));
    await walls(pot);
    const scene = await pot.fingerprint();
    await dragFrom(pot, from, { x: 30, y: -20 }, { held: () => expect.poll(() => madeAnew(pot)).toEqual([[1], [1]]) });
    await pot.fingerprintOtherThan(scene);
    expect((await walls(pot)).filter((wall) => wall === "")).toEqual([]);
    // At rest all are made as they stand there; what was taken back has the wall that it had.
    await judged(pot);
    await fineWall(pot);
    await expect.poll(() => madeAnew(pot)).toEqual([[], null]);
    await pot.undo();
    await pot.shows(scene);
    await fineWall(pot);
  }
  await pot.leave();
});

test("a hand on a part draws neither the stage nor the bar over it, nor the numbers of its shape", async () => {
  const pot = await three();
  await choose(pot, "Lid");
  await takeParts(pot);
  await judged(pot);
  // That it is found out again whether parts fit together moves nothing of the panel.
  const below = async () => (await pot.page.locator("pasu-arrange").boundingBox())?.y;
  const panel = await below();
  await countDrawn(pot);
  const { x, y } = await spotOf(grip(pot, "move-x"));
  await pot.page.mouse.move(x, y);
  await pot.page.mouse.down();
  // With the first movements the bar says that there is something to undo.
  await pot.page.mouse.move(x + 10, y, { steps: 5 });
  await pot.page.locator("pasu-place-handles output:not([hidden])").waitFor();
  await drawn(pot);
  const lines = await pot.page.locator("pasu-place-handles").evaluateHandle(({ shadowRoot }) => {
    const found = { lines: 0 };
    const count = (all: readonly MutationRecord[]) => {
      found.lines += all.length;
    };
    if (shadowRoot) new MutationObserver(count).observe(shadowRoot, { subtree: true, attributeFilter: ["d"] });
    return found;
  });
  await pot.page.mouse.move(x + 40, y, { steps: 10 });
  const during = await drawn(pot);
  // Each of the three lines once with each movement, and perhaps once more when the camera has come after.
  expect((await lines.jsonValue()).lines).toBeLessThanOrEqual(33);
  expect(await pot.page.locator("pasu-constraints [aria-busy=true]").count()).toBe(1);
  expect(await below()).toBe(panel);
  expect(during).toContain("pasu-place-handles");
  const others = ["pasu-app", "pasu-stage", "pasu-place-bar", "pasu-panel", "pasu-parameters", "a new canvas"];
  expect(during.filter((name) => others.includes(name))).toEqual([]);
  await pot.page.mouse.up();
  await judged(pot);
  await expect.poll(below).toBe(panel);
  await pot.leave();
});

test("Escape takes a drag back, and what follows it does nothing", async () => {
  const pot = await three();
  await choose(pot, "Lid");
  await takeParts(pot);
  const from = await spotOf(grip(pot, "free"));
  await dragFrom(
    pot,
    from,
    { x: 60, y: 20 },
    {
      held: async () => {
        expect((await shifts(pot))[1]).not.toEqual([3, 0, 0]);
        await pot.page.keyboard.press("Escape");
        await undone(pot);
        await pot.page.mouse.move(from.x + 90, from.y);
      },
    },
  );
  await undone(pot);
  // Only the design that was opened can be undone.
  await pot.undo();
  await expect.poll(async () => (await standing(pot)).length).toBe(1);
});

test("a part is taken hold of where it is seen, and goes over the table", async () => {
  const pot = await three();
  await takeParts(pot);
  const spot = await seenPart(pot, 2);
  await dragFrom(pot, spot, { x: 0, y: 60 });
  const [body, lid, foot] = await shifts(pot);
  expect([body, lid]).toEqual([
    [0, 0, 0],
    [3, 0, 0],
  ]);
  expect(foot?.[2]).toBe(0);
  expect(Math.hypot((foot?.[0] ?? 0) - 6, foot?.[1] ?? 0)).toBeGreaterThan(0.3);
  await expect.poll(() => pot.page.locator("pasu-parts [aria-selected=true]").innerText()).toContain("Foot");
});

test("keys move, turn and scale by handles that say what they are and where", async () => {
  const pot = await three();
  await choose(pot, "Lid");
  await takeParts(pot);
  const { keyboard } = pot.page;
  const x = pot.page.getByRole("button", { name: /^Along x: at 3\scm/ });
  await x.focus();
  await keyboard.press("ArrowRight");
  const small = ((await shifts(pot))[1]?.[0] ?? 0) - 3;
  expect(small).toBeGreaterThan(0);
  await keyboard.press("Shift+ArrowRight");
  expect((await shifts(pot))[1]?.[0]).toBeCloseTo(3 + 11 * small, 9);
  await grip(pot, "free").focus();
  await keyboard.press("PageUp");
  expect((await shifts(pot))[1]?.[2]).toBeCloseTo(small, 9);
  await pot.button("On the table").click();
  expect((await shifts(pot))[1]?.[2]).toBe(0);
  // Nor does it need a picture of what the keys did.
  await grip(pot, "free").focus();
  const toTable = await pot.button("On the table").elementHandle();
  await pot.page.evaluate((button) => {
    let focused = document.activeElement;
    while (focused?.shadowRoot?.activeElement) focused = focused.shadowRoot.activeElement;
    focused?.dispatchEvent(new KeyboardEvent("keydown", { key: "PageUp", bubbles: true, composed: true }));
    (button as HTMLElement).click();
  }, toTable);
  expect((await shifts(pot))[1]?.[2]).toBe(0);
  await handling(pot, "Turn");
  await grip(pot, "turn-x").focus();
  for (let press = 0; press < 6; press += 1) await keyboard.press("Shift+ArrowUp");
  const [, turned] = await standing(pot);
  expect(turned?.axis).toEqual([1, 0, 0]);
  expect(turned?.angle).toBeCloseTo(Math.PI / 2, 9);
  await handling(pot, "Scale");
  await grip(pot, "scale-all").focus();
  await keyboard.press("Shift+ArrowUp");
  expect((await standing(pot))[1]?.scale).toEqual([1.1, 1.1, 1.1]);
  await grip(pot, "scale-y").focus();
  await keyboard.press("Shift+ArrowDown");
  expect((await standing(pot))[1]?.scale).toEqual([1.1, 1, 1.1]);
  // Each press was a step of its own.
  await pot.undo();
  expect((await standing(pot))[1]?.scale).toEqual([1.1, 1.1, 1.1]);
});

test("several parts are selected by clicks with the shift key, and turn and grow together", async () => {
  const pot = await three();
  const { keyboard, mouse } = pot.page;
  const first = await seenPart(pot, 0);
  await mouse.click(first.x, first.y);
  const second = await seenPart(pot, 2);
  await keyboard.down("Shift");
  await mouse.click(second.x, second.y);
  await keyboard.up("Shift");
  const selected = pot.page.locator("pasu-parts [aria-selected=true]");
  await expect.poll(() => selected.count()).toBe(2);
  await takeParts(pot);
  await handling(pot, "Turn");
  await grip(pot, "turn-z").focus();
  for (let press = 0; press < 12; press += 1) await keyboard.press("Shift+ArrowUp");
  // Half a turn about the middle of both: they change places.
  await expect
    .poll(async () => (await shifts(pot)).map((shift) => shift.map((each) => Math.round(1e6 * each) / 1e6 + 0)))
    .toEqual([
      [6, 0, 0],
      [3, 0, 0],
      [0, 0, 0],
    ]);
  await handling(pot, "Scale");
  expect(await grip(pot, "scale-x").count()).toBe(0);
  await grip(pot, "scale-all").focus();
  await keyboard.press("Shift+ArrowUp");
  const scales = (await standing(pot)).map(({ scale }) => scale[0]);
  expect(scales).toEqual([1.1, 1, 1.1]);
});

test("in steps numbers are round, and what is near to the table stands on it", async () => {
  const pot = await three();
  await choose(pot, "Lid");
  await takeParts(pot);
  await pot.page.keyboard.press("Tab");
  await pot.page.locator("pasu-place-bar").getByRole("checkbox", { name: "Steps" }).check();
  await dragFrom(pot, await spotOf(grip(pot, "move-x")), { x: 37, y: 3 });
  const at = (await shifts(pot))[1]?.[0] ?? 0;
  expect(at).not.toBe(3);
  expect(Math.abs(at / 0.2 - Math.round(at / 0.2))).toBeLessThan(1e-9);
  await handling(pot, "Turn");
  const ring = await spotOf(grip(pot, "turn-z"));
  await dragFrom(pot, ring, { x: 60, y: -10 });
  const degrees = (((await standing(pot))[1]?.angle ?? 0) / Math.PI) * 180;
  expect(degrees).not.toBe(0);
  expect(Math.abs(degrees / 15 - Math.round(degrees / 15))).toBeLessThan(1e-9);
});

test("a finger moves a part over the table, and beside it turns the view", async () => {
  const pot = await three({ ...QUICK, ...PHONE });
  await takeParts(pot);
  const from = await seenPart(pot, 1);
  await fingers(pot, [{ from, to: { x: from.x + 10, y: from.y + 40 } }]);
  await expect.poll(async () => (await shifts(pot))[1]).not.toEqual([3, 0, 0]);
  const moved = await shifts(pot);
  const stage = await pot.page.locator("pasu-stage").boundingBox();
  if (!stage) throw new Error("no stage");
  const beside = { x: stage.x + 12, y: stage.y + stage.height * 0.75 };
  await fingers(pot, [{ from: beside, to: { x: beside.x + 60, y: beside.y } }]);
  expect(await shifts(pot)).toEqual(moved);
});

test("what puts a part back where it was has nothing more to do then, and has the focus still", async () => {
  const pot = await three();
  await choose(pot, "Lid");
  await pot.page.locator("pasu-place summary").first().click();
  const back = pot.page.locator("pasu-place").getByRole("button", { name: "Put it back" });
  await back.focus();
  await pot.page.keyboard.press("Enter");
  await expect.poll(() => back.isDisabled()).toBe(true);
  expect((await shifts(pot))[1]).toEqual([0, 0, 0]);
  expect(await back.evaluate((button) => button.matches(":focus"))).toBe(true);
  // Nothing happens a second time.
  await pot.page.keyboard.press("Enter");
  await pot.undo();
  await undone(pot);
});

test("on the narrowest phones the whole bar of the tool is on the screen", async () => {
  const pot = await three({ ...QUICK, ...PHONE });
  await takeParts(pot);
  for (const width of [320, 360]) {
    await pot.page.setViewportSize({ width, height: 740 });
    expect(await unreachable(pot, "pasu-place-bar"), `${width} pixels wide`).toEqual([]);
    const bar = await pot.page.locator("pasu-place-bar .bar").boundingBox();
    expect(bar && bar.x >= 0 && bar.x + bar.width <= width, `${width} pixels wide`).toBe(true);
  }
});

test("the tool is there for everybody, and one part alone is moved by its key", async () => {
  for (const colorScheme of ["light", "dark"] as const) {
    const pot = await three({ colorScheme });
    await takeParts(pot);
    for (const name of ["Move", "Turn", "Scale"]) {
      await handling(pot, name);
      expect(await findings(pot)).toEqual([]);
    }
  }
  const alone = await here.enter({ link: "#1/second-order" });
  await alone.fingerprint();
  expect(await alone.button("Move").count()).toBe(0);
  await alone.page.locator("pasu-stage .host").focus();
  await alone.page.keyboard.press("m");
  await grip(alone, "move-z").focus();
  await alone.page.keyboard.press("Shift+ArrowUp");
  expect((await standing(alone))[0]?.shift[2]).toBeGreaterThan(0);
  await alone.page.locator("pasu-stage .host").focus();
  await alone.page.keyboard.press("p");
  await expect.poll(() => alone.page.locator("pasu-place-handles").count()).toBe(0);
});

test("of what is hidden the bar says so, since nobody sees what a handle moves", async () => {
  const pot = await three();
  await choose(pot, "Lid");
  await takeParts(pot);
  const note = pot.page.locator("pasu-place-bar").getByText("What is selected is hidden.");
  expect(await note.count()).toBe(0);
  await choose(pot, "Lid");
  await pot.page.keyboard.press("h");
  await note.waitFor();
  await choose(pot, "Foot");
  await note.waitFor({ state: "detached" });
});

test("what is left once the rest is hidden is fitted into the view, moved by keys by little, and all fits again", async () => {
  const block = (name: string, size: number, x: number, object: number) => ({
    name,
    object,
    shape: { kind: "octant", exponents: [8, 8, 8] },
    place: { scale: [size, size, size], shift: [x, 0, 0] },
  });
  const pot = await here.enter();
  const first = await pot.fingerprint();
  const parts = [block("Huge", 1000, 0, 0), block("Tiny", 0.001, 1200, 1)];
  await pot.dropFile("scene.json", JSON.stringify({ pasu: 1, unit: "in", parts }));
  const both = await pot.fingerprintOtherThan(first);
  await choose(pot, "Huge");
  await pot.button("Hide").click();
  await choose(pot, "Tiny");
  await pot.button("Fit to view").click();
  const middleOf = async (selector: string) => {
    const box = await pot.page.locator(selector).first().boundingBox();
    return box && { x: box.x + box.width / 2, y: box.y + box.height / 2, high: box.height };
  };
  const stage = await middleOf("pasu-stage .host");
  if (!stage) throw new Error("there is no stage");
  const seen = await seenPart(pot, 1);
  expect(Math.abs(seen.x - stage.x)).toBeLessThan(stage.high / 6);
  expect(Math.abs(seen.y - stage.y)).toBeLessThan(stage.high / 6);
  await takeParts(pot);
  await grip(pot, "move-x").press("Shift+ArrowRight");
  await pot.fingerprintOtherThan(both);
  // By its own size, and not by a fortieth of the other's.
  expect((await standing(pot))[1]?.shift).toEqual([1200.001, 0, 0]);
  await choose(pot, "Huge");
  await pot.button("Show").click();
  // It was all in the view, and so is what came back.
  await expect.poll(async () => Number.isFinite((await seenPart(pot, 0)).x)).toBe(true);
});
