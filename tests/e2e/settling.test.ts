// When a hand lets go: the pot does not jump, and a wall that was not possible comes back.

import { expect, test } from "vitest";
import { fineWall } from "../support/drag.ts";
import { difference, stagePicture } from "../support/sight.ts";
import { stay } from "../support/stay.ts";
import { SHARP } from "../support/visit.ts";

const here = stay();

test("nothing jumps when the hand lets go", async ({ annotate }) => {
  for (const [link, name] of [
    ["#1/bloor-wilson?n1=5", "Rim radius"],
    ["#1/second-order", "Waist pull"],
  ] as const) {
    const pot = await here.enter({ ...SHARP, link });
    const before = await pot.fingerprint();
    let held: Buffer = Buffer.alloc(0);
    let inDrag = "";
    await pot.drag(name, 0.7, {
      held: async () => {
        held = await stagePicture(pot);
        inDrag = (await pot.app.getAttribute("data-vertices")) ?? "";
      },
    });
    await pot.fingerprintOtherThan(before);
    const settled = await stagePicture(pot);
    expect(await pot.app.getAttribute("data-vertices")).not.toBe(inDrag);
    const { mean, share } = difference(held, settled);
    await annotate(
      `${link}: ${inDrag} vertices, mean difference ${mean.toFixed(3)} of 255, visible in ${(100 * share).toFixed(2)} %`,
    );
    // Less than a level in the mean; what differs visibly is a fine line along the silhouette.
    expect(mean).toBeLessThan(0.5);
    expect(share).toBeLessThan(0.01);
  }
});

test("where there is no pot, a drag shows the surface and says why, and the wall comes back with the pot", async () => {
  const pot = await here.enter({ link: "#1/fourth-order" });
  await pot.fingerprint();
  await pot.makePot();
  await pot.type("Base", "0.5");
  await pot.tab("Shape");
  await fineWall(pot);
  const why = pot.page.locator("pasu-stage:not([data-wall])");
  const before = await pot.fingerprint();
  await pot.drag("Height", 0, { steps: 12, held: () => why.waitFor({ state: "attached" }) });
  await pot.fingerprintOtherThan(before);
  await pot.tab("Wall");
  await pot.page.getByText("The rim is lower than what is to lie within it.").first().waitFor();
  await pot.tab("Shape");
  await pot.drag("Height", 0.6, {
    steps: 12,
    held: () => pot.page.locator('pasu-stage[data-wall="quick"]').waitFor({ state: "attached" }),
  });
  await fineWall(pot);
});
