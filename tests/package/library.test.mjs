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
      "pasu_scalar_bg.wasm",
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
    // Where it runs out while a field of the caller is read, the field is what cannot be read.
    for (const code of codes) assert.ok(["bug", "wrong-type", undefined].includes(code), code);
    assert.equal(pasu.fingerprint(VASE), before);
  });
});

test("the module without SIMD gives the same bits", () => {
  const hashes = ["pasu_bg.wasm", "pasu_scalar_bg.wasm"].map((module) => {
    const script = `import { readFileSync } from "node:fs";
      import { createHash } from "node:crypto";
      const pasu = await import(${JSON.stringify(pathToFileURL(join(ROOT, "crates/pasu-wasm/pkg/pasu.js")).href)});
      await pasu.default(readFileSync(${JSON.stringify(join(ROOT, "crates/pasu-wasm/pkg", module))}));
      const gallery = JSON.parse(readFileSync(${JSON.stringify(join(ROOT, "tests/reference/gallery.json"))}, "utf8"));
      const hash = createHash("sha256");
      for (const { shape } of gallery) {
        const design = { pasu: 1, parts: [{ shape, place: { scale: [1, 2, 1], axis: [1, 1, 0], angle: 0.3, shift: [4, 0, -2] } }, { shape }] };
        for (const options of [{ rows: 33, columns: 65 }, { rows: 20, columns: 30 }, {}]) {
          const { positions, normals } = pasu.mesh(design, options);
          hash.update(positions).update(normals);
        }
        hash.update(pasu.fingerprint(design));
      }
      console.log(hash.digest("hex"));`;
    return execFileSync(process.execPath, ["--input-type=module", "--eval", script], { encoding: "utf8" });
  });
  assert.match(hashes[0], /^[0-9a-f]{64}\n$/);
  assert.equal(hashes[1], hashes[0]);
});

test("a mesh is written over an earlier one", async () => {
  const pasu = await import(pathToFileURL(join(ROOT, "crates/pasu-wasm/pkg/pasu.js")).href);
  await pasu.default();
  const grid = { rows: 9, columns: 17 };
  const first = pasu.mesh(VASE, grid);
  const other = pasu.mesh("#1/bloor-wilson?n1=3", grid);
  assert.equal(first.topology, other.topology);

  const { positions, normals } = first;
  const written = pasu.mesh("#1/bloor-wilson?n1=3", { ...grid, into: first });
  assert.equal(written.positions, positions);
  assert.equal(written.normals, normals);
  assert.deepEqual(written, other);

  const bare = pasu.mesh(VASE, { ...grid, into: { positions, normals, topology: first.topology } });
  assert.deepEqual(Object.keys(bare).sort(), ["normals", "positions", "topology"]);
  assert.deepEqual(bare.positions, pasu.mesh(VASE, grid).positions);

  const finer = pasu.mesh(VASE, { rows: 10, columns: 17, into: first });
  assert.notEqual(finer.positions, positions);
  assert.deepEqual(finer, pasu.mesh(VASE, { rows: 10, columns: 17 }));

  for (const into of [null, 5, [], { positions: new Float64Array(9 * 17 * 3), indices: "none" }]) {
    assert.deepEqual(pasu.mesh(VASE, { ...grid, into }), pasu.mesh(VASE, grid));
  }
});
