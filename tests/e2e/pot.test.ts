// `<pasu-pot>` in other people's pages: what it shows and says, and whose the gestures are.

import { expect, test } from "vitest";
import { counted, loaded, town } from "../support/guests.ts";
import { sight } from "../support/sight.ts";

const here = town();

test("one script tag and one element show a pot, from another origin", async () => {
  const guest = await here.open("plain.html");
  await loaded(guest);
  const pot = guest.page.locator("pasu-pot");
  expect(sight(await pot.screenshot()).tones).toBeGreaterThan(200);
  expect(await counted(guest)).toEqual({ contexts: 1, workers: 1, loads: 1 });
  expect(await pot.evaluate((element) => (element as HTMLElementTagNameMap["pasu-pot"]).link)).toBe("#1/bloor-wilson?n1=5");
});
