// Several parts at once: selected in the list, locked, glued, aligned, put onto each other, and copied in rows and rings.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { seenPart, standing } from "../support/placing.ts";
import { dragFrom } from "../support/pulling.ts";
import { stay } from "../support/stay.ts";
import type { Visit, VisitOptions } from "../support/visit.ts";

const here = stay();

const block = (name: string, shift: readonly number[], more: object = {}) => ({
  name,
  shape: { kind: "octant", exponents: [20, 20, 20] },
  place: { scale: [2, 2, 2], shift },
  ...more,
});
const SCENE = {
  pasu: 1,
  title: "Blocks",
  parts: [block("Red", [0, 0, 0]), block("Blue", [4, 1, 1], { object: 1 }), block("Green", [9, 3, 0], { object: 1 })],
};
const JAR = {
  pasu: 1,
  title: "Jar",
  parts: [
    { name: "Jar", shape: { kind: "second-order", r: [1, 0, 0.6, 0.06], height: 2 } },
    {
      name: "Lid",
      object: 1,
      shape: { kind: "second-order", r: [0.2, 0, 0.8, 0], height: 0.5 },
      place: { shift: [5, 1, 0] },
    },
  ],
};

async function scene(design: { readonly parts: readonly object[] }, options: VisitOptions = {}): Promise<Visit> {
  const pot = await here.enter(options);
  const first = await pot.fingerprint();
  await pot.dropFile("scene.json", JSON.stringify(design));
  await pot.fingerprintOtherThan(first);
  await pot.page
    .locator("pasu-parts [role=option]")
    .nth(design.parts.length - 1)
    .waitFor();
  return pot;
}

const rows = (pot: Visit) => pot.page.locator("pasu-parts [role=option]");
const row = (pot: Visit, name: string) => rows(pot).filter({ hasText: name });
const selected = async (pot: Visit) =>
  (await pot.page.locator("pasu-parts [role=option][aria-selected=true] > span:first-child").allInnerTexts()).map(
    (text) => text.trim(),
  );
const shifts = async (pot: Visit) =>
  (await standing(pot)).map(({ shift }) => shift.map((each) => Math.round(1e3 * each) / 1e3 + 0));
const arrange = (pot: Visit) => pot.page.locator("pasu-arrange");
const press = (pot: Visit, name: string) => arrange(pot).getByRole("button", { name, exact: true }).click();
const open = (pot: Visit) => arrange(pot).locator("summary").click();
const objects = async (pot: Visit) =>
  (await pot.page.locator("pasu-parts .object").allInnerTexts()).map((text) => text.replace(/[,\s]+/, ""));

test("several are selected by mouse and keys, and what is done is done to all of them", async () => {
  const pot = await scene(SCENE);
  const { keyboard } = pot.page;
  await row(pot, "Red").click();
  await row(pot, "Green").click({ modifiers: ["Shift"] });
  expect(await selected(pot)).toEqual(["Red", "Blue", "Green"]);
  await row(pot, "Blue").click({ modifiers: ["Control"] });
  expect(await selected(pot)).toEqual(["Red", "Green"]);
  await pot.page.getByText("2 parts selected").waitFor();
  await pot.page.getByRole("listbox", { name: "Parts" }).focus();
  await keyboard.press("h");
  expect(await rows(pot).filter({ hasText: "hidden" }).count()).toBe(2);
  await keyboard.press("h");
  await keyboard.press("Home");
  await keyboard.press("Shift+ArrowDown");
  expect(await selected(pot)).toEqual(["Red", "Blue"]);
  await keyboard.press("Control+a");
  expect(await selected(pot)).toEqual(["Red", "Blue", "Green"]);
  await row(pot, "Blue").click();
  await keyboard.press("o");
  expect(await selected(pot)).toEqual(["Blue", "Green"]);
  await keyboard.press("d");
  await expect.poll(() => rows(pot).count()).toBe(5);
  expect(await selected(pot)).toEqual(["Blue 2", "Green 2"]);
  expect(await objects(pot)).toEqual(["Object 1", "Object 2", "Object 2", "Object 3", "Object 3"]);
  await keyboard.press("Delete");
  await expect.poll(() => rows(pot).count()).toBe(3);
  await pot.undo();
  await expect.poll(() => rows(pot).count()).toBe(5);
});

test("parts are aligned, distributed and mirrored, each by one step", async () => {
  const pot = await scene(SCENE);
  const before = await shifts(pot);
  await pot.page.getByRole("listbox", { name: "Parts" }).focus();
  await pot.page.keyboard.press("Control+a");
  await open(pot);
  await press(pot, "Back");
  await expect.poll(async () => (await shifts(pot)).map(([, y]) => y)).toEqual([3, 3, 3]);
  await pot.undo();
  await expect.poll(() => shifts(pot)).toEqual(before);
  await press(pot, "On one axis");
  const axis = [
    [9, 3, 0],
    [9, 3, 1],
    [9, 3, 0],
  ];
  await expect.poll(() => shifts(pot)).toEqual(axis);
  await pot.undo();
  await expect.poll(() => shifts(pot)).toEqual(before);
  await press(pot, "On the table");
  await expect.poll(async () => (await shifts(pot)).map(([, , z]) => z)).toEqual([0, 0, 0]);
  const same = arrange(pot).getByRole("group", { name: "Same gaps" });
  await same.getByRole("button", { name: "Left to right" }).click();
  await expect.poll(async () => (await shifts(pot)).map(([x]) => x)).toEqual([0, 4.5, 9]);
  const mirror = arrange(pot).getByRole("group", { name: "Mirror" });
  await mirror.getByRole("button", { name: "Left to right" }).click();
  // What stood from 0 to 2 stands from 9 to 11, and is a mirror image.
  await expect.poll(async () => (await standing(pot))[0]?.scale[1]).toBe(-2);
  expect(await findings(pot)).toEqual([]);
  await pot.undo();
  await pot.undo();
  await pot.undo();
  await expect.poll(() => shifts(pot)).toEqual(before);
});

test("of two presses at once the second goes by where the first has put the parts", async () => {
  const pot = await scene(SCENE);
  await row(pot, "Blue").click();
  await open(pot);
  for (const [first, high] of [
    ["On the table", 0],
    ["Top to bottom", 2],
  ] as const) {
    await arrange(pot).evaluate(
      (card, names) => {
        const buttons = [...(card.shadowRoot?.querySelectorAll("button") ?? [])];
        for (const name of names) buttons.find(({ textContent }) => textContent?.trim() === name)?.click();
      },
      [first, "On the table"],
    );
    await expect.poll(async () => (await shifts(pot))[1]).toEqual([4, 1, high]);
    await pot.fingerprint();
    expect((await shifts(pot))[1]).toEqual([4, 1, high]);
    while ((await shifts(pot))[1]?.[2] !== 1) await pot.undo();
    await pot.fingerprint();
  }
});

test("of what is locked the card says why nothing moves it, and it may be copied", async () => {
  const pot = await scene(SCENE);
  await row(pot, "Red").click();
  await open(pot);
  await pot.button("Lock where it stands").click();
  await arrange(pot).getByText("What is selected is locked.").waitFor();
  expect(await arrange(pot).getByRole("button", { name: "On the table" }).isDisabled()).toBe(true);
  await press(pot, "Make the row");
  await expect.poll(() => rows(pot).count()).toBe(8);
  await arrange(pot).getByText("What is selected is locked.").waitFor({ state: "detached" });
});

test("no number under Placement moves what is locked", async () => {
  const pot = await scene(JAR);
  await row(pot, "Lid").click();
  const place = pot.page.locator("pasu-place");
  await place.locator("summary").click();
  expect(await place.locator("[inert]").count()).toBe(0);
  await pot.button("Lock where it stands").click();
  await place.getByText("It is locked where it stands.").waitFor();
  expect(await place.locator("[inert] [data-field='place-shift-2']").count()).toBe(1);
  expect(await findings(pot)).toEqual([]);
  // The other is not.
  await row(pot, "Jar").first().click();
  await place.locator("[inert]").waitFor({ state: "detached" });
});

test("copies stand in a row and in a ring", async () => {
  const pot = await scene(SCENE);
  await row(pot, "Red").click();
  await open(pot);
  await pot.type("How many", "4");
  await pot.type("Step along x", "0");
  await pot.type("Step along y", "3");
  await press(pot, "Make the row");
  await expect.poll(() => rows(pot).count()).toBe(6);
  expect((await shifts(pot)).slice(0, 4)).toEqual([
    [0, 0, 0],
    [0, 3, 0],
    [0, 6, 0],
    [0, 9, 0],
  ]);
  await pot.undo();
  await row(pot, "Red").click();
  await pot.type("Axis at x", "5");
  await pot.type("Axis at y", "0");
  await press(pot, "Make the ring");
  await expect.poll(() => rows(pot).count()).toBe(6);
  expect((await shifts(pot)).slice(0, 4)).toEqual([
    [0, 0, 0],
    [5, -5, 0],
    [10, 0, 0],
    [5, 5, 0],
  ]);
  expect(new Set((await objects(pot)).slice(0, 4)).size).toBe(4);
});

test("that there are too many copies is told as long as so many are asked for", async () => {
  const parts = Array.from({ length: 10 }, (_, i) => block(`Block ${i}`, [3 * i, 0, 0]));
  const pot = await scene({ ...SCENE, parts });
  await row(pot, "Block 0").click();
  await pot.page.keyboard.press("Control+a");
  await open(pot);
  const told = arrange(pot).getByText("A design has at most 500 parts.");
  await pot.type("How many", "60");
  await press(pot, "Make the row");
  await told.waitFor();
  await pot.type("How many", "5");
  await told.waitFor({ state: "detached" });
  await pot.type("How many", "60");
  await press(pot, "Make the ring");
  await told.waitFor();
  await row(pot, "Block 1").click();
  await told.waitFor({ state: "detached" });
  expect(await rows(pot).count()).toBe(10);
});

test("more copies than the slider has are typed, and what is no number of copies is said", async () => {
  const pot = await scene({ ...SCENE, parts: [block("Block", [0, 0, 0]), block("Other", [0, 9, 0])] });
  await row(pot, "Block").click();
  await open(pot);
  for (const wrong of ["1", "2.5", "501", "-3"]) {
    await pot.type("How many", wrong);
    await arrange(pot).getByText("Type a whole number from 2 to 500.").waitFor();
  }
  await pot.type("How many", "75");
  await press(pot, "Make the row");
  await expect.poll(() => rows(pot).count()).toBe(76);
});

test("the step of a row is that of the scene: in another one, and in another unit, it is proposed anew", async () => {
  const pot = await scene(SCENE);
  await row(pot, "Red").click();
  await open(pot);
  const step = () => pot.field("Step along x").inputValue();
  expect(await step()).toBe("2.4");
  await pot.type("Step along x", "5");
  await row(pot, "Blue").click();
  expect(await step()).toBe("5");
  await pot.tab("Measures");
  await pot.page.locator("pasu-size").getByLabel("Unit").selectOption({ label: "millimetres" });
  await pot.tab("Shape");
  await expect.poll(step).toBe("24");
  await pot.type("Step along x", "50");
  await press(pot, "Make the row");
  await expect.poll(() => rows(pot).count()).toBe(8);
  expect(await step()).toBe("50");
  await pot.dropFile("jar.json", JSON.stringify(JAR));
  await expect.poll(() => rows(pot).count()).toBe(2);
  await expect.poll(step).not.toBe("50");
});

test("a lid stands on the rim of the part that was selected last", async () => {
  const pot = await scene(JAR);
  await row(pot, "Lid").click();
  await row(pot, "Jar").click({ modifiers: ["Control"] });
  await open(pot);
  await press(pot, "Stand on it");
  await expect.poll(async () => (await shifts(pot))[1]?.slice(0, 2)).toEqual([0, 0]);
  const [, , z] = (await shifts(pot))[1] ?? [];
  expect(z).toBeGreaterThan(1.99);
  expect(z).toBeLessThan(2.02);
  await press(pot, "Stand on it, as wide as its rim");
  await expect.poll(async () => (await standing(pot))[1]?.scale[0]).toBeGreaterThan(1.1);
  const scale = (await standing(pot))[1]?.scale ?? [];
  expect(scale[0]).toBeCloseTo(scale[1] ?? 0, 9);
  expect(scale[2]).toBe(1);
});

test("a locked part stays under the hand, and is neither moved nor deleted", async () => {
  const pot = await scene(SCENE);
  await row(pot, "Red").click();
  await pot.button("Lock where it stands").click();
  await row(pot, "Red").getByText("locked").waitFor({ state: "attached" });
  expect(await pot.button("Delete").isDisabled()).toBe(true);
  expect(await pot.button("Delete").getAttribute("title")).toBe("Locked parts stay.");
  await pot.button("Move").click();
  await pot.page.getByText("What is selected is locked.").waitFor();
  const before = await standing(pot);
  await dragFrom(pot, await seenPart(pot, 0), { x: 50, y: 10 });
  expect(await standing(pot)).toEqual(before);
  await pot.button("Unlock").click();
  await pot.page.locator("pasu-place-handles [data-grip=free]").waitFor();
  await dragFrom(pot, await seenPart(pot, 0), { x: 50, y: 10 });
  expect(await standing(pot)).not.toEqual(before);
});

test("of all parts none is deleted, and the button says why", async () => {
  const pot = await scene(SCENE);
  const title = () => pot.button("Delete").getAttribute("title");
  expect(await title()).toBe("Delete");
  await pot.page.getByRole("listbox", { name: "Parts" }).focus();
  await pot.page.keyboard.press("Control+a");
  await expect.poll(title).toBe("One part has to stay.");
  await pot.page.keyboard.press("Delete");
  expect(await rows(pot).count()).toBe(3);
  await row(pot, "Red").click();
  await expect.poll(title).toBe("Delete");
});

test("what is glued to what is read and changed in a matrix", async () => {
  const pot = await scene(SCENE);
  const matrix = pot.page.locator("pasu-glue-matrix");
  await matrix.locator("summary").click();
  const field = (name: string) => matrix.getByRole("button", { name, exact: true });
  expect(await field("Blue and Green").getAttribute("aria-pressed")).toBe("true");
  expect(await field("Red and Blue").getAttribute("aria-pressed")).toBe("false");
  expect(await findings(pot)).toEqual([]);
  await field("Red and Blue").click();
  await expect.poll(() => field("Green and Red").getAttribute("aria-pressed")).toBe("true");
  await field("Blue and Red").click();
  await expect.poll(objects.bind(null, pot)).toHaveLength(3);
  expect(await field("Green and Red").getAttribute("aria-pressed")).toBe("true");
  expect(await field("Blue and Green").getAttribute("aria-pressed")).toBe("false");
  await pot.undo();
  await pot.undo();
  await row(pot, "Red").click();
  await row(pot, "Blue").click({ modifiers: ["Control"] });
  await pot.button("Glue together").click();
  await expect.poll(() => objects(pot)).toEqual([]);
  await pot.button("Separate").click();
  await expect.poll(async () => new Set(await objects(pot)).size).toBe(3);
});

test("a handle is set into the wall of a mug: its ends come into the clay, and it is glued", async () => {
  const wall = { thickness: 0.4, base: 0.5 };
  const ring = (r: number, z: number) => ({ r: { mean: r }, z: { mean: z } });
  const mug = { kind: "rings", rings: [ring(3, 0), ring(3, 6)].map((each, u) => ({ u, ...each })) };
  const parts = [
    { name: "Mug", shape: mug, wall },
    { name: "Bar", object: 1, shape: { kind: "octant", exponents: [20, 20, 20] }, place: { shift: [6, -0.5, 2] } },
    { name: "Lump", object: 2, shape: { kind: "octant", exponents: [20, 20, 20] }, place: { shift: [-8, 30, 2] } },
  ];
  const pot = await scene({ ...SCENE, parts });
  const before = await standing(pot);
  await row(pot, "Bar").click();
  await row(pot, "Mug").click({ modifiers: ["Control"] });
  await open(pot);
  const push = arrange(pot).locator("[data-push=sideways]");
  await push.focus();
  await pot.page.keyboard.press("Enter");
  await expect.poll(async () => (await shifts(pot))[1]?.[0]).toBeLessThan(3);
  expect(await push.evaluate((button) => button.matches(":focus"))).toBe(true);
  expect((await shifts(pot))[1]?.[0]).toBeGreaterThan(2.6);
  expect((await shifts(pot))[1]?.slice(1)).toEqual([-0.5, 2]);
  expect(await objects(pot)).toEqual(["Object 1", "Object 1", "Object 2"]);
  await pot.page.locator("pasu-constraints").getByText("No two objects run into each other, and").waitFor();
  expect(await findings(pot)).toEqual([]);
  // One step. Again it finds the same place.
  const set = await standing(pot);
  await push.click();
  await expect.poll(() => push.isEnabled()).toBe(true);
  expect(await standing(pot)).toEqual(set);
  await pot.undo();
  await expect.poll(() => standing(pot)).toEqual(before);
  // Upwards nothing is met.
  await row(pot, "Lump").click();
  await row(pot, "Mug").click({ modifiers: ["Control"] });
  await arrange(pot).locator("[data-push=upright]").click();
  const nothing = arrange(pot).getByText("Nothing is met that way.");
  await nothing.waitFor();
  expect(await standing(pot)).toEqual(before);
  // What was done afterwards it does not speak of.
  await press(pot, "Left");
  await nothing.waitFor({ state: "detached" });
});

test("where parts stand is told beside their shape and what is made of them, and arranged beside their shape alone", async () => {
  const pot = await scene(SCENE);
  const { page } = pot;
  const kept = page.locator("pasu-constraints");
  await open(pot);
  const seen = async () => [await kept.isVisible(), await arrange(pot).isVisible()];
  expect(await seen()).toEqual([true, true]);
  for (const [tab, wanted] of [
    ["Look", [false, false]],
    ["Wall", [true, false]],
    ["Measures", [true, false]],
    ["Equation", [false, false]],
    ["Shape", [true, true]],
  ] as const) {
    await pot.tab(tab);
    expect(await seen()).toEqual(wanted);
    expect(await rows(pot).count()).toBe(3);
  }
  // It is as it was left.
  expect(await arrange(pot).getByRole("button", { name: "Make the ring" }).isVisible()).toBe(true);
});

test("how many triangles are told of glued parts is told as they are joined", async () => {
  const pot = await scene({ pasu: 1, parts: [block("Red", [0, 0, 0]), block("Blue", [1, 1, 1])] } as typeof SCENE);
  await pot.command("Export");
  const dialog = pot.page.locator("pasu-export");
  const triangles = async () => {
    await dialog.getByText("The mesh is closed").waitFor();
    return Number(
      (await dialog.locator("dt", { hasText: "Triangles" }).locator("+ dd").innerText()).replace(/\D/g, ""),
    );
  };
  const apart = await triangles();
  await dialog.getByLabel("Join glued parts into one solid").check();
  await expect.poll(triangles).not.toBe(apart);
  const together = await triangles();
  expect(together).toBeGreaterThan(apart / 4);
  expect(await findings(pot)).toEqual([]);
});

test("of parts that cannot be joined the check says so, and no file is offered until they are left apart", async () => {
  const corner = (name: string, scale: readonly number[]) => ({ ...block(name, [0, 0, 0]), place: { scale } });
  const across = { pasu: 1, parts: [corner("Cup", [2, 2, 2]), corner("Saucer", [-2, -2, 2])] };
  const pot = await scene(across);
  await pot.command("Export");
  const dialog = pot.page.locator("pasu-export");
  await dialog.getByLabel("Tolerance").fill("0.5");
  const save = dialog.getByRole("button", { name: /^Save/ });
  await expect.poll(() => save.isEnabled()).toBe(true);
  const join = dialog.getByLabel("Join glued parts into one solid");
  await join.check();
  await dialog.getByText(/cannot be joined with .?Cup.? into one solid/).waitFor();
  await dialog.locator(".brief", { hasText: "Not as it is" }).waitFor();
  expect(await save.isEnabled()).toBe(false);
  await join.uncheck();
  await expect.poll(() => save.isEnabled()).toBe(true);
});

test("one part alone is put on the table by no mirror", async () => {
  const pot = await scene(SCENE);
  await open(pot);
  const mirror = arrange(pot).getByRole("group", { name: "Mirror" });
  await mirror.getByRole("button", { name: "Left to right" }).waitFor();
  expect(await mirror.getByRole("button").allInnerTexts()).toEqual(["Left to right", "Front to back", "Top to bottom"]);
  const table = arrange(pot).getByRole("button", { name: "On the table" });
  const [above, below] = [await table.boundingBox(), await mirror.boundingBox()];
  expect(above?.y).toBeLessThan(below?.y ?? 0);
});
