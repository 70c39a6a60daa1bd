// The thickness of a network of patches.

import { expect, test } from "vitest";
import { findings } from "../support/axe.ts";
import { fineWall } from "../support/drag.ts";
import { LEAF, middle, number, openCan, openLeaf, points } from "../support/network.ts";
import { stay } from "../support/stay.ts";
import type { Visit } from "../support/visit.ts";
import { PSEUDO, unmarked } from "../support/words.ts";

const here = stay();

test("an open network gets a thickness, is a body that is exported, and says where it cannot have one", async () => {
  const { pot, plain } = await openLeaf(here);
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
  // One that it can have is offered, and is what it says.
  await pot.button("Make it with a wall of 6 cm").click();
  await told.waitFor();
  expect(await number(pot, "Thickness")).toBe(6);
  await pot.undo();
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
  const { pot } = await openLeaf(here);
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
  const { pot, plain } = await openCan(here);
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
