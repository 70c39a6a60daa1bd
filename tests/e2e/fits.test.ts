// At every size: each panel, menu and dialogue is on the screen, and nothing of it under something else. With PASU_SHOTS=folder it takes pictures of all of them.

import { writeFileSync } from "node:fs";
import { expect, test } from "vitest";
import { overhang, unreachable } from "../support/reach.ts";
import { type Stay, stay } from "../support/stay.ts";
import { PHONE, type Visit, type VisitOptions } from "../support/visit.ts";

interface Viewport {
  readonly width: number;
  readonly height: number;
}

interface Size {
  readonly name: string;
  readonly options: VisitOptions;
  /** At these the same page is looked at in turn, wherever it is opened. */
  readonly viewports: readonly [Viewport, ...Viewport[]];
  readonly place: Stay;
}

const here = stay();
/** Where a person has asked the browser for letters twice as large. */
const large = stay({ frugal: true, flags: ["--blink-settings=defaultFontSize=32"] });

const SIZES: readonly Size[] = [
  {
    name: "on a phone",
    options: PHONE,
    viewports: [
      { width: 320, height: 844 },
      { width: 390, height: 844 },
    ],
    place: here,
  },
  // A window of 1280 by 800 whose page is enlarged to 200 %.
  { name: "at 200 %", options: {}, viewports: [{ width: 640, height: 400 }], place: here },
  { name: "with letters twice as large", options: {}, viewports: [{ width: 1280, height: 800 }], place: large },
];

const DIALOGS = ["My designs", "New", "Gallery", "Export", "Picture", "Embed", "Help"] as const;

test.each(SIZES)("nothing is cut off or covered $name", { timeout: 400_000 }, async (size) => {
  const { name, viewports, options } = size;
  const pot = await size.place.enter({ link: "#1/fourth-order", ...options, viewport: viewports[0] });
  await pot.fingerprint();
  const problems: string[] = [];
  const check = async (where: string, inside?: string) => {
    for (const viewport of viewports) {
      if (viewports.length > 1) await pot.page.setViewportSize(viewport);
      await pictures(pot, `${name} ${viewport.width} ${where}`);
      const there = `${where}, ${viewport.width} pixels wide`;
      const over = await overhang(pot);
      if (over > 0) problems.push(`${there}: ${over} pixels too much`);
      problems.push(...(await unreachable(pot, inside)).map((problem) => `${there}: ${problem}`));
    }
  };
  for (const tab of ["Shape", "Profile", "Equation", "Look"] as const) {
    await pot.tab(tab);
    await check(tab);
  }
  await pot.tab("Shape");
  await pot.button("Explain").click();
  await check("Shape, explained");
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
    await pot.button("Close").click();
    await pot.page.getByRole("dialog").waitFor({ state: "detached" });
  }
  expect(problems).toEqual([]);
});

async function pictures(pot: Visit, name: string): Promise<void> {
  const folder = process.env.PASU_SHOTS;
  if (!folder) return;
  for (const colorScheme of ["dark", "light"] as const) {
    await pot.page.emulateMedia({ colorScheme });
    const file = `${name} ${colorScheme}`.replaceAll(/[ %,]+/g, "-");
    writeFileSync(`${folder}/${file}.png`, await pot.page.screenshot());
  }
}
