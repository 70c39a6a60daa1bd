// Pictures of the designer for people to look at, into docs/. Run by hand, in web/, on the site that was last built:
//
//     node -e "import('vite').then((vite) => vite.runnerImport('../tests/support/screenshots.ts'))"
//
// They are not compared with anything: geometry is judged by numbers.

import { mkdir } from "node:fs/promises";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { launch } from "./browser.ts";
import { serve } from "./server.ts";
import { atRest } from "./sight.ts";
import { PHONE, type VisitOptions, visit } from "./visit.ts";

const DOCS = fileURLToPath(new URL("../../docs", import.meta.url));
const WIDE: VisitOptions = { viewport: { width: 1440, height: 900 }, reducedMotion: "reduce" };

/** What is on the picture: a pot of the gallery and the panel beside it, or the gallery itself. */
interface Scene {
  readonly name: string;
  readonly options: VisitOptions;
  readonly exhibit: string;
  readonly panel?: "Profile" | "Look";
  readonly gallery?: boolean;
}

const SCENES: readonly Scene[] = [
  { name: "designer", options: { ...WIDE, colorScheme: "light" }, exhibit: "own-dint" },
  { name: "designer-dark", options: { ...WIDE, colorScheme: "dark" }, exhibit: "own-dint", panel: "Profile" },
  { name: "gallery", options: { ...WIDE, colorScheme: "light" }, exhibit: "own-dint", gallery: true },
  { name: "phone", options: { ...PHONE, colorScheme: "light" }, exhibit: "own-moon-jar" },
  { name: "phone-dark", options: { ...PHONE, colorScheme: "dark" }, exhibit: "own-trumpet", panel: "Look" },
];

await mkdir(DOCS, { recursive: true });
const [site, browser] = await Promise.all([serve(), launch()]);
try {
  for (const { name, options, exhibit, panel, gallery } of SCENES) {
    const pot = await visit(browser, site.url, options);
    const first = await pot.fingerprint();
    await pot.command("Gallery");
    const button = pot.page.locator(`pasu-gallery button[data-exhibit="${exhibit}"]`);
    if (gallery) {
      await pot.page.locator("pasu-gallery canvas:not([data-drawn])").nth(16).waitFor({ state: "attached" });
      await pot.page.waitForFunction(() => {
        const shelf = document.querySelector("pasu-app")?.shadowRoot?.querySelector("pasu-gallery")?.shadowRoot;
        return [...(shelf?.querySelectorAll("canvas") ?? [])]
          .slice(0, 12)
          .every((each) => each.dataset.drawn === "true");
      });
    } else {
      await button.click();
      await pot.page.waitForFunction(
        () => document.querySelector("pasu-app")?.shadowRoot?.querySelector("pasu-gallery") === null,
      );
      await pot.fingerprint();
      if (panel) await pot.tab(panel);
      await pot.page.mouse.move(0, 0);
    }
    await atRest(pot);
    await pot.page.screenshot({ path: join(DOCS, `${name}.png`) });
    console.error(`docs/${name}.png${first === "" ? " (no pot)" : ""}`);
    await pot.leave();
  }
} finally {
  await browser.close();
  await site.close();
}
