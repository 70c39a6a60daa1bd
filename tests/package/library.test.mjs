// The package as it is published, in Node without a bundler.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { inFreshProject, ROOT } from "./install.mjs";

const VASE = "#1/bloor-wilson?n1=5";

/** Runs a script of a fresh project and returns what it prints. */
function run(project, name, text) {
  writeFileSync(join(project, name), text);
  return execFileSync(process.execPath, [name], { cwd: project, encoding: "utf8" });
}

function javascriptOf(readme) {
  const blocks = [...readFileSync(join(ROOT, readme), "utf8").matchAll(/```js\n([\s\S]*?)```/g)];
  assert.equal(blocks.length, 1, `${readme} has one example in JavaScript`);
  return blocks[0][1];
}

test("the package holds what it promises and nothing else", async () => {
  await inFreshProject((project) => {
    const files = readdirSync(join(project, "node_modules/pasu")).sort();
    assert.deepEqual(files, [
      "LICENSE-APACHE",
      "LICENSE-MIT",
      "README.md",
      "bindings.js",
      "design.d.ts",
      "package.json",
      "pasu.d.ts",
      "pasu.js",
      "pasu_bg.wasm",
    ]);
  });
});

test("the examples of both README files run", async () => {
  await inFreshProject((project) => {
    const long = run(project, "long.mjs", javascriptOf("README.md"));
    assert.match(long, /^\d+ vertices, \d+ triangles, #1\/bloor-wilson\?n1=5\nunit: .+\n$/);
    const short = run(project, "short.mjs", javascriptOf("crates/pasu-wasm/js/README.md"));
    assert.match(short, /^\d+ triangles: 1\/bloor-wilson\?n1=5\n$/);
  });
});

test("the module is found beside a file that is imported by its path", async () => {
  const script = `const pasu = await import(${JSON.stringify(pathToFileURL(join(ROOT, "crates/pasu-wasm/pkg/pasu.js")).href)});
    await pasu.default();
    console.log(pasu.link("${VASE}"));`;
  assert.equal(
    execFileSync(process.execPath, ["--input-type=module", "--eval", script], { encoding: "utf8" }),
    `${VASE.slice(1)}\n`,
  );
});

test("the module loads once, says so when it is not loaded, and again after a failure", async () => {
  await inFreshProject(async (project) => {
    const pasu = await import(pathToFileURL(join(project, "node_modules/pasu/pasu.js")).href);
    assert.throws(() => pasu.parse(VASE), { name: "PasuError", code: "not-ready", path: "" });
    await assert.rejects(pasu.default(new Uint8Array([1, 2, 3])));
    await Promise.all([pasu.default(), pasu.default()]);
    await pasu.default();
    assert.equal(pasu.link(VASE), VASE.slice(1));
  });
});

test("refusals are PasuErrors", async () => {
  await inFreshProject(async (project) => {
    const pasu = await import(pathToFileURL(join(project, "node_modules/pasu/pasu.js")).href);
    await pasu.default();
    const design = pasu.parse(VASE);
    design.parts[0].shape.r = [1, 0.1, Number.NaN, 0.8];
    for (const call of [pasu.parse, pasu.link, pasu.mesh, pasu.fingerprint]) {
      assert.throws(
        () => call(design),
        (error) => {
          assert.ok(error instanceof pasu.PasuError && error instanceof Error);
          assert.equal(error.code, "not-finite");
          assert.equal(error.path, "parts[0].shape.r[2]");
          assert.match(error.message, /NaN/);
          return true;
        },
      );
    }
  });
});

test("arrays are the caller's own and survive later calls", async () => {
  await inFreshProject(async (project) => {
    const pasu = await import(pathToFileURL(join(project, "node_modules/pasu/pasu.js")).href);
    await pasu.default();
    const first = pasu.mesh(VASE, { rows: 9, columns: 17 });
    const copy = Float32Array.from(first.positions);
    pasu.mesh(VASE, { rows: 400, columns: 400 }); // memory grows, views of it would be detached
    assert.deepEqual(first.positions, copy);
    first.positions.fill(0);
    assert.deepEqual(pasu.mesh(VASE, { rows: 9, columns: 17 }).positions, copy);
  });
});

test("after a crash the next call works on a fresh instance", async () => {
  await inFreshProject(async (project) => {
    const pasu = await import(pathToFileURL(join(project, "node_modules/pasu/pasu.js")).href);
    await pasu.default();
    const before = pasu.fingerprint(VASE);
    // The stack runs out somewhere inside the module, again and again, at every depth.
    const codes = new Set();
    const sink = () => {
      try {
        sink();
      } catch {
        try {
          pasu.mesh(VASE, { rows: 3, columns: 5 });
        } catch (error) {
          codes.add(error.code);
          throw error;
        }
      }
    };
    sink();
    for (const code of codes) assert.ok(code === "bug" || code === undefined, code);
    assert.equal(pasu.fingerprint(VASE), before);
  });
});
