// The package as it is published, through a bundler for browsers.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { inFreshProject, ROOT } from "./install.mjs";

const VITE = join(ROOT, "web/node_modules/vite/bin/vite.js");

/** The modules that each entry needs, and those that it must not bring along. */
const ENTRIES = [
  { entry: "pasu", needs: ["pasu_bg.wasm"], others: ["pasu_drawing_bg.wasm"] },
  { entry: "pasu/drawing", needs: ["pasu_drawing_bg.wasm", "pasu_bg.wasm"], others: [] },
];

for (const { entry, needs, others } of ENTRIES) {
  test(`a bundler takes ${entry} with its modules and nothing else`, async () => {
    await inFreshProject((project) => {
      writeFileSync(join(project, "index.html"), '<!doctype html><script type="module" src="./main.js"></script>');
      const main = `import init, { mesh, PasuError } from "${entry}";
        await init();
        try { document.title = String(mesh("#1/bloor-wilson").indices.length); } catch (e) { if (!(e instanceof PasuError)) throw e; }`;
      writeFileSync(join(project, "main.js"), main);
      execFileSync(process.execPath, [VITE, "build", "--target", "es2022", "--logLevel", "error"], { cwd: project });
      const files = readdirSync(join(project, "dist/assets"));
      const bytes = (folder, name) => readFileSync(join(project, folder, name));
      const emitted = files.filter((file) => file.endsWith(".wasm")).map((file) => bytes("dist/assets", file));
      const has = (module) => emitted.some((file) => file.equals(bytes("node_modules/pasu", module)));
      assert.ok([...needs, "pasu_scalar_bg.wasm"].every(has), `${entry} brings ${files}`);
      for (const other of others) assert.ok(!has(other), `${entry} brings ${other}`);
      const scripts = files.filter((file) => file.endsWith(".js")).map((file) => bytes("dist/assets", file).toString());
      assert.ok(scripts.some((script) => script.includes("PasuError") && script.includes(".wasm")));
    });
  });
}
