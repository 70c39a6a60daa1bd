// What pushes patches out: forces, their crests, and regions over several patches.

import { expect, test } from "vitest";
import { item, LEAF, middle, number, openCan, openLeaf, points } from "../support/network.ts";
import { stay } from "../support/stay.ts";

const here = stay();

test("keys take a crest through the surface to its other side, and a patch that is full of forces says so", async () => {
  const { pot, plain } = await openLeaf(here);
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

test("crests of several patches are told apart, and what is no choice is not pressed", async () => {
  const { pot } = await openCan(here);
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
  const { pot, plain } = await openCan(here);
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
  const { pot } = await openLeaf(here);
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
  const { pot, plain } = await openLeaf(here);
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

test("a region is drawn across patches and pulled, and its numbers follow", { timeout: 120_000 }, async () => {
  const { pot, plain } = await openCan(here);
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
