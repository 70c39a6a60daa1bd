// At every size: each panel, menu and dialogue is on the screen, and nothing of it under something else. With PASU_SHOTS=folder it takes pictures of all of them.

import { writeFileSync } from "node:fs";
import { expect, test } from "vitest";
import { overhang, unreachable } from "../support/reach.ts";
import { type Stay, stay } from "../support/stay.ts";
import { PHONE, type Visit, type VisitOptions } from "../support/visit.ts";

const here = stay();
/** Where a person has asked the browser for letters twice as large. */
const large = stay({ frugal: true, flags: ["--blink-settings=defaultFontSize=32"] });

const SIZES: readonly (readonly [string, VisitOptions, Stay])[] = [
  ["on a phone", { ...PHONE, viewport: { width: 390, height: 844 } }, here],
  ["on a dark phone", { ...PHONE, viewport: { width: 390, height: 844 }, colorScheme: "dark" }, here],
  // A window of 1280 by 800 whose page is enlarged to 200 %.
  ["at 200 %", { viewport: { width: 640, height: 400 } }, here],
  ["with letters twice as large", { viewport: { width: 1280, height: 800 } }, large],
];

const DIALOGS = ["My designs", "New", "Gallery", "Export", "Picture", "Embed", "Help"] as const;

test.each(SIZES)("nothing is cut off or covered %s", { timeout: 400_000 }, async (name, options, place) => {
  const pot = await place.enter({ link: "#1/second-order", ...options });
  await pot.fingerprint();
  const problems: string[] = [];
  const check = async (where: string, inside?: string) => {
    await picture(pot, `${name} ${where}`);
    const over = await overhang(pot);
    if (over > 0) problems.push(`${where}: ${over} pixels too much`);
    problems.push(...(await unreachable(pot, inside)).map((problem) => `${where}: ${problem}`));
  };
  for (const tab of ["Shape", "Profile", "Equation", "Look"] as const) {
    await pot.tab(tab);
    await check(tab);
  }
  await pot.makePot();
  await check("Wall");
  await pot.tab("Measures");
  await pot.button("Fill it").click();
  await pot.page.locator("pasu-water [data-volume]").waitFor();
  await check("Measures");
  for (const menu of ["More", "View", "Overlays"]) {
    const button = pot.button(menu);
    if (!(await button.isVisible())) continue;
    await button.click();
    await check(menu, "pasu-menu");
    await pot.page.keyboard.press("Escape");
    expect(await button.getAttribute("aria-expanded")).toBe("false");
  }
  for (const dialog of DIALOGS) {
    await pot.command(dialog);
    await pot.page.getByRole("dialog").waitFor();
    await check(dialog);
    await pot.page.keyboard.press("Escape");
    await pot.page.getByRole("dialog").waitFor({ state: "detached" });
  }
  expect(problems).toEqual([]);
});

async function picture(pot: Visit, name: string): Promise<void> {
  const folder = process.env.PASU_SHOTS;
  if (folder) writeFileSync(`${folder}/${name.replaceAll(/[ %]+/g, "-")}.png`, await pot.page.screenshot());
}
