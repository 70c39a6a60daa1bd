// Hands on the stage: the pot is pulled by mouse, by touch and by keys, follows, and is one step of undo each time.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { fineWall } from "../support/drag.ts";
import { dragFrom, fingers, onStage, ring, ringsOf, spotOf, takeUp } from "../support/pulling.ts";
import { overhang, unreachable } from "../support/reach.ts";
import { stagePicture } from "../support/sight.ts";
import { stay } from "../support/stay.ts";
import { PHONE, type VisitOptions } from "../support/visit.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();
const BOTTLE = "#1/rings";
const VASE = "#1/second-order";
/** It stands on a narrow foot. */
const TOPPLING = "#1/rings?r=1.2,4,1.6,2&z=0,12,16,20";

test("a ring is pulled by the mouse, in one step of undo, and Escape takes back what was not meant", async () => {
  const pot = await here.enter({ link: BOTTLE });
  const before = await pot.fingerprint();
  await takeUp(pot);
  expect(await ringsOf(pot)).toBe(4);
  const spot = await spotOf(ring(pot, 1));
  await pot.page.getByRole("radio", { name: "All round" }).check();
  await dragFrom(pot, spot, { x: 40, y: 0 });
  const wide = await pot.fingerprintOtherThan(before);
  expect((await spotOf(ring(pot, 1))).x).toBeGreaterThan(spot.x + 30);
  expect(await ringsOf(pot)).toBe(4);
  await pot.undo();
  await pot.shows(before);
  expect(await pot.history("Undo").isEnabled()).toBe(false);
  await pot.redo();
  await pot.shows(wide);
  await dragFrom(pot, await spotOf(ring(pot, 1)), { x: -40, y: 0 }, { held: () => pot.page.keyboard.press("Escape") });
  await pot.shows(wide);
  // Between rings one is put where the hand is, and what is pulled with shift goes up.
  const middle = await onStage(pot, 0.5, 0.55);
  await pot.page.mouse.move(middle.x, middle.y);
  await pot.page.locator("pasu-pull .surface.over").waitFor();
  // Two clicks put one there and leave the pot as it is.
  await pot.page.mouse.dblclick(middle.x, middle.y);
  await expect.poll(() => ringsOf(pot)).toBe(5);
  await pot.undo();
  await pot.shows(wide);
  await pot.page.keyboard.down("Shift");
  await dragFrom(pot, middle, { x: 0, y: -25 });
  await pot.page.keyboard.up("Shift");
  await pot.fingerprintOtherThan(wide);
  expect(await ringsOf(pot)).toBe(5);
  expect((await pot.address()).length).toBeLessThan(200);
});

test("beside the pot, with the second button and by the wheel the picture turns and grows, and the pot stays", async () => {
  const pot = await here.enter({ link: BOTTLE, painted: true });
  const before = await pot.fingerprint();
  await takeUp(pot);
  const [corner, middle] = [await onStage(pot, 0.06, 0.4), await onStage(pot, 0.5, 0.6)];
  let seen = await stagePicture(pot);
  const differs = async (gesture: () => Promise<unknown>) => {
    await gesture();
    await expect.poll(async () => (await stagePicture(pot)).equals(seen)).toBe(false);
    seen = await stagePicture(pot);
  };
  await differs(() => dragFrom(pot, corner, { x: 60, y: 20 }));
  await differs(() => dragFrom(pot, middle, { x: 60, y: 20 }, { button: "right" }));
  await differs(() => pot.page.mouse.wheel(0, -200));
  // With shift it is the width of the brush.
  const width = pot.slider("Width");
  const narrow = Number(await width.inputValue());
  await pot.page.keyboard.down("Shift");
  await pot.page.mouse.wheel(0, -200);
  await pot.page.keyboard.up("Shift");
  await expect.poll(async () => Number(await width.inputValue())).toBeGreaterThan(narrow);
  expect(await pot.fingerprint()).toBe(before);
  expect(await pot.history("Undo").isEnabled()).toBe(false);
});

test("by keys a ring is found, moved, pulled wider, taken away, and the tool put down", async () => {
  const pot = await here.enter({ link: BOTTLE });
  const before = await pot.fingerprint();
  const { keyboard } = pot.page;
  await pot.page.getByRole("application", { name: "The pot" }).focus();
  await keyboard.press("p");
  await pot.page.locator("pasu-pull-bar .bar").waitFor();
  await keyboard.press("Tab");
  await keyboard.press("Tab");
  const belly = ring(pot, 1);
  expect(await belly.evaluate((element: HTMLElement) => element.matches(":focus"))).toBe(true);
  expect(await belly.getAttribute("aria-label")).toBe("Ring 1: radius 6 cm, height 6 cm");
  const width = pot.slider("Width");
  const narrow = Number(await width.inputValue());
  await keyboard.press("+");
  await expect.poll(async () => Number(await width.inputValue())).toBeGreaterThan(narrow);
  await keyboard.press("-");
  await pot.page.getByRole("radio", { name: "All round" }).check();
  await belly.focus();
  for (const key of ["ArrowRight", "ArrowRight", "ArrowUp"]) await keyboard.press(key);
  await pot.fingerprintOtherThan(before);
  await expect.poll(() => belly.getAttribute("aria-label")).toMatch(/^Ring 1: radius 6\.\d+ cm, height 6\.\d+ cm$/);
  await keyboard.press("Delete");
  await expect.poll(() => ringsOf(pot)).toBe(3);
  expect(await ring(pot, 0).evaluate((element: HTMLElement) => element.matches(":focus"))).toBe(true);
  // Ends stay.
  await keyboard.press("Delete");
  for (let step = 0; step < 4; step += 1) await pot.undo();
  await pot.shows(before);
  await pot.button("Pull").click();
  await pot.page.locator("pasu-pull").waitFor({ state: "detached" });
});

test("on a phone one finger pulls, two turn, and nothing in the way is too small", async () => {
  const pot = await here.enter({ ...PHONE, link: BOTTLE, painted: true });
  const before = await pot.fingerprint();
  await takeUp(pot);
  const middle = await onStage(pot, 0.5, 0.6);
  await pot.page.getByRole("combobox", { name: "Which way" }).selectOption("up");
  await fingers(pot, [{ from: middle, to: { x: middle.x, y: middle.y - 20 } }]);
  const pulled = await pot.fingerprintOtherThan(before);
  const seen = await stagePicture(pot);
  await fingers(pot, [
    { from: { x: middle.x, y: middle.y - 30 }, to: { x: middle.x + 10, y: middle.y - 60 } },
    { from: { x: middle.x, y: middle.y + 30 }, to: { x: middle.x + 10, y: middle.y + 60 } },
  ]);
  await expect.poll(async () => (await stagePicture(pot)).equals(seen)).toBe(false);
  expect(await pot.fingerprint()).toBe(pulled);
});

test("two fingers side by side on the pot squeeze it from both sides, all round or as an oval, in one step", async () => {
  const pot = await here.enter({ ...PHONE, link: BOTTLE, painted: true });
  const before = await pot.fingerprint();
  await takeUp(pot);
  const { y } = await spotOf(ring(pot, 1));
  const middle = await onStage(pot, 0.5, 0.5);
  const squeezed = async (spread: string) => {
    await pot.page.getByRole("combobox", { name: "Where" }).selectOption(spread);
    await fingers(pot, [
      { from: { x: middle.x - 25, y }, to: { x: middle.x - 10, y } },
      { from: { x: middle.x + 25, y }, to: { x: middle.x + 10, y } },
    ]);
    const fingerprint = await pot.fingerprintOtherThan(before);
    const link = await pot.address();
    await pot.undo();
    await pot.shows(before);
    expect(await pot.history("Undo").isEnabled()).toBe(false);
    return { fingerprint, link };
  };
  const round = await squeezed("all");
  const oval = await squeezed("side");
  expect(oval.fingerprint).not.toBe(round.fingerprint);
  expect(decodeURIComponent(oval.link).length).toBeGreaterThan(decodeURIComponent(round.link).length);
});

test("a named vase follows with its numbers, and says where it cannot", async () => {
  const pot = await here.enter({ link: VASE });
  const before = await pot.fingerprint();
  const belly = await pot.field("Rim radius").inputValue();
  await takeUp(pot);
  // Rim, middle and foot.
  expect(await ringsOf(pot)).toBe(3);
  expect(await pot.page.getByRole("radio", { name: "All round" }).count()).toBe(0);
  await pot.page.getByRole("radio", { name: "Free" }).check();
  await dragFrom(pot, await onStage(pot, 0.5, 0.5), { x: 30, y: -30 });
  await pot.fingerprintOtherThan(before);
  expect(await pot.field("Rim radius").inputValue()).not.toBe(belly);
  expect((await pot.address()).startsWith(VASE)).toBe(true);
});

test("by keys a named vase is pulled at its rim, its middle and its foot, and what is kept stays", async () => {
  const pot = await here.enter({ link: VASE });
  const before = await pot.fingerprint();
  const { keyboard } = pot.page;
  const [rim, foot, height] = [pot.field("Rim radius"), pot.field("Foot radius"), pot.field("Height").first()];
  const given = await Promise.all([rim, foot, height].map((field) => field.inputValue()));
  await takeUp(pot);
  const keep = pot.page.getByRole("group", { name: "Keep" });
  await keep.getByRole("checkbox", { name: "Foot" }).check();
  await keep.getByRole("checkbox", { name: "Height" }).check();
  await ring(pot, 0).focus();
  expect(await ring(pot, 0).getAttribute("aria-label")).toBe("Rim");
  const told = pot.page.locator("pasu-pull p[role=status]");
  await expect.poll(() => told.textContent()).toMatch(/^Rim: radius [\d.]+\scm, height [\d.]+\scm$/);
  const first = await told.textContent();
  await keyboard.press("Shift+ArrowRight");
  const once = await pot.fingerprintOtherThan(before);
  await keyboard.press("Shift+ArrowRight");
  await pot.fingerprintOtherThan(once);
  expect(await rim.inputValue()).not.toBe(given[0]);
  expect(await foot.inputValue()).toBe(given[1]);
  expect(await height.inputValue()).toBe(given[2]);
  await expect.poll(() => told.textContent()).not.toBe(first);
  // Nothing of it can be taken away.
  await keyboard.press("Delete");
  expect(await ringsOf(pot)).toBe(3);
  await keyboard.press("Tab");
  expect(await ring(pot, 1).getAttribute("aria-label")).toBe("Middle");
  await keyboard.press("Tab");
  expect(await ring(pot, 2).getAttribute("aria-label")).toBe("Foot");
  expect(await findings(pot)).toEqual([]);
  // Each press was a step.
  await pot.undo();
  await pot.shows(once);
  await pot.undo();
  await pot.shows(before);
});

test("on a phone what is kept of a family can be ticked", async () => {
  const pot = await here.enter({ ...PHONE, link: VASE });
  await pot.fingerprint();
  await takeUp(pot);
  expect(await overhang(pot)).toBe(0);
  expect(await unreachable(pot, ".bar")).toEqual([]);
  expect(await findings(pot)).toEqual([]);
});

/** Two bottles, the second lying on its side, stretched and in a mirror. */
const PAIR = {
  pasu: 1,
  unit: "in",
  parts: [
    { shape: { kind: "rings", rings: bottleRings() } },
    {
      shape: { kind: "rings", rings: bottleRings() },
      place: { scale: [1, -1, 1.2], axis: [0, 1, 0], angle: 1.2, shift: [14, 0, 4] },
    },
  ],
};

function bottleRings() {
  return [3, 6, 1.6, 2.2].map((mean, i) => ({ u: [0, 0.35, 0.7, 1][i], r: { mean }, z: { mean: [0, 6, 15, 20][i] } }));
}

test("of several parts the one under the hand is pulled, wherever it stands", async () => {
  const pot = await here.enter({});
  const first = await pot.fingerprint();
  await pot.dropFile("pair.json", JSON.stringify(PAIR));
  const before = await pot.fingerprintOtherThan(first);
  await takeUp(pot);
  await pot.page.getByRole("radio", { name: "All round" }).check();
  const radii = () =>
    pot.page.evaluate(() => {
      const { designer } = document.querySelector("pasu-app") as unknown as {
        designer: { store: { design: { parts: { shape: { rings: { r: { mean: number } }[] } }[] } } };
      };
      return designer.store.design.parts.map(({ shape }) => shape.rings.map(({ r }) => r.mean));
    });
  await pot.page.locator("pasu-parts [role=option]").nth(1).click();
  const belly = await spotOf(ring(pot, 1));
  const middle = await spotOf(ring(pot, 3));
  // Away from where its axis is seen.
  const by = { x: 0, y: Math.sign(belly.y - middle.y || 1) * 30 };
  await dragFrom(pot, belly, by);
  await pot.fingerprintOtherThan(before);
  const [one, other] = await radii();
  expect(one).toEqual([3, 6, 1.6, 2.2]);
  expect(other).toHaveLength(4);
  expect(Math.abs((other?.[1] ?? 0) - 6)).toBeGreaterThan(0.3);
  await pot.undo();
  await pot.shows(before);
});

test("what is pulled keeps its wall and its water", async () => {
  const pot = await here.enter({ link: BOTTLE });
  const before = await pot.fingerprint();
  await pot.makePot();
  await fineWall(pot);
  await pot.tab("Measures");
  await pot.button("Fill it").click();
  const water = pot.page.locator("pasu-water [data-volume]");
  await water.waitFor();
  const volume = await water.innerText();
  await takeUp(pot);
  await pot.page.getByRole("radio", { name: "All round" }).check();
  await dragFrom(
    pot,
    await spotOf(ring(pot, 1)),
    { x: 30, y: 0 },
    {
      held: () => pot.page.locator('pasu-stage[data-wall="quick"]').waitFor({ state: "attached" }),
    },
  );
  await pot.fingerprintOtherThan(before);
  await fineWall(pot);
  await expect.poll(() => water.innerText()).not.toBe(volume);
});

test("that a pot falls over is said beside the hand that holds it, whatever panel is open", async () => {
  const pot = await here.enter({ link: TOPPLING });
  await pot.fingerprint();
  await pot.makePot();
  await pot.tab("Shape");
  await takeUp(pot);
  const fault = pot.page.locator("pasu-pull-bar .fault");
  const bar = await pot.page.locator("pasu-pull-bar").boundingBox();
  const spot = await spotOf(ring(pot, 2));
  const far = await onStage(pot, 0.97, 0.5);
  const falls = /^It falls over/;
  const held = async () => {
    await expect.poll(() => fault.innerText()).toMatch(falls);
    expect(await findings(pot)).toEqual([]);
    // The picture makes no room for it: nothing moves under the hand.
    expect(await pot.page.locator("pasu-pull-bar").boundingBox()).toEqual(bar);
    await pot.page.mouse.move(spot.x, spot.y);
    await expect.poll(() => fault.innerText()).not.toMatch(falls);
    await pot.page.mouse.move(far.x, spot.y);
    await expect.poll(() => fault.innerText()).toMatch(falls);
  };
  await dragFrom(pot, spot, { x: far.x - spot.x, y: 0 }, { held });
  await pot.page.locator('pasu-app[data-state="ready"]').waitFor();
  await expect.poll(() => fault.innerText()).toMatch(falls);
  // Whoever puts the tool down is not told any more.
  await pot.button("Pull").click();
  await fault.waitFor({ state: "detached" });
});

test("what cannot be made is said while the hand still holds it, and taken back as soon as it can", async () => {
  const pot = await here.enter({ link: BOTTLE });
  const before = await pot.fingerprint();
  await pot.makePot();
  await pot.tab("Measures");
  const faults = pot.page.locator("pasu-measures .sentences .error");
  const sentences = pot.page.locator("pasu-measures .sentences li");
  await sentences.first().waitFor();
  expect(await faults.count()).toBe(0);
  await takeUp(pot);
  await pot.page.getByRole("radio", { name: "All round" }).check();
  const spot = await spotOf(ring(pot, 1));
  // Past the axis, where the surface runs through itself, and back to where it was.
  const far = await onStage(pot, 0.1, 0.5);
  const held = async () => {
    await faults.first().waitFor();
    await pot.page.mouse.move(spot.x, spot.y);
    await expect.poll(() => faults.count()).toBe(0);
  };
  await dragFrom(pot, spot, { x: far.x - spot.x, y: 0 }, { held });
  await pot.shows(before);
  await sentences.first().waitFor();
  expect(await faults.count()).toBe(0);
});

test.each<[string, VisitOptions]>([
  ["on a phone", PHONE],
  // A window of 1280 by 800 whose page is enlarged to 200 %.
  ["at 200 %", { viewport: { width: 640, height: 400 } }],
])("the bar is within reach %s", async (_, options) => {
  const pot = await here.enter({ ...options, link: BOTTLE });
  await pot.fingerprint();
  await takeUp(pot);
  expect(await overhang(pot)).toBe(0);
  for (const spread of ["all", "side", "petals"]) {
    await pot.page.getByRole("combobox", { name: "Where" }).selectOption(spread);
    expect(await unreachable(pot, ".bar")).toEqual([]);
  }
  expect(await findings(pot)).toEqual([]);
});

test("the tool is clean to axe, and says nothing that is not from the catalogue", async () => {
  for (const colorScheme of ["light", "dark"] as const) {
    const pot = await here.enter({ link: PSEUDO + BOTTLE, colorScheme });
    await pot.fingerprint();
    await pot.page.locator("pasu-stage-tools .pull").click();
    await pot.page.locator("pasu-pull-bar .bar").waitFor();
    expect(await findings(pot)).toEqual([]);
    expect(await unmarked(pot)).toEqual([]);
  }
});

test("what is kept of a pot of rings stays while its belly and its foot are pulled, by keys as well", {
  timeout: 240_000,
}, async () => {
  const pot = await here.enter({ link: BOTTLE });
  await pot.fingerprint();
  await pot.makePot();
  const before = await pot.fingerprint();
  const shape = () =>
    pot.page.evaluate(() => {
      const { designer } = document.querySelector("pasu-app") as unknown as {
        designer: {
          store: { design: { parts: { shape: { rings: { r: { mean: number }; z: { mean: number } }[] } }[] } };
        };
      };
      return designer.store.design.parts[0]?.shape.rings.map(({ r, z }) => [r.mean, z.mean]) ?? [];
    });
  const given = await shape();
  await takeUp(pot);
  await pot.page.getByRole("radio", { name: "All round" }).check();
  await pot.page.locator("pasu-pull-bar").getByRole("button", { name: "Keep" }).press("Enter");
  const keep = pot.page.getByRole("group", { name: "Keep" });
  await keep.getByRole("checkbox", { name: "Foot" }).press("Space");
  await keep.getByRole("checkbox", { name: "What it holds" }).press("Space");
  expect(await findings(pot)).toEqual([]);
  await pot.page.keyboard.press("Escape");
  // Nothing of the foot moves.
  await ring(pot, 0).focus();
  await pot.page.keyboard.press("Shift+ArrowRight");
  await ring(pot, 1).focus();
  await pot.page.keyboard.press("Shift+ArrowRight");
  await pot.fingerprintOtherThan(before);
  // Wider, it becomes lower once the hand has let go.
  await expect.poll(async () => (await shape()).at(-1)?.[1], { timeout: 60_000 }).toBeLessThan(given.at(-1)?.[1] ?? 0);
  const held = await shape();
  expect(held[0]).toEqual(given[0]);
  expect(held[1]?.[0]).toBeGreaterThan(given[1]?.[0] ?? 0);
  await pot.undo();
  await pot.shows(before);
});

test("the wall keeps its slope at rim and foot while a ring is pulled, until its end is freed", async () => {
  const pot = await here.enter({ link: BOTTLE });
  const before = await pot.fingerprint();
  await takeUp(pot);
  await pot.page.getByRole("radio", { name: "All round" }).check();
  await pot.page.locator("pasu-pull-bar").getByRole("button", { name: "Keep" }).press("Enter");
  const keep = pot.page.getByRole("group", { name: "Keep" });
  await keep.getByRole("checkbox", { name: "Slope of both ends" }).press("Space");
  await pot.page.keyboard.press("Escape");
  await ring(pot, 1).focus();
  await pot.page.keyboard.press("Shift+ArrowRight");
  const pulled = await pot.fingerprintOtherThan(before);
  await expect.poll(() => pot.address()).toMatch(/foot=.*rim=/);
  await pot.button("Change Foot").click();
  await pot.button("Free the slope here").click();
  await pot.fingerprintOtherThan(pulled);
  expect(await pot.address()).not.toContain("foot=");
  await pot.undo();
  await pot.shows(pulled);
  await pot.undo();
  await pot.shows(before);
});
