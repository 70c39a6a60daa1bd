// The element for other people's pages: the npm package `pasu-pot`, and the same files on the site below the version that pages name.

import { copyFile, cp, mkdir, readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import type { Plugin, ResolvedConfig } from "vite";
import { metaPolicy } from "./content-security-policy.ts";
import { version } from "./pasu-package.ts";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The package as it is built. */
export const POT_PACKAGE = here("../pot/pkg");

/** What is in the package as it is written. */
const WRITTEN = ["embed.css", "pasu-pot.d.ts", "design.d.ts", "custom-elements.json", "README.md"];
const LICENCES = ["LICENSE-MIT", "LICENSE-APACHE"];

/** Where the element is on the site, for pages that name it: the same for every version that changes nothing for them. */
export function potFolder(): string {
  return `pot/${version().split(".").slice(0, 2).join(".")}`;
}

/** Puts what a package has besides its code beside the code. */
export function potPackage(): Plugin {
  return {
    name: "pasu:pot-package",
    apply: "build",
    writeBundle: {
      order: "post",
      sequential: true,
      async handler() {
        for (const name of WRITTEN) await copyFile(here(`../pot/${name}`), join(POT_PACKAGE, name));
        for (const name of LICENCES) await copyFile(here(`../../${name}`), join(POT_PACKAGE, name));
        const manifest = await readFile(here("../pot/package.json"), "utf8");
        await writeFile(join(POT_PACKAGE, "package.json"), manifest.replace('"0.0.0"', JSON.stringify(version())));
      },
    },
  };
}

/** Puts the built package into the site, and the page that shows one pot to systems that allow only frames. */
export function potOnSite(): Plugin {
  let config: ResolvedConfig;
  return {
    name: "pasu:pot-on-site",
    apply: "build",
    configResolved(resolved) {
      config = resolved;
    },
    writeBundle: {
      order: "pre",
      sequential: true,
      async handler() {
        const site = join(config.root, config.build.outDir);
        const folder = join(site, potFolder());
        await mkdir(folder, { recursive: true });
        await cp(POT_PACKAGE, folder, { recursive: true });
        const page = await readFile(here("../pot/embed.html"), "utf8");
        const filled = page.replaceAll("%POT%", `./${potFolder()}`).replace("%POLICY%", metaPolicy({ framed: true }));
        await writeFile(join(site, "embed.html"), filled);
      },
    },
  };
}
