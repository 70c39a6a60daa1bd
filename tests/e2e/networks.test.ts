// A network of patches: its points on the stage, what is built with it, and what pushes it.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { fineWall } from "../support/drag.ts";
import { countDrawn, drawn } from "../support/drawn.ts";
import { overhang, unreachable } from "../support/reach.ts";
import { sheet } from "../support/sheet.ts";
import { atRest } from "../support/sight.ts";
import { stay } from "../support/stay.ts";
import { PHONE, type Visit } from "../support/visit.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();

/** Eight points: a leaf of 12 by 12. */
const LEAF = JSON.stringify({
  pasu: 1,
  parts: [
    {
      shape: {
        kind: "vertex-frame",
        vertices: [
          [-6, -6, 0],
          [0, -7, 3],
          [6, -6, 0],
          [7, 0, -2],
          [6, 6, 0],
          [0, 7, 3],
          [-6, 6, 0],
          [-7, 0, -2],
        ],
        patches: [{ frame: [0, 1, 2, 3, 4, 5, 6, 7] }],
      },
    },
  ],
});

async function opened(options: Parameters<typeof here.enter>[0] = {}) {
  const pot = await here.enter(options);
  const first = await pot.fingerprint();
  await pot.dropFile("leaf.json", LEAF);
  const plain = await pot.fingerprintOtherThan(first);
  await pot.page.locator("pasu-network-panel").waitFor();
  return { pot, plain };
}

test("an open network gets a thickness, is a body that is exported, and says where it cannot have one", async () => {
  const { pot, plain } = await opened();
  await pot.tab("Wall");
  await pot.button("Give it a thickness").click();
  const told = pot.page.getByText("It has a thickness everywhere");
  await told.waitFor();
  // A base, a ring and a rim are of pots.
  const panel = pot.page.locator("pasu-wall");
  expect(await panel.getByRole("spinbutton").evaluateAll((all) => all.map((each) => each.ariaLabel))).toHaveLength(1);
  expect(await panel.getByRole("checkbox").count()).toBe(0);
  expect(await panel.locator("pasu-number #help").innerText()).not.toContain("thinned");
  expect(await findings(pot)).toEqual([]);
  // The stage shows it: the other side and the rims beside the network.
  await fineWall(pot);
  expect(await wallOnStage(pot)).toEqual({ faces: 2, sides: ["inside"] });
  await pot.tab("Measures");
  await pot.page.getByText("The mesh is closed").waitFor();
  await pot.page.getByText("no foot and no rim, between which it would be found how much it holds").first().waitFor();
  await pot.tab("Wall");
  // A leaf that is bent is turned over by a wall thicker than it is wide.
  await pot.type("Thickness", "40");
  await pot.page.locator("pasu-wall .problem").first().waitFor();
  await pot.undo();
  await told.waitFor();
  await pot.undo();
  await pot.button("Give it a thickness").waitFor();
  await pot.shows(plain);
});

/** What the stage draws besides the network itself. */
async function wallOnStage(pot: Visit): Promise<unknown> {
  return await pot.page.evaluate(() => {
    const { designer } = document.querySelector("pasu-app") as unknown as {
      designer: { made: { solid: { value: { groups: Uint32Array; sides: unknown[] } | null } } };
    };
    const { value } = designer.made.solid;
    return value && { faces: value.groups.length / 3, sides: value.sides };
  });
}

test("the thickness follows while a point is dragged", async () => {
  const { pot } = await opened();
  await pot.tab("Wall");
  await pot.button("Give it a thickness").click();
  await fineWall(pot);
  await pot.tab("Shape");
  await points(pot);
  const thick = await pot.fingerprint();
  const [x, y] = await middle(pot, "vertex 2");
  await pot.page.mouse.move(x, y);
  await pot.page.mouse.down();
  await pot.page.mouse.move(x + 20, y - 30, { steps: 6 });
  // While the hand still holds it: the wall of what is held, and not that of before.
  await pot.page.locator('pasu-stage[data-wall="quick"]').waitFor({ state: "attached" });
  expect(await wallOnStage(pot)).toEqual({ faces: 2, sides: ["inside"] });
  await pot.page.mouse.up();
  await pot.fingerprintOtherThan(thick);
  await fineWall(pot);
});

test("what goes round a body is offered no thickness, and one that it has is told and taken away", async () => {
  const { pot, plain } = await openCan();
  await pot.tab("Wall");
  await pot.button("Give it a thickness").waitFor();
  await pot.tab("Shape");
  await pot.button("All").click();
  await pot.button("Bridge").click();
  const closed = await pot.fingerprintOtherThan(plain);
  await pot.tab("Wall");
  await pot.page.getByText("It goes round a body").waitFor();
  expect(await pot.button("Give it a thickness").count()).toBe(0);
  // Closed only after it had got a wall.
  await pot.undo();
  await pot.shows(plain);
  await pot.button("Give it a thickness").click();
  await pot.page.getByText("It has a thickness everywhere").waitFor();
  await pot.tab("Shape");
  await pot.button("All").click();
  await pot.button("Bridge").click();
  await pot.fingerprintOtherThan(plain);
  await pot.tab("Wall");
  await pot.page.getByText("It has a wall all the same").waitFor();
  expect(await findings(pot)).toEqual([]);
  await pot.button("Remove the wall").click();
  await pot.page.getByText("It has a wall all the same").waitFor({ state: "detached" });
  await pot.shows(closed);
});

test("the thickness of a network is told from the catalogue", async () => {
  const pot = await here.enter({ link: PSEUDO });
  const first = await pot.fingerprint();
  await pot.dropFile("leaf.json", LEAF);
  await pot.fingerprintOtherThan(first);
  await pot.page.locator("#tab-wall").click();
  await pot.page.locator("pasu-wall button.primary").click();
  await pot.page.locator("pasu-wall .holds:not(:has(.wait))").waitFor();
  expect(await unmarked(pot)).toEqual([]);
});

const item = (pot: Visit, name: string) => pot.page.locator(`pasu-network-handles [data-item="${name}"]`);

async function middle(pot: Visit, name: string): Promise<readonly [number, number]> {
  const box = await item(pot, name).boundingBox();
  return [(box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2];
}

async function drag(pot: Visit, name: string, dx: number, dy: number): Promise<void> {
  const [x, y] = await middle(pot, name);
  await pot.page.mouse.move(x, y);
  await pot.page.mouse.down();
  await pot.page.mouse.move(x + dx, y + dy, { steps: 4 });
  await pot.page.mouse.up();
}

async function points(pot: Visit): Promise<void> {
  await pot.button("Points on the stage").click();
  await item(pot, "vertex 0").waitFor();
}

const number = async (pot: Visit, name: string) =>
  Number((await pot.page.getByRole("spinbutton", { name, exact: true }).inputValue()).replace("\u2212", "-"));

test("points are dragged by the mouse, along axes too, and a drag is one step", async () => {
  const { pot, plain } = await opened();
  await points(pot);
  expect(await findings(pot)).toEqual([]);
  await drag(pot, "vertex 2", 30, -40);
  const dragged = await pot.fingerprintOtherThan(plain);
  expect(await item(pot, "vertex 2").getAttribute("aria-pressed")).toBe("true");
  await pot.undo();
  await pot.shows(plain);
  await pot.redo();
  await pot.shows(dragged);
  await pot.page.getByRole("radio", { name: "z", exact: true }).check();
  const [x, y] = [await number(pot, "x"), await number(pot, "y")];
  await drag(pot, "vertex 2", 0, -40);
  await pot.fingerprintOtherThan(dragged);
  expect([await number(pot, "x"), await number(pot, "y")]).toEqual([x, y]);
  // Typed to a place.
  await pot.type("z", "9");
  expect(await item(pot, "vertex 2").getAttribute("aria-label")).toMatch(/, 9 cm$/);
});

test("a drag that ends where it began is no step, and neither it nor one that is given up takes what can be redone", async () => {
  const { pot, plain } = await opened();
  const { page } = pot;
  await points(pot);
  await drag(pot, "vertex 2", 30, -40);
  const dragged = await pot.fingerprintOtherThan(plain);
  await pot.undo();
  await pot.shows(plain);
  const [x, y] = await middle(pot, "vertex 4");
  const away = async () => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 30, y + 20, { steps: 3 });
    await expect.poll(() => number(pot, "x")).not.toBe(6);
  };
  await away();
  await page.mouse.move(x, y, { steps: 3 });
  await page.mouse.up();
  await pot.shows(plain);
  await away();
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await pot.shows(plain);
  await pot.redo();
  await pot.shows(dragged);
  await pot.undo();
  await pot.shows(plain);
  // The one step before is the network that was opened.
  await pot.undo();
  await page.locator("pasu-network-panel").waitFor({ state: "detached" });
});

test("keys take a crest through the surface to its other side, and a patch that is full of forces says so", async () => {
  const { pot, plain } = await opened();
  const { page } = pot;
  await points(pot);
  await pot.type("Patch", "1");
  await pot.button("Add a force").click();
  await pot.fingerprintOtherThan(plain);
  await item(pot, "crest 0 0").focus();
  const heights = [await number(pot, "Height, force 1")];
  for (let press = 0; press < 4; press += 1) {
    await page.keyboard.press("Shift+ArrowDown");
    await expect.poll(() => number(pot, "Height, force 1")).not.toBe(heights.at(-1));
    heights.push(await number(pot, "Height, force 1"));
  }
  const steps = heights.slice(1).map((height, place) => height - (heights[place] ?? 0));
  for (const step of steps) expect(step).toBeCloseTo(steps[0] ?? 0, 3);
  expect(Math.sign(heights[0] ?? 0)).toBe(-Math.sign(heights.at(-1) ?? 0));
  // A force is as high as so many steps: on the way the surface lies as if there were none.
  expect(heights).toContain(0);

  const full = JSON.parse(LEAF);
  full.parts[0].shape.patches[0].forces = Array.from({ length: 64 }, (_, each) => ({ f0: [0, 0, each / 64] }));
  const before = await pot.fingerprint();
  await pot.dropFile("full.json", JSON.stringify(full));
  const all = await pot.fingerprintOtherThan(before);
  await pot.button("None").click();
  await page.getByRole("radio", { name: "draws a region" }).check();
  const [x, y] = await middle(pot, "patch 0");
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y + 20, { steps: 3 });
  await page.mouse.up();
  await page.getByText("This patch has 64 forces, and can have no more.").waitFor();
  await pot.shows(all);
});

test("where nothing can be picked it is said what to pick first, and a number is read as it was typed", async () => {
  const { pot } = await opened();
  await pot.button("Patches").click();
  await pot.page.getByText("Pick a point first.").waitFor();
  await pot.button("Ring").click();
  await pot.page.getByText("Pick the middle of an edge first.").waitFor();
  await pot.type("Point", "1");
  await pot.type("x", "1.2345");
  await expect.poll(() => number(pot, "x")).toBe(1.2345);
});

test("where nothing is picked no number stands, and one that nothing has is told", async () => {
  const { pot } = await opened();
  const [point, patch] = [pot.field("Point"), pot.field("Patch")];
  expect([await point.inputValue(), await patch.inputValue()]).toEqual(["", ""]);
  expect(await point.getAttribute("aria-valuenow")).toBeNull();
  expect(await point.getAttribute("aria-valuetext")).toBe("none");
  expect(await findings(pot)).toEqual([]);
  for (const [field, number, said] of [
    // 0 first, where the field is empty still.
    ["Point", "0", "Points have the numbers 1 to 8."],
    ["Point", "9", "Points have the numbers 1 to 8."],
    ["Point", "2.5", "Points have the numbers 1 to 8."],
    ["Patch", "-1", "Patches have the numbers 1 to 1."],
  ] as const) {
    await pot.type(field, number);
    await pot.page.getByText(said).waitFor();
    await pot.page.getByText("Nothing is picked").waitFor();
  }
  await pot.type("Point", "3");
  await pot.page.getByText("1 point and 0 patches picked.").waitFor();
  expect(await pot.page.getByText("have the numbers").count()).toBe(0);
  // By keys from where nothing is.
  await pot.button("None").click();
  await patch.press("ArrowUp");
  await pot.page.getByText("8 points and 1 patch picked.").waitFor();
  expect(await patch.inputValue()).toBe("1");
});

test("digits on the way to a number pick nothing beside it", async () => {
  const { pot } = await openCan();
  const { page } = pot;
  const status = page.locator("pasu-network-panel .told").first();
  await pot.button("Pick several").click();
  await pot.type("Point", "7");
  await pot.field("Point").click();
  await page.keyboard.type("23");
  await page.keyboard.press("Enter");
  await expect.poll(() => status.innerText()).toMatch(/^2 points and 0 patches/);
  expect(await item(pot, "vertex 1").getAttribute("aria-pressed")).toBe("false");
  // 10 there is, 100 there is none.
  await pot.field("Point").click();
  await page.keyboard.type("100");
  await page.getByText("Points have the numbers").waitFor();
  await expect.poll(() => status.innerText()).toMatch(/^2 points and 0 patches/);
  await page.keyboard.press("Enter");
  await pot.button("None").click();
  await pot.field("Patch").click();
  await page.keyboard.type("12");
  await page.keyboard.press("Enter");
  await expect.poll(() => status.innerText()).toMatch(/^8 points and 1 patch /);
  expect(await item(pot, "patch 11").getAttribute("aria-pressed")).toBe("true");
});

test("the angle below which edges look smooth and the rule of strips are numbers of the panel", async () => {
  const { pot } = await opened();
  const { page } = pot;
  const shape = () =>
    page.evaluate(() => {
      const { designer } = document.querySelector("pasu-app") as unknown as {
        designer: { store: { design: { parts: { shape: { crease?: number; rule?: unknown } }[] } } };
      };
      const { crease, rule } = designer.store.design.parts[0]?.shape ?? {};
      return { crease, rule };
    });
  const { rule: before } = await shape();
  const panel = page.locator("pasu-network-whole");
  await panel.getByText("All patches").first().click();
  const crease = panel.getByRole("spinbutton", { name: "Smooth up to" });
  expect(await crease.inputValue()).toBe("28.6479");
  const type = async (field: typeof crease, text: string) => {
    await field.fill(text);
    await field.press("Enter");
  };
  await type(crease, "90");
  await expect.poll(async () => (await shape()).crease).toBe(1.57079632679);
  await type(crease, "200");
  await panel.getByText("An angle from 0° to 180°.").waitFor();
  expect((await shape()).crease).toBe(1.57079632679);
  await type(crease, "0");
  await expect.poll(async () => (await shape()).crease).toBe(0);
  await page.keyboard.press("Tab");
  await pot.undo();
  await pot.undo();
  await expect.poll(() => crease.inputValue()).toBe("28.6479");

  await panel.getByRole("radio", { name: "its first patch" }).check();
  await expect.poll(async () => (await shape()).rule).toEqual({ seed: 0 });
  const seed = panel.getByRole("spinbutton", { name: "Counted from patch" });
  await type(seed, "2");
  await panel.getByText("Patches have the numbers 1 to 1.").waitFor();
  expect(await findings(pot)).toEqual([]);
  await type(seed, "1");
  expect(await panel.getByText("Patches have the numbers").count()).toBe(0);
  await panel.getByRole("radio", { name: "all its patches" }).check();
  await expect.poll(async () => (await shape()).rule).toBe("global");
  await pot.undo();
  await pot.undo();
  await expect.poll(async () => (await shape()).rule).toEqual(before);
});

test("a place is typed digit by digit through the mirror, and what stands in it says that it stays", async () => {
  const { pot, plain } = await opened();
  const { page } = pot;
  await page.getByLabel("Mirror").selectOption("x");
  await pot.type("Point", "8");
  const x = page.locator("pasu-network-place").getByRole("spinbutton", { name: "x", exact: true });
  const typed = async (text: string) => {
    await x.click();
    await page.keyboard.type(text);
    await page.keyboard.press("Enter");
  };
  // On the way to it stands a 0, where it would meet its image.
  await typed("-0.5");
  await pot.fingerprintOtherThan(plain);
  await expect.poll(() => x.inputValue()).toBe("\u22120.5");
  await pot.type("Point", "4");
  await expect.poll(() => x.inputValue()).toBe("0.5");
  await pot.undo();
  await pot.shows(plain);
  await pot.type("Point", "2");
  await typed("3");
  await page.getByText("What stands in the mirror stays there.").waitFor();
  await page.keyboard.press("Tab");
  expect(await x.inputValue()).toBe("0");
  await pot.shows(plain);
  // Nor is there a step to undo: what was undone before can still be redone.
  await pot.redo();
  await pot.fingerprintOtherThan(plain);
});

test("the middle of what goes round an axis is on it, whatever rounding leaves", async () => {
  const { pot } = await openCan();
  await pot.button("All").click();
  const place = pot.page.locator("pasu-network-place").getByRole("spinbutton");
  expect(await place.evaluateAll((all) => all.map((each) => each.getAttribute("aria-valuenow")))).toEqual([
    "0",
    "0",
    "5",
  ]);
});

test("arrow keys keep to the grid", async () => {
  const { pot, plain } = await opened();
  const { page } = pot;
  await points(pot);
  await page.getByLabel("To a grid of").check();
  await item(pot, "vertex 1").focus();
  await page.keyboard.press("ArrowRight");
  const once = await pot.fingerprintOtherThan(plain);
  await page.keyboard.press("ArrowUp");
  await pot.fingerprintOtherThan(once);
  const [x, y, z] = [await number(pot, "x"), await number(pot, "y"), await number(pot, "z")];
  expect([x, y, z].map((each) => (2 * each) % 1)).toEqual([0, 0, 0].map((zero) => expect.closeTo(zero, 9)));
  expect([x, y, z]).not.toEqual([0, -7, 3]);
});

test("crests of several patches are told apart, and what is no choice is not pressed", async () => {
  const { pot } = await openCan();
  for (const patch of ["8", "16"]) {
    await pot.type("Patch", patch);
    await pot.button("Add a force").click();
  }
  await pot.button("All").click();
  const crests = pot.page.locator('pasu-network-handles [data-item^="crest"]');
  const told = () => crests.evaluateAll((all) => all.map((each) => each.getAttribute("aria-label")));
  await expect.poll(told).toEqual(["Crest of force 1, Patch 8", "Crest of force 1, Patch 16"]);
  expect(await crests.first().getAttribute("aria-pressed")).toBeNull();
  expect(await item(pot, "pivot").getAttribute("aria-pressed")).toBeNull();
});

test("a force is added to all picked patches, each pushed out by its own normal, and the focus stays when it goes", async () => {
  const { pot, plain } = await openCan();
  const { page } = pot;
  // Over against each other.
  await pot.button("Pick several").click();
  await pot.type("Patch", "7");
  await pot.type("Patch", "5");
  await page.getByText("The numbers are those of patch 7.").waitFor();
  await pot.button("Add a force").click();
  const pushed = await pot.fingerprintOtherThan(plain);
  const forces = () =>
    page.evaluate(() => {
      interface Page {
        designer: { store: { design: { parts: { shape: { patches: { forces?: { f0: number[] }[] }[] } }[] } } };
      }
      const { designer } = document.querySelector("pasu-app") as unknown as Page;
      const { patches = [] } = designer.store.design.parts[0]?.shape ?? {};
      return patches.flatMap(({ forces: all }, patch) => (all ? [{ patch, x: Math.sign(all[0]?.f0[0] ?? 0) }] : []));
    });
  const [one, other] = await forces();
  expect([one?.patch, other?.patch]).toEqual([4, 6]);
  expect([1, -1]).toContain(one?.x);
  expect(one?.x).toBe(-(other?.x ?? 0));
  await pot.type("Height, force 1", "0.75");
  await pot.fingerprintOtherThan(pushed);
  expect(await number(pot, "Height, force 1")).toBe(0.75);
  const [low, high] = await forces();
  expect(low?.x).toBe(-(high?.x ?? 0));
  await pot.button("Add a force").click();
  for (const next of ["Remove force 1", "Add a force"]) {
    await pot.button("Remove force 1").focus();
    await page.keyboard.press("Enter");
    await expect.poll(() => pot.button(next).evaluate((button) => button.matches(":focus"))).toBe(true);
  }
  await pot.shows(plain);
});

test("grids and sliders that reach nowhere are told", async () => {
  const { pot } = await opened();
  const told = pot.page.getByText("It has to be more than 0.");
  await pot.type("Grid", "-1");
  await expect.poll(() => told.count()).toBe(1);
  await pot.type("Patch", "1");
  await pot.type("Sliders reach to", "0");
  await expect.poll(() => told.count()).toBe(2);
  await pot.type("Sliders reach to", "5");
  await pot.type("Grid", "0.25");
  await expect.poll(() => told.count()).toBe(0);
});

test("the ends of a region are typed digit by digit, and one that would pass the other is told", async () => {
  const { pot, plain } = await opened();
  await pot.type("Patch", "1");
  await pot.button("Add a force").click();
  const pushed = await pot.fingerprintOtherThan(plain);
  const end = pot.field("u to, force 1");
  await end.click();
  await pot.page.keyboard.press("Control+a");
  // On the way to it stands a 0, where the region begins.
  await pot.page.keyboard.type("0.5");
  expect(await end.inputValue()).toBe("0.5");
  await pot.page.keyboard.press("Enter");
  const half = await pot.fingerprintOtherThan(pushed);
  await pot.type("u from, force 1", "0.6");
  await pot.page.getByText("The region ends at 0.5 along u: it has to begin before that.").waitFor();
  expect(await pot.field("u from, force 1").inputValue()).toBe("0.6");
  await pot.shows(half);
  await pot.type("v to, force 1", "-1");
  expect(await pot.field("u from, force 1").inputValue()).toBe("0");
  await pot.page.getByText("The region begins at 0 along v: it has to end after that.").waitFor();
  await pot.type("u from, force 1", "0.25");
  await pot.fingerprintOtherThan(half);
  expect(await pot.page.getByText("The region").count()).toBe(0);
  await pot.undo();
  await pot.undo();
  await pot.shows(pushed);
});

test("everything is from the catalogue", async () => {
  const pot = await here.enter({ link: PSEUDO });
  const first = await pot.fingerprint();
  await pot.dropFile("leaf.json", LEAF);
  await pot.fingerprintOtherThan(first);
  await pot.page.locator("pasu-network-panel [data-pick=all]").click();
  await pot.page.locator("pasu-network-patch .acts button").first().click();
  await pot.page.locator("pasu-network-patch .force").waitFor();
  expect(await unmarked(pot)).toEqual([]);
  await pot.page.locator("pasu-network-panel [data-command=patches]").click();
  await pot.page.locator("pasu-patches .stage canvas").waitFor();
  expect(await unmarked(pot)).toEqual([]);
});

test("patches are compared over the same edges, and what cannot be says so", async () => {
  const { pot } = await opened();
  await pot.button("Patches compared…").click();
  const dialogue = pot.page.locator("pasu-patches");
  await dialogue.locator(".stage canvas").waitFor();
  expect(await findings(pot)).toEqual([]);
  await dialogue.locator(".stage").focus();
  await pot.page.keyboard.press("ArrowLeft");
  await pot.type("Height of the force", "-5");
  await pot.type("a₁, across", "3");
  expect(await dialogue.getByRole("alert").count()).toBe(0);
  const tooWide = dialogue.getByText("expected a region of the patch, up to 1");
  await pot.type("Width of its region", "1.5");
  await tooWide.waitFor();
  // An answer to what was typed before, which comes late, does not take that back.
  const shown = () =>
    dialogue.evaluate((element) => JSON.stringify((element as unknown as { shown: { design: object } }).shown.design));
  const before = await shown();
  const fields = await Promise.all(
    ["a₁, across", "Width of its region"].map((name) => pot.field(name).elementHandle()),
  );
  await pot.page.evaluate((both) => {
    for (const [at, text] of ["4", "1.6"].entries()) {
      const field = both[at] as HTMLInputElement;
      field.value = text;
      field.dispatchEvent(new InputEvent("input", { bubbles: true, composed: true }));
    }
  }, fields);
  await expect.poll(shown).not.toBe(before);
  expect(await tooWide.count()).toBe(1);
  await pot.type("Width of its region", "0.8");
  await expect.poll(() => dialogue.getByRole("alert").count()).toBe(0);
  await pot.type("a₂, along", "0");
  // A strip needs it: the solver's own words.
  await dialogue.getByText("This cannot be shown").waitFor();
  await pot.page.keyboard.press("Escape");
  await dialogue.waitFor({ state: "detached" });
});

/** A can of five rows of four patches, open at both ends: it has no handle. */
function can(): string {
  const [vertices, patches]: [number[][], object[]] = [[], []];
  const places = new Map<string, number>();
  const vertex = (place: number, level: number) => {
    const key = `${place % 8} ${level}`;
    const known = places.get(key);
    if (known !== undefined) return known;
    const angle = (Math.PI * (place - 1)) / 4;
    const point = [4 * Math.cos(angle), 4 * Math.sin(angle), level].map((value) => Number(value.toFixed(6)));
    places.set(key, vertices.push(point) - 1);
    return vertices.length - 1;
  };
  for (let row = 0; row < 5; row += 1) {
    for (let column = 0; column < 4; column += 1) {
      const at = (right: number, up: number) => vertex(2 * column + right, 2 * row + up);
      patches.push({ frame: [at(0, 0), at(1, 0), at(2, 0), at(2, 1), at(2, 2), at(1, 2), at(0, 2), at(0, 1)] });
    }
  }
  return JSON.stringify({ pasu: 1, parts: [{ shape: { kind: "vertex-frame", vertices, patches } }] });
}

/** Patches of the can that look to the front, below and above: out of these comes a handle. */
const [LOWER, UPPER] = ["patch 7", "patch 15"];

async function openCan(options: Parameters<typeof here.enter>[0] = {}) {
  const pot = await here.enter(options);
  pot.page.setDefaultTimeout(20_000);
  const first = await pot.fingerprint();
  await pot.dropFile("can.json", can());
  const plain = await pot.fingerprintOtherThan(first);
  await points(pot);
  return { pot, plain };
}

/** What a handle is when it is built: a ring on the stage for all that is picked, and more patches. */
async function told(pot: Visit): Promise<string> {
  return (await pot.page.locator("pasu-network-panel .intro p").innerText()).trim();
}

test("a mug's handle is built with the mouse", { timeout: 120_000 }, async () => {
  const { pot, plain } = await openCan();
  const { page } = pot;
  const click = async (name: string, more = false) => {
    const [x, y] = await middle(pot, name);
    if (more) await page.keyboard.down("Shift");
    await page.mouse.click(x, y);
    if (more) await page.keyboard.up("Shift");
    await expect.poll(() => item(pot, name).getAttribute("aria-pressed")).toBe("true");
  };
  await click(LOWER);
  await click(UPPER, true);
  await pot.button("Delete").click();
  const opened = await pot.fingerprintOtherThan(plain);
  expect(await told(pot)).toContain("18 patches");
  // The rims of both openings are picked, and are drawn out and joined.
  await pot.button("Extrude").click();
  await pot.button("Bridge").click();
  await expect.poll(() => told(pot)).toContain("30 patches");
  const bridged = await pot.fingerprintOtherThan(opened);
  await drag(pot, "pivot", 40, 10);
  const drawn = await pot.fingerprintOtherThan(bridged);
  await pot.undo();
  await pot.shows(bridged);
  await pot.redo();
  await pot.shows(drawn);
  expect(await findings(pot)).toEqual([]);
});

test("a mug's handle is built with the keyboard", { timeout: 120_000 }, async () => {
  const { pot, plain } = await openCan();
  const { page } = pot;
  const press = async (name: string) => {
    await page.getByRole("button", { name, exact: true }).focus();
    await page.keyboard.press("Enter");
  };
  await item(pot, LOWER).focus();
  await page.keyboard.press("Enter");
  await item(pot, UPPER).focus();
  await page.keyboard.press("Shift+Enter");
  expect(await page.locator("pasu-network-panel .told").first().innerText()).toMatch(/^16 points and 2 patches/);
  await press("Delete");
  const opened = await pot.fingerprintOtherThan(plain);
  await press("Extrude");
  await press("Bridge");
  await expect.poll(() => told(pot)).toContain("30 patches");
  const bridged = await pot.fingerprintOtherThan(opened);
  await page.getByRole("radio", { name: "y", exact: true }).focus();
  await page.keyboard.press("Space");
  const before = await number(pot, "y");
  await item(pot, "pivot").focus();
  await page.keyboard.press("Shift+ArrowRight");
  await pot.fingerprintOtherThan(bridged);
  expect(await number(pot, "y")).toBeGreaterThan(before + 0.5);
  await pot.undo();
  await pot.shows(bridged);
});

test("a mug's handle is built with a finger", { timeout: 120_000 }, async () => {
  const { pot, plain } = await openCan({ ...PHONE });
  const { page } = pot;
  const cdp = await pot.context.newCDPSession(page);
  const touch = async (name: string, dx = 0, dy = 0) => {
    const [x, y] = await middle(pot, name);
    await cdp.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }] });
    for (let step = 1; step <= 4 && (dx !== 0 || dy !== 0); step += 1) {
      const there = { x: x + (dx * step) / 4, y: y + (dy * step) / 4 };
      await cdp.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [there] });
    }
    await cdp.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  };
  const tap = (name: string) => page.getByRole("button", { name, exact: true }).tap();
  await page.evaluate(() => scrollTo(0, 0));
  await touch(UPPER);
  await expect.poll(() => item(pot, UPPER).getAttribute("aria-pressed")).toBe("true");
  await tap("Delete");
  const once = await pot.fingerprintOtherThan(plain);
  await tap("Extrude");
  const drawn = await pot.fingerprintOtherThan(once);
  // A finger has no shift: the other opening is made in its turn.
  await page.evaluate(() => scrollTo(0, 0));
  await touch(LOWER);
  await expect.poll(() => item(pot, LOWER).getAttribute("aria-pressed")).toBe("true");
  await tap("Delete");
  await tap("Extrude");
  const both = await pot.fingerprintOtherThan(drawn);
  await expect.poll(() => told(pot)).toContain("26 patches");
  await page.evaluate(() => scrollTo(0, 0));
  await touch("pivot", 20, 10);
  const moved = await pot.fingerprintOtherThan(both);
  await pot.undo();
  await pot.shows(both);
  expect(moved).not.toBe(both);
});

test("a finger picks two patches apart, and takes one of them back", { timeout: 120_000 }, async () => {
  const { pot, plain } = await openCan({ ...PHONE });
  const { page } = pot;
  const cdp = await pot.context.newCDPSession(page);
  const down = async (name: string) => {
    const [x, y] = await middle(pot, name);
    await cdp.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }] });
  };
  const up = () => cdp.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  const touch = async (name: string) => {
    await down(name);
    await up();
  };
  const picked = (name: string, is: boolean) =>
    expect.poll(() => item(pot, name).getAttribute("aria-pressed")).toBe(is ? "true" : "false");
  const tap = (name: string) => page.getByRole("button", { name, exact: true }).tap();
  const status = page.locator("pasu-network-panel .told").first();
  const toStage = () => page.evaluate(() => scrollTo(0, 0));
  await toStage();
  await touch(LOWER);
  await picked(LOWER, true);
  // A finger that rests picks beside what there is; lifted it changes nothing more.
  await down(UPPER);
  await picked(UPPER, true);
  await picked(LOWER, true);
  await up();
  expect(await status.innerText()).toMatch(/^16 points and 2 patches/);
  // Resting on one once more leaves it out.
  await down(UPPER);
  await picked(UPPER, false);
  await up();
  expect(await status.innerText()).toMatch(/^8 points and 1 patch /);
  // A tap alone picks one in place of the other, until several are asked for.
  await touch(UPPER);
  await picked(UPPER, true);
  await picked(LOWER, false);
  await tap("Pick several");
  expect(await findings(pot)).toEqual([]);
  await toStage();
  await touch(LOWER);
  await picked(LOWER, true);
  await picked(UPPER, true);
  // Which is all that a handle takes.
  await tap("Delete");
  const opened = await pot.fingerprintOtherThan(plain);
  await tap("Extrude");
  await tap("Bridge");
  await expect.poll(() => told(pot)).toContain("30 patches");
  await pot.fingerprintOtherThan(opened);
});

test("with Pick several the Enter key and numbers pick beside what there is", async () => {
  const { pot } = await opened();
  const { page } = pot;
  await points(pot);
  const status = page.locator("pasu-network-panel .told").first();
  await item(pot, "vertex 0").focus();
  await page.keyboard.press("Enter");
  await page.getByRole("button", { name: "Pick several", exact: true }).focus();
  await page.keyboard.press("Enter");
  await item(pot, "vertex 2").focus();
  await page.keyboard.press("Enter");
  await expect.poll(() => status.innerText()).toMatch(/^2 points/);
  await pot.type("Point", "5");
  await expect.poll(() => status.innerText()).toMatch(/^3 points/);
  await item(pot, "vertex 2").focus();
  await page.keyboard.press("Enter");
  await expect.poll(() => status.innerText()).toMatch(/^2 points/);
});

test("a region is drawn across patches and pulled, and its numbers follow", { timeout: 120_000 }, async () => {
  const { pot, plain } = await openCan();
  const { page } = pot;
  await page.getByRole("radio", { name: "draws a region" }).check();
  const [x, y] = await middle(pot, "patch 11");
  // A click is none, and neither is what ends beside the surface.
  await page.mouse.click(x - 18, y - 22);
  await page.getByText("A region is drawn from one of its corners to the other").waitFor();
  await page.mouse.move(x, y - 22);
  await page.mouse.down();
  await page.mouse.move(x - 20, y - 24);
  await page.mouse.move(30, 90);
  await page.mouse.up();
  await pot.shows(plain);
  await page.mouse.move(x - 18, y - 22);
  await page.mouse.down();
  await page.mouse.move(x + 24, y + 20, { steps: 5 });
  await page.mouse.up();
  const pushed = await pot.fingerprintOtherThan(plain);
  await page.locator("pasu-network-patch .force").waitFor();
  const height = await number(pot, "Height, force 1");
  expect(Math.abs(height)).toBeGreaterThan(0.05);
  // It may push either way: 0 is in the middle, for x, y and z alike.
  const strengths = page.locator("pasu-network-patch .force input[type=range]");
  const ends = await strengths.evaluateAll((all: HTMLInputElement[]) => all.map(({ min, max }) => [+min, +max]));
  expect(ends).toEqual([0, 1, 2].map(() => [-(ends[0]?.[1] ?? 0), ends[0]?.[1]]));
  await item(pot, "crest 11 0").focus();
  await page.keyboard.press("Shift+ArrowRight");
  await pot.fingerprintOtherThan(pushed);
  await expect.poll(async () => Math.abs(await number(pot, "Height, force 1"))).toBeGreaterThan(Math.abs(height) + 0.1);
  await pot.undo();
  await pot.shows(pushed);
  await pot.button("Remove force 1").click();
  await pot.shows(plain);
});

test("a vase becomes patches, no further off than is said", { timeout: 120_000 }, async () => {
  const pot = await here.enter({ link: "#1/fourth-order?r0=3&r1=2&rm=4&h1=9" });
  const vase = await pot.fingerprint();
  await pot.button("Make it patches…").focus();
  await pot.page.keyboard.press("Enter");
  await expect.poll(() => pot.page.locator("pasu-patch-card section:focus").count()).toBe(1);
  const found = pot.page.locator("pasu-patch-card .found");
  await expect.poll(() => found.innerText(), { timeout: 30_000 }).toMatch(/^No further than [\d.]+ cm from the form/);
  const off = async () => Number(/[\d.]+/.exec(await found.innerText())?.[0]);
  const coarse = await off();
  // Digit by digit: fewer than 3 there cannot be.
  await pot.field("Patches round").click();
  await pot.page.keyboard.type("24");
  await pot.page.keyboard.press("Tab");
  expect(await pot.field("Patches round").inputValue()).toBe("24");
  await pot.type("Patches from end to end", "130");
  await pot.page.getByText("It has to be a whole number from 1 to 120.").waitFor();
  // What cannot be stands beside what is said of it.
  await pot.page.keyboard.press("Tab");
  expect(await pot.field("Patches from end to end").inputValue()).toBe("130");
  await pot.type("Patches from end to end", "12");
  expect(await pot.page.getByText("It has to be a whole number").count()).toBe(0);
  await expect.poll(off).toBeLessThan(coarse);
  expect(await findings(pot)).toEqual([]);
  await pot.button("Use it").focus();
  await pot.page.keyboard.press("Enter");
  await pot.fingerprintOtherThan(vase);
  await expect.poll(() => pot.page.locator("pasu-network-panel .intro button:focus").count()).toBe(1);
  expect(await told(pot)).toContain("288 patches");
  await pot.undo();
  await pot.shows(vase);
  // Where the part stands: ten times as large, it is ten times as far off.
  const large = await pot.page.evaluate(() => {
    const { designer } = document.querySelector("pasu-app") as unknown as {
      designer: { store: { design: { parts: object[] } } };
    };
    const { design } = designer.store;
    const parts = design.parts.map((part) => ({ ...part, place: { scale: [10, -10, 2] } }));
    return JSON.stringify({ ...design, parts });
  });
  await pot.dropFile("large.json", large);
  await pot.fingerprintOtherThan(vase);
  await pot.button("Make it patches…").click();
  await expect.poll(() => found.innerText(), { timeout: 30_000 }).toMatch(/^No further than [\d.]+ cm from the form/);
  // Each is rounded up to two digits.
  const times = (await off()) / coarse;
  expect(times).toBeGreaterThan(9);
  expect(times).toBeLessThan(11.5);
});

test("a network is saved as OBJ and opened again", async () => {
  const { pot } = await opened();
  const { name, bytes } = await pot.download("Save as OBJ");
  expect(name).toMatch(/\.obj$/);
  expect(bytes.toString()).toContain("f 1 2 3 4 5 6 7 8");
  const before = await pot.fingerprint();
  const quads = "v 0 0 0\nv 4 0 0\nv 4 4 1\nv 0 4 0\nv 8 0 1\nv 8 4 2\nf 1 2 3 4\nf 2 5 6 3\n";
  const choosing = pot.page.waitForEvent("filechooser");
  await pot.button("Open OBJ quads…").click();
  await (await choosing).setFiles({ name: "roof.obj", mimeType: "model/obj", buffer: Buffer.from(quads) });
  await pot.fingerprintOtherThan(before);
  expect(await told(pot)).toContain("2 patches through 13 points");
  expect(await pot.page.title()).toBe("roof · Pasu");
  // What is none says where.
  for (const [text, said] of [
    [
      `${quads}f 1 2 3`,
      "The face in line 9 of this file has 3 corners. A network is of faces of four corners, or of eight points.",
    ],
    [`${quads}f 1 2 3 7`, "The face in line 9 of this file names the point 7, and there are 6."],
    ["v 0 0\n", "Line 1 of this file has not the three numbers of a point."],
  ] as const) {
    const again = pot.page.waitForEvent("filechooser");
    await pot.button("Open OBJ quads…").click();
    await (await again).setFiles({ name: "bad.obj", mimeType: "model/obj", buffer: Buffer.from(text) });
    await pot.page.getByText(said.slice(0, 40)).waitFor();
    // Nothing was done that a tick could stand for.
    expect(await pot.page.locator(".toast").locator("svg").count()).toBe(0);
  }
  const next = pot.page.waitForEvent("filechooser");
  await pot.button("Open OBJ quads…").click();
  await (await next).setFiles({ name: "again.obj", mimeType: "model/obj", buffer: Buffer.from(quads) });
  await expect.poll(() => pot.page.title()).toBe("again · Pasu");
  expect(await pot.page.getByText("Line 1 of this file").count()).toBe(0);
});

test("an OBJ file is in the unit of the design on the page", async () => {
  const { pot, plain } = await opened();
  const inches = await pot.page.evaluate(() => {
    const { designer } = document.querySelector("pasu-app") as unknown as { designer: { store: { design: object } } };
    return JSON.stringify({ ...designer.store.design, unit: "in" });
  });
  await pot.dropFile("inches.json", inches);
  const caption = () => pot.page.locator("pasu-stage #description").innerText();
  await expect.poll(caption).toMatch(/\d in /);
  const told = await caption();
  const { bytes } = await pot.download("Save as OBJ");
  await pot.openLink("#1/second-order?unit=in");
  await pot.fingerprintOtherThan(plain);
  await pot.dropFile("saved.obj", bytes);
  await pot.button("Open them as patches").click();
  await pot.shows(plain);
  await expect.poll(caption).toBe(told);
});

test("a network that was saved as OBJ and is dropped is opened as one, and not as a scan alone", async () => {
  const { pot, plain } = await opened();
  const { bytes } = await pot.download("Save as OBJ");
  await pot.openLink("#1/second-order");
  const vase = await pot.fingerprintOtherThan(plain);
  const offer = pot.button("Open them as patches");
  await pot.dropFile("triangles.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  await pot.page.locator("pasu-scan .trouble").waitFor();
  expect(await offer.count()).toBe(0);
  const either = pot.page.getByText("It cannot be opened as a network of patches either.");
  expect(await either.count()).toBe(0);
  // Into the dialog that is open.
  await pot.dropFile("bad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 3 7\n");
  await either.waitFor();
  expect(await either.textContent()).toContain("The face in line 6 of this file names the point 7, and there are 4.");
  await pot.dropFile("saved.obj", bytes);
  await offer.click();
  await pot.fingerprintOtherThan(vase);
  await pot.shows(plain);
  expect(await pot.page.locator("pasu-scan").count()).toBe(0);
});

test("points are picked in a box, keep to a grid and to their mirror image, and are turned and scaled", async () => {
  const { pot, plain } = await opened();
  const { page } = pot;
  pot.page.setDefaultTimeout(20_000);
  await points(pot);
  await page.locator("pasu-stage .host").press("4");
  await atRest(pot);
  // Both corners at the right, with the middle between them.
  await page.getByRole("radio", { name: "picks in a box" }).check();
  const [[left, top], [right, bottom]] = [await middle(pot, "vertex 4"), await middle(pot, "vertex 2")];
  await page.mouse.move(Math.min(left, right) - 14, Math.min(top, bottom) - 25);
  await page.mouse.down();
  await page.mouse.move(Math.max(left, right) + 60, Math.max(top, bottom) + 25, { steps: 4 });
  await page.mouse.up();
  const status = page.locator("pasu-network-panel .told").first();
  await expect.poll(() => status.innerText()).toMatch(/^3 points/);
  await page.getByRole("radio", { name: "Turn", exact: true }).check();
  await drag(pot, "vertex 2", 30, 10);
  const turned = await pot.fingerprintOtherThan(plain);
  await page.getByRole("radio", { name: "Scale", exact: true }).check();
  await drag(pot, "vertex 2", 10, 30);
  await pot.fingerprintOtherThan(turned);
  await pot.undo();
  await pot.shows(turned);
  await pot.undo();
  await pot.shows(plain);
  await page.getByRole("radio", { name: "Move", exact: true }).check();
  await page.getByLabel("Mirror").selectOption("x");
  await page.getByLabel("To a grid of").check();
  await page.getByRole("radio", { name: "turns the view" }).check();
  await pot.button("None").click();
  await drag(pot, "vertex 3", 37, 11);
  await pot.fingerprintOtherThan(plain);
  const place = async (name: string) =>
    (/: (.*)$/.exec((await item(pot, name).getAttribute("aria-label")) ?? "")?.[1] ?? "")
      .split(", ")
      .map((each) => Number.parseFloat(each.replace("\u2212", "-")));
  const [[x = 0, y = 0], [mx = 0, my = 0]] = [await place("vertex 3"), await place("vertex 7")];
  expect(x).toBeGreaterThan(7);
  expect([2 * x, 2 * y].map((each) => Math.abs(each - Math.round(each)) < 1e-6)).toEqual([true, true]);
  expect([mx, my]).toEqual([-x, y]);
  // What cannot be done is said in words, and nothing changes.
  const before = await pot.fingerprint();
  await pot.button("Bridge").click();
  await page.getByText("Pick two whole rims first").waitFor();
  await pot.shows(before);
});

test("on a phone the panel fits, and everything in it can be pressed", async () => {
  const { pot } = await opened({ ...PHONE });
  await pot.page.locator("pasu-network-panel [data-pick=all]").tap();
  await pot.page.locator("pasu-network-patch .acts button").first().tap();
  await pot.page.locator("pasu-network-patch .force").waitFor();
  expect(await overhang(pot)).toBeLessThanOrEqual(0);
  expect(await unreachable(pot)).toEqual([]);
  expect(await findings(pot)).toEqual([]);
});

test("a new network is one of the pictures", async () => {
  const pot = await here.enter();
  const first = await pot.fingerprint();
  await pot.command("New");
  await pot.page.getByText("From patches").click();
  await pot.page.locator('pasu-new button[data-exhibit="own-mug"]').click();
  await pot.fingerprintOtherThan(first);
  expect(await told(pot)).toContain("110 patches through 330 points");
});

/** A sheet of 500 patches with its points on the stage: its fingerprint, and where the middle of the stage is. */
async function sheetAtHand() {
  const pot = await here.enter({});
  const first = await pot.fingerprint();
  const large = sheet(20, 25);
  await pot.dropFile("sheet.json", JSON.stringify(large));
  const plain = await pot.fingerprintOtherThan(first);
  await pot.button("Points on the stage").click();
  await pot.page.locator("pasu-network-handles canvas").last().waitFor();
  const box = await pot.page.locator("pasu-network-handles").boundingBox();
  const middle: [number, number] = [(box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2];
  return { pot, plain, middle, large };
}

test("a large network that is dragged, undone and dragged again is drawn as one that is drawn anew", {
  timeout: 120_000,
}, async () => {
  const { pot, plain, middle } = await sheetAtHand();
  const [x, y] = middle;
  const pull = async (from: readonly [number, number], by: readonly [number, number]) => {
    const before = await pot.fingerprint();
    await pot.page.mouse.move(from[0], from[1]);
    await pot.page.mouse.down();
    await pot.page.mouse.move(from[0] + by[0], from[1] + by[1], { steps: 6 });
    await pot.page.mouse.up();
    return await pot.fingerprintOtherThan(before);
  };
  await pull([x, y + 80], [12, -60]);
  const pulled = await pull([x + 60, y + 90], [-10, -40]);
  await pot.undo();
  await pot.undo();
  await pot.shows(plain);
  await pot.redo();
  await pot.redo();
  await pot.shows(pulled);
  expect(await differsFromAnew(pot)).toBe(0);
  await overlay(pot);
  // The tool is put down and taken up: all is drawn anew.
  await pot.button("Points on the stage").click();
  await pot.page.locator("pasu-network-handles").waitFor({ state: "detached" });
  await pot.button("Points on the stage").click();
  await pot.page.locator("pasu-network-handles canvas").last().waitFor();
  // Some pixels at the rims of points may be blended in another order.
  await expect.poll(async () => await overlay(pot)).toBeLessThan(60);
  await pot.leave();
});

test("keys go on with the point of a large network that was clicked", async () => {
  const { pot, plain } = await sheetAtHand();
  interface Points {
    placed: { item: { kind: string }; seen: { x: number; y: number } }[];
  }
  const spots = pot.page.locator("pasu-network-handles");
  const seen = () =>
    spots.evaluate((element) => {
      const { left, top } = element.getBoundingClientRect();
      const found = (element as unknown as Points).placed.filter(({ item: { kind } }) => kind === "vertex");
      const { seen: spot } = found[Math.floor(found.length / 2)] ?? {};
      return spot ? { x: left + spot.x, y: top + spot.y } : null;
    });
  await expect.poll(seen).not.toBeNull();
  const { x = 0, y = 0 } = (await seen()) ?? {};
  await pot.page.mouse.click(x, y);
  await pot.page.getByText("1 point and 0 patches picked").waitFor();
  const held = pot.page.locator("pasu-network-handles button:focus");
  await expect.poll(() => held.count()).toBe(1);
  await pot.page.keyboard.press("ArrowUp");
  await pot.fingerprintOtherThan(plain);
});

test("a point meets the one that the hand is on, and not another beside it", async () => {
  const { pot, plain } = await sheetAtHand();
  await pot.page.getByLabel("To other points").check();
  interface Points {
    placed: { item: { kind: string; index: number }; at: number[]; seen: { x: number; y: number } }[];
  }
  const spots = pot.page.locator("pasu-network-handles");
  /** Where a point is, and where one far from it that has another beside it. */
  const found = () =>
    spots.evaluate((element) => {
      const { left, top } = element.getBoundingClientRect();
      const all = (element as unknown as Points).placed.filter(({ item: { kind } }) => kind === "vertex");
      const far = (one: (typeof all)[0], other: (typeof all)[0]) =>
        Math.hypot(one.seen.x - other.seen.x, one.seen.y - other.seen.y);
      const goal = all.find((each) => all.find((other) => far(each, other) < 10) !== each);
      const from =
        goal && all.find((each) => far(each, goal) > 100 && all.every((o) => o === each || far(each, o) > 3));
      return (
        from &&
        goal && {
          from: [left + from.seen.x, top + from.seen.y],
          to: [left + goal.seen.x, top + goal.seen.y],
          goal: goal.at,
        }
      );
    });
  await expect.poll(found).toBeTruthy();
  const { from = [], to = [], goal } = (await found()) ?? {};
  await pot.page.mouse.move(from[0] ?? 0, from[1] ?? 0);
  await pot.page.mouse.down();
  await pot.page.mouse.move(to[0] ?? 0, to[1] ?? 0, { steps: 5 });
  await pot.page.mouse.up();
  await pot.fingerprintOtherThan(plain);
  expect([await number(pot, "x"), await number(pot, "y"), await number(pot, "z")]).toEqual(
    goal?.map((each) => expect.closeTo(each, 5)),
  );
});

test("a hand on a large network has its points and their numbers drawn, and nothing else of the page", async () => {
  const { pot, plain, middle, large } = await sheetAtHand();
  await countDrawn(pot);
  const [x, y] = [middle[0], middle[1] + 80];
  await pot.page.mouse.move(x, y);
  await pot.page.mouse.down();
  // With the first movements the point is picked, and the bar says that there is something to undo.
  await pot.page.mouse.move(x, y - 12, { steps: 6 });
  await pot.page.locator("pasu-network-place pasu-number").first().waitFor();
  await drawn(pot);
  await pot.page.mouse.move(x, y - 40, { steps: 12 });
  const during = await drawn(pot);
  expect(during).toContain("pasu-network-handles");
  const ours = ["pasu-network-handles", "pasu-network-place", "pasu-number"];
  expect(during.filter((name) => !ours.includes(name))).toEqual([]);
  await pot.page.mouse.up();
  await pot.fingerprintOtherThan(plain);
  // The numbers say where what was moved came to rest: the mean of its points.
  const fields = pot.page.locator("pasu-network-place").getByRole("spinbutton");
  const told = await fields.evaluateAll((all) => all.map((each) => Number(each.ariaValueNow)));
  const were = (large as { parts: { shape: { vertices: number[][] } }[] }).parts[0]?.shape.vertices ?? [];
  const moved = (
    await pot.page.evaluate(() => {
      interface Page {
        designer: { store: { design: { parts: { shape: { vertices: number[][] } }[] } } };
      }
      const { designer } = document.querySelector("pasu-app") as unknown as Page;
      return designer.store.design.parts[0]?.shape.vertices ?? [];
    })
  ).filter((point, at) => point.some((each, axis) => Math.abs(each - (were[at]?.[axis] ?? 0)) > 1e-6));
  expect(moved.length).toBeGreaterThan(0);
  const mean = [0, 1, 2].map((axis) => moved.reduce((sum, point) => sum + (point[axis] ?? 0), 0) / moved.length);
  expect(told).toEqual(mean.map((each) => Number(each.toPrecision(6)) + 0));
  await pot.leave();
});

test("the first movement of a large network is written over in the mesh that stands at rest", async () => {
  const { pot, middle } = await sheetAtHand();
  const [x, y] = [middle[0], middle[1] + 80];
  await pot.page.mouse.move(x, y);
  await pot.page.mouse.down();
  expect(await meshAfter(pot, async () => await pot.page.mouse.move(x, y - 12))).toBe("the same arrays");
  await pot.page.mouse.up();
  await pot.leave();
});

/** Whether what is shown after something is done is in the arrays in which the mesh was before. */
async function meshAfter(pot: Visit, act: () => Promise<void>): Promise<"the same arrays" | "others"> {
  interface Page {
    designer: { surface: { shown: { change: number; solved: { parts: { mesh: { positions: Float32Array } }[] } } } };
  }
  const before = await pot.page.evaluateHandle(
    () => (document.querySelector("pasu-app") as unknown as Page).designer.surface.shown,
  );
  await act();
  const same = await pot.page.waitForFunction((was) => {
    const { shown } = (document.querySelector("pasu-app") as unknown as Page).designer.surface;
    if (shown.change === was.change) return null;
    const [now, then] = [shown, was].map(({ solved }) => solved.parts[0]?.mesh.positions);
    return now === then ? "the same arrays" : "others";
  }, before);
  return (await same.jsonValue()) ?? "others";
}

/** By how much the mesh on the stage is another than one that is sampled as a whole. */
async function differsFromAnew(pot: Visit): Promise<number> {
  return await pot.page.evaluate(async () => {
    interface Solver {
      mesh(
        lane: string,
        design: object,
        rows: number,
        columns: number,
      ): Promise<{ value: { parts: { mesh: Arrays }[] } }>;
    }
    interface Arrays {
      positions: Float32Array;
      normals: Float32Array;
    }
    interface Page {
      designer: {
        solver: Solver;
        store: { design: object };
        surface: {
          grid(design: object): { rows: number; columns: number };
          shown: { solved: { parts: { mesh: Arrays }[] } };
        };
      };
    }
    const { solver, store, surface } = (document.querySelector("pasu-app") as unknown as Page).designer;
    const { rows, columns } = surface.grid(store.design);
    const { value } = await solver.mesh("anew", store.design, rows, columns);
    const [now, anew] = [surface.shown.solved.parts[0]?.mesh, value.parts[0]?.mesh];
    if (!now || !anew || now.positions.length !== anew.positions.length) return Number.NaN;
    let most = 0;
    for (const name of ["positions", "normals"] as const)
      for (const [place, each] of now[name].entries()) most = Math.max(most, Math.abs(each - (anew[name][place] ?? 0)));
    return most;
  });
}

/** How many pixels of what lies over the stage, both canvases on each other, are quite others than when this was asked last. */
async function overlay(pot: Visit): Promise<number> {
  return await pot.page.evaluate(() => {
    const find = (root: Document | ShadowRoot): HTMLElement | null => {
      for (const element of root.querySelectorAll("*")) {
        if (element.localName === "pasu-network-handles") return element as HTMLElement;
        const found = element.shadowRoot && find(element.shadowRoot);
        if (found) return found;
      }
      return null;
    };
    const all = [...(find(document)?.shadowRoot?.querySelectorAll("canvas") ?? [])];
    const { width = 1, height = 1 } = all[0] ?? {};
    const context = new OffscreenCanvas(width, height).getContext("2d");
    for (const each of all) context?.drawImage(each, 0, 0);
    const now = context?.getImageData(0, 0, width, height).data ?? new Uint8ClampedArray();
    const kept = globalThis as unknown as { pasuOverlay?: Uint8ClampedArray };
    const before = kept.pasuOverlay;
    kept.pasuOverlay ??= now;
    let others = 0;
    for (let place = 3; before && place < now.length; place += 4)
      if (Math.abs((now[place] ?? 0) - (before[place] ?? 0)) > 64) others += 1;
    return before?.length === now.length ? others : Number.POSITIVE_INFINITY;
  });
}

test("that a large file is being opened is said and shown, and can be stopped", { timeout: 120_000 }, async () => {
  const pot = await here.enter({});
  const first = await pot.fingerprint();
  // Held until the test lets it go.
  await pot.page.evaluate(() => {
    const { solver } = (document.querySelector("pasu-app") as unknown as { designer: { solver: Solver } }).designer;
    interface Solver {
      parse(text: string): Promise<unknown>;
    }
    const parse = solver.parse.bind(solver);
    solver.parse = async (text) => {
      await new Promise<void>((go) => Object.assign(globalThis, { pasuGo: go }));
      const parsed = parse(text);
      Object.assign(globalThis, { pasuParsed: parsed });
      return await parsed;
    };
  });
  const large = JSON.stringify(sheet(40, 50));
  const said = pot.page.locator("pasu-opening-note [role=status]");
  for (const stop of ["key", "button"]) {
    // Of two that are dropped together the second is not wanted either, and none is said to be open.
    await pot.dropFiles([
      ["sheet.json", large],
      ["leaf.json", LEAF],
    ]);
    await pot.button("Stop").waitFor();
    await expect.poll(async () => await said.textContent()).toMatch(/^Opening .*sheet\.json.* \(0\.\d+ MB\)…$/);
    expect(await findings(pot)).toEqual([]);
    if (stop === "key") await pot.page.keyboard.press("Escape");
    else await pot.button("Stop").click();
    await pot.button("Stop").waitFor({ state: "detached" });
    expect(await said.textContent()).toBe("");
    await pot.page.evaluate(async () => {
      const held = globalThis as unknown as { pasuGo(): void; pasuParsed: Promise<unknown> };
      held.pasuGo();
      await new Promise(requestAnimationFrame);
      await held.pasuParsed;
      for (let i = 0; i < 2; i += 1) await new Promise(requestAnimationFrame);
    });
    await pot.shows(first);
    expect(await pot.page.getByText(/^Opened/).count()).toBe(0);
  }
  await pot.dropFile("sheet.json", large);
  await pot.button("Stop").waitFor();
  expect(await pot.fingerprint()).toBe(first);
  await pot.page.evaluate(() => (globalThis as unknown as { pasuGo(): void }).pasuGo());
  await pot.fingerprintOtherThan(first);
  await pot.button("Stop").waitFor({ state: "detached" });
  await pot.leave();
});

test("a region round a corner of five patches is refused while it is drawn, and nothing is changed", async () => {
  const pot = await here.enter();
  const { page } = pot;
  page.setDefaultTimeout(20_000);
  const first = await pot.fingerprint();
  // Point 0 in the middle, ten round it; a middle on every edge: those from the middle, and those of the rim.
  const corners = Array.from({ length: 10 }, (_, each) => (each * Math.PI) / 5).map((turn) => [
    6 * Math.cos(turn),
    6 * Math.sin(turn),
  ]);
  const half = (one: readonly number[], other: readonly number[]) => one.map((x, axis) => (x + (other[axis] ?? 0)) / 2);
  const at = (place: number) => corners[place % 10] ?? [];
  const spokes = [0, 2, 4, 6, 8].map((place) => half([0, 0], at(place)));
  const rim = corners.map((corner, place) => half(corner, at(place + 1)));
  const vertices = [[0, 0], ...corners, ...spokes, ...rim].map(([x, y]) => [x, y, 0]);
  const patches = [0, 1, 2, 3, 4].map((each) => {
    const [own, next] = [2 * each, (2 * each + 2) % 10];
    return { frame: [0, 11 + each, 1 + own, 16 + own, 2 + own, 17 + own, 1 + next, 11 + ((each + 1) % 5)] };
  });
  const shape = { kind: "vertex-frame", vertices, patches };
  await pot.dropFile("five.json", JSON.stringify({ pasu: 1, parts: [{ shape }] }));
  const plain = await pot.fingerprintOtherThan(first);
  await points(pot);
  await page.getByRole("radio", { name: "draws a region" }).check();
  const [from, corner, beside, across, other] = [
    await middle(pot, "patch 0"),
    await middle(pot, "vertex 0"),
    await middle(pot, "patch 1"),
    await middle(pot, "patch 3"),
    await middle(pot, "patch 2"),
  ];
  const near = (to: readonly [number, number]) =>
    [corner[0] + 0.5 * (to[0] - corner[0]), corner[1] + 0.5 * (to[1] - corner[1])] as const;
  const refused = page.getByText("no region can lie round it");
  await page.mouse.move(...from);
  await page.mouse.down();
  // Over the edge alone, and then round the corner as well.
  await page.mouse.move(...near(beside), { steps: 4 });
  expect(await refused.count()).toBe(0);
  await page.mouse.move(...near(across), { steps: 4 });
  await refused.waitFor();
  await page.mouse.up();
  await refused.waitFor();
  await pot.shows(plain);
  // Of the two that lie across, one alone has a place beside the others laid flat: of both the reason is the same.
  await page.getByRole("radio", { name: "draws a region" }).check();
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(...near(beside), { steps: 4 });
  await refused.waitFor({ state: "detached" });
  await page.mouse.move(...other, { steps: 4 });
  await refused.waitFor();
  await page.mouse.up();
  await refused.waitFor();
  await pot.shows(plain);
  await pot.undo();
  await pot.shows(first);
  expect(await pot.history("Undo").isEnabled()).toBe(false);
});
