// The modules of the package: how they are found and loaded, and what they outlive.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { inFreshProject, ROOT, run } from "./install.mjs";

const VASE = "#1/bloor-wilson?n1=5";

test("the module is found beside a file that is imported by its path", async () => {
  const script = `const pasu = await import(${JSON.stringify(pathToFileURL(join(ROOT, "crates/pasu-wasm/pkg/pasu.js")).href)});
    await pasu.default();
    console.log(pasu.link("${VASE}"));`;
  assert.equal(
    execFileSync(process.execPath, ["--input-type=module", "--eval", script], { encoding: "utf8" }),
    `${VASE.slice(1)}\n`,
  );
});

for (const entry of ["pasu.js", "drawing.js"]) {
  test(`the module loads once, says so when it is not loaded, and again after a failure (${entry})`, async () => {
    await inFreshProject(async (project) => {
      const pasu = await import(pathToFileURL(join(project, "node_modules/pasu", entry)).href);
      assert.throws(() => pasu.parse(VASE), { name: "PasuError", code: "not-ready", path: "" });
      await assert.rejects(pasu.default(new Uint8Array([1, 2, 3])));
      await Promise.all([pasu.default(), pasu.default()]);
      await pasu.default();
      assert.equal(pasu.link(VASE), VASE.slice(1));
    });
  });

  test(`refusals are PasuErrors (${entry})`, async () => {
    await inFreshProject(async (project) => {
      const pasu = await import(pathToFileURL(join(project, "node_modules/pasu", entry)).href);
      await pasu.default();
      const design = pasu.parse(VASE);
      design.parts[0].shape.r = [1, 0.1, Number.NaN, 0.8];
      for (const call of [
        pasu.parse,
        pasu.link,
        pasu.mesh,
        pasu.bound,
        pasu.evaluate,
        pasu.derivatives,
        pasu.fingerprint,
      ]) {
        assert.throws(
          () => call(design, call === pasu.evaluate || call === pasu.derivatives ? 0 : undefined, []),
          (error) => {
            assert.ok(error instanceof pasu.PasuError && error instanceof Error);
            assert.equal(error.code, "not-finite");
            assert.equal(error.path, "parts[0].shape.r[2]");
            assert.match(error.message, /NaN/);
            assert.equal(error.place, null);
            return true;
          },
        );
      }
    });
  });
}

test("both entries live side by side, say the same and throw the same class", async () => {
  await inFreshProject((project) => {
    const script = `import init, * as pasu from "pasu";
      import start, * as drawing from "pasu/drawing";
      await start();
      const before = drawing.fingerprint("${VASE}");
      await init();
      const names = Object.keys(drawing).filter((name) => !(name in pasu));
      console.log(String(names), pasu.PasuError === drawing.PasuError, pasu.fingerprint("${VASE}") === before, drawing.fingerprint("${VASE}") === before);`;
    assert.equal(run(project, "both.mjs", script), "widen true true true\n");
  });
});

test("the small module refuses what it leaves out, and knows it once it is widened", async () => {
  await inFreshProject((project) => {
    const script = `import init, { fingerprint, link, mesh, widen } from "pasu/drawing";
      const disc = (radius, z) => ({ form: "disc", radius: [radius, radius], z, taper: 0, dz: 2 });
      const blend = { pasu: 1, parts: [{ shape: { kind: "blend", start: disc(1, 0), end: disc(2, 2) } }] };
      await init();
      const before = fingerprint("${VASE}");
      try {
        mesh(blend);
      } catch ({ code, path, args }) {
        console.log(code, path, args.what);
      }
      await Promise.all([widen(), widen()]);
      const { positions } = mesh(blend);
      console.log(positions.length > 0, link(blend).startsWith("1~"), fingerprint("${VASE}") === before);`;
    assert.equal(run(project, "wide.mjs", script), "unsupported-shape parts[0].shape.kind left-out\ntrue true true\n");
  });
});

test("an engine without SIMD gets the module without, from both entries", async () => {
  await inFreshProject((project) => {
    // What an engine of before 2023 says of a module with SIMD, and would do to it.
    const script = (entry) => `WebAssembly.validate = () => false;
      const { instantiate } = WebAssembly;
      const sizes = [];
      WebAssembly.instantiate = (module, imports) => {
        sizes.push(module.byteLength ?? 0);
        return instantiate(module, imports);
      };
      const { default: init, fingerprint } = await import("${entry}");
      await init();
      console.log(Math.max(...sizes), fingerprint("${VASE}"));`;
    const sizeOf = (module) => readFileSync(join(project, "node_modules/pasu", module)).length;
    const scalar = sizeOf("pasu_scalar_bg.wasm");
    assert.notEqual(scalar, sizeOf("pasu_bg.wasm"));
    const found = ["pasu", "pasu/drawing"].map((entry) => run(project, "old.mjs", script(entry)));
    assert.match(found[0], new RegExp(`^${scalar} [0-9a-z]+\\n$`));
    assert.equal(found[1], found[0]);
  });
});

test("after a crash the next call works on a fresh instance", async () => {
  await inFreshProject(async (project) => {
    const pasu = await import(pathToFileURL(join(project, "node_modules/pasu/pasu.js")).href);
    await pasu.default();
    const before = pasu.fingerprint(VASE);
    // The stack runs out somewhere inside the module, or in a getter that it calls, at every depth and a few bytes apart; the
    // grid is another each time, so that no depth is spared by what was kept from the last.
    const deep = (n) => (n === 0 ? "body" : deep(n - 1));
    const design = pasu.parse(VASE);
    Object.defineProperty(design.parts[0], "name", { enumerable: true, get: () => deep(30) });
    const refusals = [];
    let rows = 3;
    const sink = () => {
      try {
        sink();
      } catch {
        rows = rows === 3 ? 4 : 3;
        try {
          pasu.mesh(design, { rows, columns: 5 });
        } catch (error) {
          refusals.push(error);
          throw error;
        }
      }
    };
    for (let shift = 0; shift < 32; shift += 1) (() => sink())(...Array(shift));
    const inside = refusals.filter((error) => error instanceof pasu.PasuError);
    assert.ok(inside.length > 0 && refusals.length > inside.length, `${inside.length} of ${refusals.length}`);
    for (const error of inside) assert.equal(error.code, "bug", error.message);
    for (const error of refusals) assert.ok(error instanceof pasu.PasuError || error instanceof RangeError, `${error}`);
    assert.equal(pasu.fingerprint(VASE), before);
  });
});

test("what the caller's own getters throw is the caller's", async () => {
  const pasu = await import(pathToFileURL(join(ROOT, "crates/pasu-wasm/pkg/pasu.js")).href);
  await pasu.default();
  for (const thrown of [new Error("mine"), new RangeError("mine"), undefined, "mine", null, 5]) {
    const design = pasu.parse(VASE);
    Object.defineProperty(design.parts[0], "name", {
      enumerable: true,
      get() {
        throw thrown;
      },
    });
    assert.throws(() => pasu.parse(design), { code: "wrong-type", path: "parts[0].name" });
  }
});

test("what cannot be read is the caller's mistake, and the instance lives on", async () => {
  const pasu = await import(pathToFileURL(join(ROOT, "crates/pasu-wasm/pkg/pasu.js")).href);
  await pasu.default();
  const detached = (array) => {
    structuredClone(array, { transfer: [array.buffer] });
    return array;
  };
  const revoked = (value) => {
    const { proxy, revoke } = Proxy.revocable(value, {});
    revoke();
    return proxy;
  };
  const wrong = (path) => ({ name: "PasuError", code: "wrong-type", path });
  assert.throws(() => pasu.evaluate(VASE, 0, detached(new Float64Array(4))), wrong("at"));
  assert.throws(() => pasu.derivatives(VASE, 0, revoked([0, 0])), wrong("at"));
  assert.throws(() => pasu.open(detached(new Uint8Array(4))), wrong("bytes"));
  assert.throws(() => pasu.open(new Proxy(new Uint8Array(4), {})), wrong("bytes"));
  assert.throws(() => pasu.parse(revoked({})), wrong(""));
  for (const call of [pasu.mesh, pasu.bound, pasu.measure, pasu.check, pasu.solid, pasu.sketch]) {
    assert.throws(() => call(VASE, revoked({})), { name: "PasuError", code: "wrong-type" });
    assert.throws(() => call(VASE, 5), { name: "PasuError", code: "wrong-type" });
  }
  const design = pasu.parse(VASE);
  design.parts[0].shape.r = detached(new Float64Array(4));
  assert.throws(() => pasu.link(design), wrong("parts[0].shape.r"));
  const into = { positions: detached(new Float32Array(999)), normals: revoked([]) };
  assert.equal(pasu.mesh(VASE, { rows: 5, columns: 9, into }).positions.length, 3 * 5 * 9);
});

test("what takes long tells how far it is and can be ended", async () => {
  const pasu = await import(pathToFileURL(join(ROOT, "crates/pasu-wasm/pkg/pasu.js")).href);
  await pasu.default();
  const shape = { kind: "second-order", r: [5, 0.4, 3, 0.24], t: [0, 0], n: [1, 8], height: 9 };
  const design = { pasu: 1, parts: [{ shape, wall: { thickness: 0.5, base: 0.5 } }] };
  const calls = {
    mesh: (options) => pasu.mesh(design, { ...options, tolerance: 1e-4 }),
    into: (options) => pasu.mesh(design, { ...options, tolerance: 1e-4, into: {} }),
    measure: (options) => pasu.measure(design, options),
    check: (options) => pasu.check(design, options),
    write: (options) => pasu.write(design, "3mf", options),
    solid: (options) => pasu.solid(design, options),
    paint: (options) => pasu.paint(design, "thickness", { ...options, tolerance: 1e-2 }),
  };
  const mine = new Error("mine");
  for (const [name, call] of Object.entries(calls)) {
    const expected = call({});
    const told = [];
    assert.deepEqual(call({ progress: (done) => void told.push(done) }), expected, name);
    assert.ok(told.length > 1 && told[0] === 0 && told.at(-1) === 1, `${name}: ${told}`);
    assert.deepEqual(
      told,
      told.toSorted((a, b) => a - b),
      name,
    );
    for (const n of [1, 2]) {
      let left = n;
      const ended = { name: "PasuError", code: "cancelled", path: "" };
      assert.throws(() => call({ progress: () => --left > 0 }), ended, name);
      assert.deepEqual(call({}), expected, name);
    }
    const throwing = () => {
      throw mine;
    };
    assert.throws(
      () => call({ progress: throwing }),
      (error) => error === mine,
      name,
    );
    // It cannot call Pasu itself, and may see that.
    assert.throws(() => call({ progress: () => pasu.parse(VASE) }), { name: "PasuError", code: "busy" }, name);
    const codes = new Set();
    const trying = () => {
      try {
        call({});
      } catch (error) {
        codes.add(error.code);
      }
    };
    assert.deepEqual(call({ progress: trying }), expected, name);
    assert.deepEqual([...codes], ["busy"], name);
    assert.throws(() => call({ progress: 5 }), { name: "PasuError", code: "wrong-type", path: "progress" }, name);
    assert.deepEqual(call({ progress: undefined }), expected, name);
  }
  const refused = [];
  assert.throws(() => pasu.solid(VASE, { progress: (done) => refused.push(done) }), { code: "no-wall" });
  assert.ok(!refused.includes(1), `${refused}`);
  const getter = Object.defineProperty({}, "progress", {
    enumerable: true,
    get() {
      throw mine;
    },
  });
  assert.throws(() => pasu.check(VASE, getter), { name: "PasuError", code: "wrong-type" });
});

test("a getter cannot call what reads it", async () => {
  const pasu = await import(pathToFileURL(join(ROOT, "crates/pasu-wasm/pkg/pasu.js")).href);
  await pasu.default();
  const design = pasu.parse(VASE);
  const inner = [];
  const calling = (call) => ({
    enumerable: true,
    get() {
      try {
        return call();
      } catch (error) {
        inner.push(error.code);
        throw error;
      }
    },
  });
  // One that reads itself without end.
  Object.defineProperty(
    design.parts[0],
    "name",
    calling(() => pasu.parse(design).title),
  );
  assert.throws(() => pasu.parse(design), { code: "wrong-type", path: "parts[0].name" });
  assert.deepEqual(inner, ["busy"]);
  // What comes of it is no array, so there are new ones.
  const into = Object.defineProperty(
    {},
    "positions",
    calling(() => pasu.mesh(VASE).positions),
  );
  assert.equal(pasu.mesh(VASE, { rows: 5, columns: 9, into }).positions.length, 3 * 5 * 9);
  assert.deepEqual(inner, ["busy", "busy"]);
  assert.equal(pasu.link(VASE), VASE.slice(1));
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
      for (const { shape } of gallery.slice(0, 6)) {
        const design = { pasu: 1, parts: [{ shape, wall: { thickness: 0.3, base: 0.4, rim: "rounded" } }] };
        for (const format of ["stl", "3mf", "svg"]) hash.update(pasu.write(design, format, { tolerance: 0.1 }));
        hash.update(JSON.stringify(pasu.measure(design))).update(JSON.stringify(pasu.check(design, { tolerance: 0.1 })));
        hash.update(pasu.solid(design, { tolerance: 0.1 }).normals).update(pasu.paint(design, "mean-curvature", { rows: 9, columns: 17 }).values);
        hash.update(pasu.water(design, 3).positions);
        const { normals, water } = pasu.sketch(design, { tolerance: 0.1, fill: 0.5 });
        hash.update(normals).update(water.positions);
      }
      console.log(hash.digest("hex"));`;
    return execFileSync(process.execPath, ["--input-type=module", "--eval", script], { encoding: "utf8" });
  });
  assert.match(hashes[0], /^[0-9a-f]{64}\n$/);
  assert.equal(hashes[1], hashes[0]);
});
