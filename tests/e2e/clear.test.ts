// Handles on the stage stand where a hand can take hold of them: beside what lies over it.

import { expect, test } from "vitest";
import { grip, handling, standing, takeParts } from "../support/placing.ts";
import { dragFrom, spotOf } from "../support/pulling.ts";
import { atRest } from "../support/sight.ts";
import { stay } from "../support/stay.ts";
import { PHONE, QUICK, type Visit, type VisitOptions } from "../support/visit.ts";

const here = stay();

/** As a person opens it; where no part is chosen the first has the handles. */
async function opened(id: string, options: VisitOptions, part?: string): Promise<Visit> {
  const pot = await here.enter({ ...QUICK, ...options });
  const first = await pot.fingerprint();
  await pot.command("Gallery");
  await pot.page.locator(`pasu-gallery button[data-exhibit="${id}"]`).click();
  await pot.fingerprintOtherThan(first);
  if (part) await pot.page.locator("pasu-parts [role=option]").filter({ hasText: part }).click();
  return pot;
}

/** The names of the handles that something else is over at their middles. */
const covered = (pot: Visit, layer: string) =>
  pot.page.locator(`${layer} button:not([hidden])`).evaluateAll((all) =>
    all.flatMap((button) => {
      const { left, top, width, height } = button.getBoundingClientRect();
      const [x, y] = [left + width / 2, top + height / 2];
      let at = document.elementFromPoint(x, y);
      for (let within = at?.shadowRoot?.elementFromPoint(x, y); within && within !== at; ) {
        at = within;
        within = at.shadowRoot?.elementFromPoint(x, y);
      }
      // One handle may lie over another.
      return at?.closest("button")?.parentElement === button.parentElement ? [] : [button.dataset.grip ?? ""];
    }),
  );

const DESK: VisitOptions = { viewport: { width: 1280, height: 800 } };
const NARROW: VisitOptions = { ...PHONE, viewport: { width: 320, height: 640 } };
const LOW: VisitOptions = { viewport: { width: 640, height: 400 } };

for (const [id, name, options, part] of [
  ["own-lidded-jar", "on a desk", DESK, "Lid"],
  ["own-octant-star", "on a desk", {}, undefined],
  ["own-lidded-jar", "on a phone", PHONE, "Lid"],
  ["own-tea-set", "on a narrow phone", NARROW, undefined],
  ["own-lidded-jar", "in a low window", LOW, "Lid"],
] as const) {
  test(`every handle of ${id} can be taken hold of ${name}`, async () => {
    const pot = await opened(id, options, part);
    await takeParts(pot);
    for (const kind of ["Move", "Turn", "Scale"]) {
      await handling(pot, kind);
      await atRest(pot);
      await expect.poll(() => covered(pot, "pasu-place-handles .handles")).toEqual([]);
    }
  });
}

test("a lid at the upper edge of the stage is lifted by its handle", async () => {
  const pot = await opened("own-lidded-jar", DESK, "Lid");
  await takeParts(pot);
  await atRest(pot);
  const lift = async () => (await standing(pot))[1]?.shift[2] ?? 0;
  const before = await lift();
  await dragFrom(pot, await spotOf(grip(pot, "move-z")), { x: 0, y: -30 });
  await expect.poll(lift).toBeGreaterThan(before);
});

for (const [id, name, options] of [
  ["own-crossed-ovals", "on a desk", DESK],
  ["own-crossed-ovals", "on a phone", PHONE],
  ["own-twisted-square", "on a phone", PHONE],
] as const) {
  test(`every handle of the sections of ${id} can be taken hold of ${name}`, async () => {
    const pot = await opened(id, options);
    await pot.button("Pull").click();
    await pot.page.locator("pasu-section-handles .handles button").first().waitFor();
    await atRest(pot);
    await expect.poll(() => covered(pot, "pasu-section-handles .handles")).toEqual([]);
  });
}
