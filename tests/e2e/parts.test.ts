// A pot of several parts: which one is changed, what they are called, their order, copies, and away with one.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { countUploads, type PartBehind, type StageBehind, stageOf, uploads } from "../support/on-stage.ts";
import { difference, stagePicture } from "../support/sight.ts";
import { stay } from "../support/stay.ts";
import { CLEAR, type Visit, type VisitOptions } from "../support/visit.ts";

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
const options = (pot: Visit) => pot.page.locator("pasu-parts [role=option]");
const names = async (pot: Visit) =>
  (await options(pot).locator("> span:first-child").allInnerTexts()).map((text) => text.trim());
const selected = (pot: Visit) => pot.page.locator("pasu-parts [aria-selected=true] > span:first-child").innerText();
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
  await expect.poll(() => names(pot)).toEqual(["Body", "Part 2", "Lid"]);
  // The order of parts is no part of the scene.
  await pot.shows(scene);
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
  expect(await selected(pot)).toBe("Lid 2");
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
  await expect.poll(() => names(pot)).toEqual(["Lid", "Body", "Part 3"]);
  expect(await pot.button("Move up").isDisabled()).toBe(true);
  expect(await radius(pot)).toBe("1.5");
  await options(pot).filter({ hasText: "Body" }).click();
  await expect.poll(() => radius(pot)).toBe("1");
  await pot.undo();
  await pot.shows(wider);
  expect(await selected(pot)).toBe("Body");
});

test("the part that is first now is moved up no further, and its button has the focus still", async () => {
  const { pot } = await three();
  await options(pot).filter({ hasText: "Lid" }).click();
  const up = pot.button("Move up");
  await up.focus();
  await pot.page.keyboard.press("Enter");
  await expect.poll(() => up.isDisabled()).toBe(true);
  await pot.page.keyboard.press("Enter");
  expect(await names(pot)).toEqual(["Lid", "Body", "Part 3"]);
  expect(await selected(pot)).toBe("Lid");
  expect(await up.evaluate((button) => button.matches(":focus"))).toBe(true);
  // On to the next one with Tab, and back the whole way.
  await pot.page.keyboard.press("Tab");
  for (let step = 0; step < 3; step += 1) await pot.page.keyboard.press("Enter");
  await expect.poll(() => names(pot)).toEqual(["Body", "Part 2", "Lid"]);
  expect(await pot.button("Move down").evaluate((button) => button.matches(":focus"))).toBe(true);
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

test("why a part got its old name back is said until the next one is typed, or another part is selected", async () => {
  const { pot } = await three();
  const { keyboard } = pot.page;
  const taken = pot.page.getByText("Another part has this name.");
  const field = pot.page.getByLabel("Name of the part");
  const name = async (text: string) => {
    await field.fill(text);
    await keyboard.press("Tab");
  };
  await options(pot).filter({ hasText: "Lid" }).click();
  await name("Body");
  await expect.poll(() => field.inputValue()).toBe("Lid");
  expect(await field.getAttribute("aria-invalid")).toBe("false");
  expect(await taken.count()).toBe(1);
  expect(await findings(pot)).toEqual([]);
  await name("Cover");
  await expect.poll(() => names(pot)).toEqual(["Body", "Cover", "Part 3"]);
  expect(await taken.count()).toBe(0);
  await name("Body");
  expect(await taken.count()).toBe(1);
  await options(pot).filter({ hasText: "Part 3" }).click();
  await expect.poll(() => taken.count()).toBe(0);
});

test("a long name keeps its distance from the object behind it", async () => {
  const { pot } = await three();
  await pot.page.locator("pasu-parts select").selectOption({ label: "nothing" });
  await pot.page.getByLabel("Name of the part").fill("l".repeat(60));
  const object = pot.page.locator("pasu-parts .object").first();
  await object.waitFor();
  const gap = () =>
    object.evaluate((behind) => {
      const name = document.createRange();
      name.selectNodeContents(behind.previousElementSibling ?? behind);
      return behind.getBoundingClientRect().left - name.getBoundingClientRect().right;
    });
  await expect.poll(gap).toBeLessThan(20);
  expect(await gap()).toBeGreaterThan(6);
});

test("a part is glued to others, or stands by itself, which the link knows and one step takes back", async () => {
  const { pot } = await three();
  const glue = pot.page.locator("pasu-parts select");
  const chosen = () => glue.evaluate((select: HTMLSelectElement) => select.selectedOptions[0]?.text.trim());
  const objects = async () =>
    (await pot.page.locator("pasu-parts .object").allInnerTexts()).map((text) => text.replace(/[,\s]+/, ""));
  expect(await chosen()).toBe("Lid and Part 3");
  expect(await objects()).toEqual([]);
  const together = await pot.address();
  await glue.selectOption({ label: "nothing" });
  await expect.poll(objects).toEqual(["Object 1", "Object 2", "Object 2"]);
  expect(await chosen()).toBe("nothing");
  await expect.poll(() => pot.address()).not.toBe(together);
  expect(await findings(pot)).toEqual([]);
  await list(pot).focus();
  await pot.page.keyboard.press("End");
  await glue.selectOption({ label: "Body" });
  await expect.poll(objects).toEqual(["Object 1", "Object 2", "Object 1"]);
  await pot.undo();
  await pot.undo();
  await expect.poll(chosen).toBe("Body and Lid");
  await expect.poll(() => pot.address()).toBe(together);
});

test("the list is there for everybody", async () => {
  for (const colorScheme of ["light", "dark"] as const) {
    const { pot } = await three({ colorScheme });
    expect(await findings(pot)).toEqual([]);
  }
});

/** What of each part is seen along the middle of the picture: the parts by their places, each once. */
async function seen(pot: Visit): Promise<readonly number[]> {
  const stage = await stageOf(pot);
  return await stage.evaluate(async (it: StageBehind) => {
    await it.whenIdle();
    const { designer } = document.querySelector("pasu-app") as unknown as { designer: { store: { ids: number[] } } };
    const { clientWidth, clientHeight } = it.root;
    const found = Array.from({ length: 60 }, (_, i) => it.pick(((i + 0.5) / 60) * clientWidth, clientHeight / 2));
    return [...new Set(found.flatMap((id) => (id === null ? [] : [designer.store.ids.indexOf(Number(id))])))].sort();
  });
}

/** Where a part is seen on the page. */
async function spotOf(pot: Visit, place: number): Promise<{ readonly x: number; readonly y: number }> {
  const stage = await stageOf(pot);
  return await stage.evaluate(async (it: StageBehind, wanted) => {
    await it.whenIdle();
    const { designer } = document.querySelector("pasu-app") as unknown as { designer: { store: { ids: number[] } } };
    const { left, top, width, height } = it.root.getBoundingClientRect();
    const across = Array.from({ length: 60 }, (_, i) => ((i + 0.5) / 60) * width);
    const own = across.filter((x) => it.pick(x, height / 2) === designer.store.ids[wanted]);
    return { x: left + (own[own.length >> 1] ?? Number.NaN), y: top + height / 2 };
  }, place);
}

test("a click on a part of the picture selects it, and turning the pot selects nothing", async () => {
  const { pot } = await three();
  const { mouse } = pot.page;
  expect(await selected(pot)).toBe("Body");
  for (const [place, name] of [
    [2, "Part 3"],
    [1, "Lid"],
  ] as const) {
    const { x, y } = await spotOf(pot, place);
    await mouse.click(x, y);
    await expect.poll(() => selected(pot)).toBe(name);
  }
  expect(await radius(pot)).toBe("1.2");
  const { x, y } = await spotOf(pot, 0);
  await mouse.move(x, y);
  await mouse.down();
  await mouse.move(x + 40, y + 5, { steps: 4 });
  await mouse.up();
  expect(await selected(pot)).toBe("Lid");
  const corner = await pot.page.locator("pasu-stage .host").boundingBox();
  if (!corner) throw new Error("no stage");
  await mouse.click(corner.x + 3, corner.y + corner.height / 2);
  expect(await selected(pot)).toBe("Lid");
});

test("a part that is hidden is not drawn and not found, and stays in the design, its measures and its files", async () => {
  const { pot, scene } = await three();
  const { keyboard } = pot.page;
  const note = pot.page.getByText("What is hidden is still part of the design");
  const caption = () => pot.page.locator("pasu-stage #description").innerText();
  expect(await seen(pot)).toEqual([0, 1, 2]);
  const said = await caption();
  const eyes = pot.page.locator("pasu-parts .eye");
  await eyes.nth(1).click();
  await expect.poll(() => seen(pot)).toEqual([0, 2]);
  // What is hidden by its eye is not what is selected.
  expect(await selected(pot)).toBe("Body");
  expect(await pot.fingerprint()).toBe(scene);
  expect(await caption()).toBe(said);
  await note.waitFor();
  await list(pot).focus();
  await keyboard.press("h");
  await expect.poll(() => seen(pot)).toEqual([2]);
  expect(await options(pot).first().innerText()).toContain("hidden");
  expect(await findings(pot)).toEqual([]);
  await pot.button("Show").click();
  await expect.poll(() => seen(pot)).toEqual([0, 2]);
  await pot.tab("Measures");
  await pot.page.locator("pasu-measures").getByText("One part is hidden.").waitFor();
  await pot.command("Export");
  await pot.page.locator("pasu-export").getByText("One part is hidden.").waitFor();
  await keyboard.press("Escape");
  // It is the session's alone: a design that is opened again has nothing hidden.
  await pot.page.reload();
  await pot.fingerprint();
  await expect.poll(() => seen(pot)).toEqual([0, 1, 2]);
});

test("what is left alone is seen and loose, though it was hidden and locked", async () => {
  const { pot } = await three();
  const { keyboard } = pot.page;
  await list(pot).focus();
  await keyboard.press("End");
  await keyboard.press("h");
  await keyboard.press("l");
  await keyboard.press("Home");
  await keyboard.press("Shift+ArrowDown");
  await keyboard.press("Delete");
  await list(pot).waitFor({ state: "detached" });
  await expect.poll(() => seen(pot)).toEqual([0]);
  await pot.undo();
  await list(pot).waitFor();
  expect(
    await options(pot)
      .filter({ hasText: /hidden|locked/ })
      .count(),
  ).toBe(0);
});

test("of twenty parts the one whose slider is dragged travels to the graphics card, and one that moves does not", async () => {
  const parts = Array.from({ length: 20 }, (_, i) => part(1 + i / 100, { place: { shift: [3 * i, 0, 0] } }));
  const pot = await here.enter({ before: countUploads });
  const first = await pot.fingerprint();
  await pot.dropFile("twenty.json", JSON.stringify({ pasu: 1, parts }));
  const scene = await pot.fingerprintOtherThan(first);
  const rest = async () => {
    const stage = await stageOf(pot);
    await stage.evaluate((it: StageBehind) => it.whenIdle());
  };
  await rest();
  const own = await pot.page.evaluate(() => {
    const { designer } = document.querySelector("pasu-app") as unknown as {
      designer: { surface: { shown: { solved: { parts: PartBehind[] } } } };
    };
    const { positions, normals, ware } = (designer.surface.shown.solved.parts[0] as PartBehind).mesh;
    return positions.byteLength + normals.byteLength + ware.texels.byteLength;
  });
  await options(pot).nth(6).click();
  await expect.poll(() => radius(pot)).toBe("1.06");
  await rest();
  await uploads(pot);
  // The grid is the same under the hand and at rest: the size of what travels is that of whole parts.
  await pot.drag("Rim radius", 0.6, { steps: 3 });
  const wider = await pot.fingerprintOtherThan(scene);
  await rest();
  const dragged = await uploads(pot);
  expect(dragged.bytes % own).toBe(0);
  expect(dragged.bytes / own).toBeGreaterThanOrEqual(1);
  // Three movements and the rest: each is one part, never all of twenty.
  expect(dragged.bytes / own).toBeLessThanOrEqual(5);
  expect(dragged.pieces).toBe((3 * dragged.bytes) / own);
  // Moved by the document: its matrix is all that changes.
  await pot.page.evaluate(() => {
    const { designer } = document.querySelector("pasu-app") as unknown as {
      designer: { store: { design: { parts: object[] } }; apply(change: object): void };
    };
    const { design } = designer.store;
    const moved = design.parts.map((each, i) => (i === 4 ? { ...each, place: { shift: [12, 2, 1] } } : each));
    designer.apply({ design: { ...design, parts: moved }, undo: "step" });
  });
  await pot.fingerprintOtherThan(wider);
  await rest();
  expect(await uploads(pot)).toEqual({ pieces: 0, bytes: 0 });
  expect(pot.troubles).toEqual([]);
});

test("the selected part is outlined on the stage, and not in pictures", async () => {
  const { pot } = await three(CLEAR);
  const stage = await stageOf(pot);
  const picture = async () =>
    await stage.evaluate(async (it) => {
      const blob = await it.picture(300, 200);
      return btoa(String.fromCharCode(...new Uint8Array(await blob.arrayBuffer())));
    });
  const [plain, photograph] = [await stagePicture(pot), await picture()];
  await options(pot).nth(1).click();
  expect(await selected(pot)).toBe("Lid");
  await expect.poll(async () => (await stagePicture(pot)).equals(plain), { timeout: 20_000 }).toBe(false);
  const marked = await stagePicture(pot);
  // An outline, no tint: little of what is seen is different, and that plainly.
  const { mean, share } = difference(plain, marked);
  expect(share).toBeLessThan(0.05);
  expect(mean / share).toBeGreaterThan(40);
  expect(await picture()).toBe(photograph);
  // Another part has it then; of one part alone there is none.
  await options(pot).nth(2).click();
  await expect.poll(async () => (await stagePicture(pot)).equals(marked), { timeout: 20_000 }).toBe(false);
});
