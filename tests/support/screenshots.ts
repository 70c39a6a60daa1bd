// Pictures of the designer for people to look at, into docs/. Run by hand, in web/, on the site that was last built:
//
//     npx vitest run --config ../tests/support/screenshots.config.mts
//
// They are not compared with anything: geometry is judged by numbers.

import { mkdir } from "node:fs/promises";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { beforeAll, test } from "vitest";
import { atRest } from "./sight.ts";
import { stay } from "./stay.ts";
import { PHONE, SHARP, type Visit, type VisitOptions } from "./visit.ts";

const DOCS = fileURLToPath(new URL("../../docs", import.meta.url));
const here = stay();
/** Exhibits of the gallery that are on the picture. */
const IN_SIGHT = 12;
const WIDE: VisitOptions = { ...SHARP, viewport: { width: 1440, height: 900 } };
const FINE_PHONE: VisitOptions = { ...SHARP, ...PHONE, deviceScaleFactor: 2 };

/** What is on the picture: a pot of the gallery and the panel beside it, or the gallery itself. */
interface Scene {
  readonly name: string;
  readonly options: VisitOptions;
  readonly exhibit: string;
  readonly panel?: "Profile" | "Look";
  readonly gallery?: boolean;
  /** A pot with its wall, cut open, and the water in it. */
  readonly filled?: boolean;
}

const SCENES: readonly Scene[] = [
  { name: "designer", options: { ...WIDE, colorScheme: "light" }, exhibit: "own-dint" },
  { name: "designer-dark", options: { ...WIDE, colorScheme: "dark" }, exhibit: "own-dint", panel: "Profile" },
  { name: "gallery", options: { ...WIDE, colorScheme: "light" }, exhibit: "own-dint", gallery: true },
  { name: "making", options: { ...WIDE, colorScheme: "light" }, exhibit: "own-moon-jar", filled: true },
  { name: "phone", options: { ...FINE_PHONE, colorScheme: "light" }, exhibit: "own-moon-jar" },
  { name: "phone-dark", options: { ...FINE_PHONE, colorScheme: "dark" }, exhibit: "own-trumpet", panel: "Look" },
];

async function fill(pot: Visit): Promise<void> {
  await pot.makePot();
  await pot.tab("Measures");
  await pot.button("Fill it").click();
  await pot.page.getByText("The mesh is closed").waitFor();
  await pot.page
    .getByText(/^8\.\d+.l$/)
    .first()
    .waitFor();
}

beforeAll(() => mkdir(DOCS, { recursive: true }));

test.each(SCENES)("$name", async ({ name, options, exhibit, panel, gallery, filled }) => {
  const pot = await here.enter(options);
  await pot.fingerprint();
  await pot.command("Gallery");
  const drawn = pot.page.locator('pasu-gallery canvas[data-drawn="true"]');
  if (gallery) {
    await drawn.nth(IN_SIGHT - 1).waitFor();
  } else {
    await pot.page.locator(`pasu-gallery button[data-exhibit="${exhibit}"]`).click();
    await pot.page.locator("pasu-gallery").waitFor({ state: "detached" });
    await pot.fingerprint();
    if (panel) await pot.tab(panel);
    if (filled) await fill(pot);
    await pot.page.mouse.move(0, 0);
  }
  await atRest(pot);
  await pot.page.screenshot({ path: join(DOCS, `${name}.png`) });
});
