// `<pasu-pot>` where there is no WebGL2, and where there is no scripting.

import { expect, test } from "vitest";
import type {} from "../../web/pot/pasu-pot.d.ts";
import { findings } from "../support/axe.ts";
import { loaded, town } from "../support/guests.ts";
import { sight } from "../support/sight.ts";

const here = town({ webgl: false });

test("without WebGL2 a pot is drawn all the same, and stands still", async () => {
  const guest = await here.open("plain.html");
  await loaded(guest);
  const picture = guest.page.getByRole("img", { name: "A small vase with five dints round its rim" });
  expect(sight(await picture.screenshot()).tones).toBeGreaterThan(50);
  expect(await findings(guest)).toEqual([]);
});

test("without scripting there is what the page put there instead", async () => {
  const guest = await here.open("plain.html", { javaScriptEnabled: false });
  expect(await guest.page.locator("pasu-pot p").isVisible()).toBe(true);
});
