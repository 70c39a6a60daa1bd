// A blend: its two sections in the panel.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { stagePicture } from "../support/sight.ts";
import { stay } from "../support/stay.ts";
import { CLEAR } from "../support/visit.ts";
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
  await pot.type("Half width, lower", "6 cm");
  const wide = await pot.fingerprintOtherThan(plain);
  await pot.type("Turn, lower", "30");
  const turned = await pot.fingerprintOtherThan(wide);
  // What is turned is an outline now, and as wide as it was.
  expect(await lower.locator("select").inputValue()).toBe("outline");
  expect(await pot.page.getByRole("spinbutton", { name: "Half width, lower" }).inputValue()).toBe("6");
  await pot.type("How many, lower", "6");
  await pot.type("Petals, lower", "15");
  const petals = await pot.fingerprintOtherThan(turned);
  await pot.type("Corners, lower", "50");
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

test("a count is typed digit by digit, though 1 there cannot be", async () => {
  const { pot, plain } = await opened();
  await pot.type("Petals, lower", "15");
  const petals = await pot.fingerprintOtherThan(plain);
  const count = pot.field("How many, lower");
  await count.click();
  await pot.page.keyboard.type("12");
  expect(await count.inputValue()).toBe("12");
  await pot.page.keyboard.press("Enter");
  const dozen = await pot.fingerprintOtherThan(petals);
  // What cannot be stands there beside what is said of it, and nothing else is taken in its place.
  await pot.page.keyboard.press("Control+a");
  await pot.page.keyboard.type("25");
  await pot.page.keyboard.press("Tab");
  expect(await count.inputValue()).toBe("25");
  await pot.page.getByText("Type a whole number from 3 to 24.").waitFor();
  await pot.shows(dozen);
  await pot.undo();
  await pot.shows(petals);
  expect(await count.inputValue()).not.toBe("25");
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
  await pot.type("Weight round", "0.5");
  await expect.poll(() => pot.address()).not.toBe(finer);
  await pot.shows(box);
  await pot.page.getByRole("radio", { name: "Collocation" }).check();
  await pot.page.getByRole("spinbutton", { name: "Terms, along w" }).waitFor();
  await pot.button("Compare the methods").click();
  const table = pot.page.getByRole("table", { name: "Compare the methods" });
  await table.waitFor();
  expect(await table.getByRole("columnheader").allInnerTexts()).toEqual(["Exact", "Modal", "Collocation"]);
  expect(await table.getByRole("row").count()).toBe(7);
  expect(await findings(pot)).toEqual([]);
  // It says when it is of what was before.
  await pot.type("Weight round", "0.7");
  await pot.button("Compare again").click();
  await pot.button("Compare again").waitFor({ state: "detached" });
});

test("a round and a square section that fold through each other are told at once, and agree by a button", async () => {
  const { pot, plain } = await opened();
  const cards = pot.page.locator("pasu-blend-cards");
  const told = cards.getByText("This solid folds through itself");
  await cards.waitFor();
  expect(await told.count()).toBe(0);
  await pot.page.getByRole("combobox", { name: "Form, Upper section" }).selectOption("rectangle");
  const folded = await pot.fingerprintOtherThan(plain);
  await told.waitFor();
  expect(await findings(pot)).toEqual([]);
  await pot.button("Lay the disc over a square").click();
  await pot.fingerprintOtherThan(folded);
  await told.waitFor({ state: "detached" });
  const forms = await cards
    .locator("select")
    .evaluateAll((all) => all.map((each) => (each as HTMLSelectElement).value));
  expect(forms).toEqual(["rectangle-reversed", "disc-in-square"]);
  await pot.undo();
  await pot.shows(folded);
  await told.waitFor();
});

test("sines that do not see the petals are told at once, and see them by a button", async () => {
  const { pot, plain } = await opened();
  await pot.type("Turn, lower", "30");
  const turned = await pot.fingerprintOtherThan(plain);
  await pot.type("How many, lower", "6");
  await pot.type("Petals, lower", "15");
  await pot.fingerprintOtherThan(turned);
  await pot.page.getByText("How it is solved").click();
  const told = pot.page.getByText(/along v cannot see them/);
  await pot.page.getByRole("radio", { name: "Modal" }).check();
  await told.waitFor();
  expect(await findings(pot)).toEqual([]);
  await pot.button(/^Take \d+ terms along v$/).click();
  await told.waitFor({ state: "detached" });
  await pot.undo();
  await told.waitFor();
  await pot.button("Solve it exactly").click();
  await told.waitFor({ state: "detached" });
  expect(await pot.page.getByRole("radio", { name: "Exact" }).isChecked()).toBe(true);
});

test("everything is from the catalogue", async () => {
  const pot = await here.enter({ link: PSEUDO });
  const first = await pot.fingerprint();
  await pot.dropFile("oval.json", OVAL);
  await pot.fingerprintOtherThan(first);
  await pot.page.locator("pasu-blend-cards li").first().waitFor();
  await pot.page.locator("pasu-blend-solving summary").click();
  expect(await unmarked(pot)).toEqual([]);
  await pot.page.locator("pasu-blend-solving .compare").click();
  await pot.page.locator("pasu-blend-methods table").waitFor();
  const words = await pot.page.locator("pasu-blend-methods :is(th, caption, .about)").allInnerTexts();
  expect(words.filter((text) => !/^⟦.*⟧$/.test(text.trim()))).toEqual([]);
  const within = pot.page.locator("pasu-blend-inside");
  await within.locator("summary").click();
  await within.locator("button").first().click();
  await within.locator(".ramp").waitFor();
  expect(await unmarked(pot)).toEqual([]);
  await within.locator("input[type=radio]").nth(3).check({ force: true });
  await expect.poll(() => within.locator(".ramp").count()).toBe(0);
  expect(await unmarked(pot)).toEqual([]);
});

test("one looks into a solid by three sliders, and closes it again", async () => {
  const pot = await here.enter(CLEAR);
  const first = await pot.fingerprint();
  await pot.dropFile("oval.json", OVAL);
  await pot.fingerprintOtherThan(first);
  const { page } = pot;
  const within = page.locator("pasu-blend-inside");
  const legend = within.locator(".legend");
  const skin = await stagePicture(pot);
  // By keys alone.
  await within.locator("summary").press("Enter");
  await pot.button("Look inside").press("Enter");
  await expect.poll(() => legend.innerText()).toMatch(/On what is shown: 0 to \d+/);
  expect(await findings(pot)).toEqual([]);
  const half = await stagePicture(pot);
  expect(half.equals(skin)).toBe(false);
  await pot.type("v, round the middle", "0.75");
  await expect.poll(async () => (await stagePicture(pot)).equals(half)).toBe(false);
  const quarter = await stagePicture(pot);
  await pot.type("v, round the middle", "7");
  expect(await within.getByText("From 0 to 1.").count()).toBe(1);
  await pot.type("v, round the middle", "0.75");
  await page.getByRole("radio", { name: "Three surfaces" }).check();
  await expect.poll(async () => (await stagePicture(pot)).equals(quarter)).toBe(false);
  await page.getByRole("radio", { name: "Residual" }).check();
  await expect.poll(() => legend.innerText()).toMatch(/The largest of 1728 samples is|The equation holds everywhere/);
  const before = await stagePicture(pot);
  // It follows the design.
  await pot.type("Half width, lower", "6 cm");
  await expect.poll(async () => (await stagePicture(pot)).equals(before)).toBe(false);
  await pot.undo();
  await pot.button("Look inside").press("Enter");
  await page.locator("pasu-inside-layer").waitFor({ state: "detached" });
  await expect.poll(async () => (await stagePicture(pot)).equals(skin)).toBe(true);
});

test("a new blend is two pictures of sections, and a pot of the gallery opens with its wall", async () => {
  const pot = await here.enter();
  const first = await pot.fingerprint();
  await pot.command("New");
  await pot.page.getByText("From one section into another").click();
  await pot.page.getByRole("group", { name: "At the foot" }).getByRole("radio", { name: "Star" }).check();
  await pot.page.getByRole("group", { name: "At the rim" }).getByRole("radio", { name: "Oval" }).check();
  expect(await findings(pot)).toEqual([]);
  await pot.button("Begin with star to oval").click();
  const begun = await pot.fingerprintOtherThan(first);
  await pot.page.locator("pasu-new").waitFor({ state: "detached" });
  const lower = pot.page.locator("pasu-blend-cards li[data-end=start]");
  await lower.waitFor();
  expect(await pot.page.getByRole("spinbutton", { name: "How many, lower" }).inputValue()).toBe("5");
  await pot.undo();
  await pot.shows(first);
  await pot.command("Gallery");
  await pot.page.locator('pasu-gallery button[data-exhibit="own-twisted-square"]').click();
  expect(await pot.fingerprintOtherThan(first)).not.toBe(begun);
  await expect.poll(() => pot.page.getByRole("spinbutton", { name: "Turn, upper" }).inputValue()).toBe("75");
});

test("a section is drawn in one stroke, or taken from a file, and says how far it is off", async () => {
  const { pot, plain } = await opened();
  const { page } = pot;
  await pot.button("Draw it…, Upper section").click();
  const sheet = page.locator("pasu-section-sheet svg");
  const { x, y, width } = (await sheet.boundingBox()) ?? { x: 0, y: 0, width: 0 };
  const at = (turn: number): [number, number] => {
    const reach = width * (0.3 + 0.05 * Math.cos(6 * Math.PI * turn));
    return [x + width / 2 + reach * Math.sin(2 * Math.PI * turn), y + width / 2 - reach * Math.cos(2 * Math.PI * turn)];
  };
  await page.mouse.move(...at(0));
  await page.mouse.down();
  for (let step = 1; step < 60; step += 1) await page.mouse.move(...at(step / 60));
  await page.mouse.up();
  const dialogue = page.locator("pasu-section-dialog");
  await dialogue.getByText(/^\d+ waves, 0\.0\d+ cm from the line at most\.$/).waitFor();
  expect(await findings(pot)).toEqual([]);
  await pot.button("Use it").click();
  const drawn = await pot.fingerprintOtherThan(plain);
  expect(await page.locator("pasu-blend-cards li[data-end=end] select").inputValue()).toBe("outline");
  // It stands as high as it did, and is about as large.
  expect(await page.getByRole("spinbutton", { name: "Height, upper" }).inputValue()).toBe("12");
  await pot.button("Draw it…, Upper section").click();
  const chooser = page.waitForEvent("filechooser");
  await pot.button("SVG file…").click();
  const text = '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0h60v40h-60z"/></svg>';
  await (await chooser).setFiles({ name: "box.svg", mimeType: "image/svg+xml", buffer: Buffer.from(text) });
  await dialogue.getByText(/waves, .* from the line at most/).waitFor();
  await pot.button("Use it").click();
  await pot.fingerprintOtherThan(drawn);
  await pot.undo();
  await pot.shows(drawn);
  await pot.undo();
  await pot.shows(plain);
});

test("both sections are pulled on the stage, by the pointer and by keys", async () => {
  const { pot, plain } = await opened();
  const { page } = pot;
  await pot.button("Pull").click();
  const handle = (name: string) => page.locator(`pasu-section-handles [data-grip="${name}"]`);
  await handle("end height").waitFor();
  expect(await findings(pot)).toEqual([]);
  const drag = async (name: string, dx: number, dy: number) => {
    const box = await handle(name).boundingBox();
    const [x, y] = [(box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + dx, y + dy, { steps: 4 });
    await page.mouse.up();
  };
  const number = async (name: string) => {
    const shown = await page.getByRole("spinbutton", { name }).inputValue();
    return Number(shown.replace("\u2212", "-"));
  };
  await drag("end height", 0, -30);
  const tall = await pot.fingerprintOtherThan(plain);
  expect(await number("Height, upper")).toBeGreaterThan(12.5);
  await drag("start tangent", -20, 10);
  const leant = await pot.fingerprintOtherThan(tall);
  expect(await number("Flare, lower")).not.toBe(0.5);
  // A drag is one step.
  await pot.undo();
  await pot.shows(tall);
  await handle("end width").focus();
  await page.keyboard.press("Shift+ArrowRight");
  await pot.fingerprintOtherThan(tall);
  expect(await number("Half width, upper")).toBeGreaterThan(3);
  expect(await handle("end width").getAttribute("aria-label")).toMatch(/^Half width, Upper section: 3\.\d+ /);
  await handle("start turn").focus();
  await page.keyboard.press("Shift+ArrowLeft");
  await expect.poll(() => number("Turn, lower")).toBe(-10);
  await pot.undo();
  await pot.undo();
  await pot.shows(tall);
  expect(leant).not.toBe(tall);
  await pot.undo();
  await pot.shows(plain);
});

test("the inside of a solid is saved as cells", async () => {
  const { pot } = await opened();
  await pot.command("Export");
  // By a key: the verdict that comes meanwhile moves what lies below it from under a pointer.
  await pot.page.locator("pasu-export-cells summary").press("Enter");
  const told = pot.page.locator("pasu-export-cells .told");
  await expect
    .poll(() => told.innerText(), { timeout: 60_000 })
    .toMatch(/^[\d,]+ cells, the least scaled Jacobian is 0\.\d+\.$/);
  const before = await told.innerText();
  expect(await findings(pot)).toEqual([]);
  await pot.type("Cells, along w", "3");
  await expect.poll(() => told.innerText(), { timeout: 60_000 }).toMatch(/^\d+ cells/);
  expect(await told.innerText()).not.toBe(before);
  const { name, bytes } = await pot.download("Save Gmsh (.msh)");
  expect(name).toMatch(/\.msh$/);
  expect(bytes.subarray(0, 11).toString()).toBe("$MeshFormat");
});

test("a blend is told to be a solid, and is offered a wall between closed sections alone", async () => {
  const pot = await here.enter();
  const open = async (form: object) => {
    const before = await pot.fingerprint();
    const shape = {
      kind: "blend",
      start: { form: "disc", radius: [4, 4], z: 0, taper: 0.2, dz: 6 },
      end: { radius: [5, 5], z: 8, taper: 0.2, dz: 6, ...form },
    };
    await pot.dropFile("blend.json", JSON.stringify({ pasu: 1, parts: [{ shape }] }));
    await pot.fingerprintOtherThan(before);
  };
  await open({ form: "rectangle" });
  await pot.tab("Wall");
  await pot.page.getByText("A wall goes round between two closed sections").waitFor();
  expect(await pot.button("Make it a pot").count()).toBe(0);
  await pot.tab("Measures");
  await pot.page.getByText("It goes round a body: a solid as it is").waitFor();
  await pot.tab("Wall");
  await open({ form: "disc" });
  await pot.page.getByText("With a wall it becomes an open pot").waitFor();
  await pot.button("Make it a pot").click();
  await pot.page.getByText(/^Holds .* to the brim/).waitFor();
});
