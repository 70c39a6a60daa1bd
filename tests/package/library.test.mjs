// The package as it is published, in Node without a bundler.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { inFreshProject, ROOT, run } from "./install.mjs";

const VASE = "#1/bloor-wilson?n1=5";

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
      "answers.d.ts",
      "bindings.js",
      "design.d.ts",
      "drawing.d.ts",
      "drawing.js",
      "drawing_bindings.js",
      "known.js",
      "package.json",
      "pasu.d.ts",
      "pasu.js",
      "pasu_bg.wasm",
      "pasu_drawing_bg.wasm",
      "pasu_scalar_bg.wasm",
      "wrapper.js",
    ]);
  });
});

test("the examples of both README files run", async () => {
  await inFreshProject((project) => {
    const long = run(project, "long.mjs", javascriptOf("README.md"));
    const [drawn, held, written, refused] = long.split("\n");
    assert.match(drawn, /^\d+ vertices, \d+ triangles, #1\/bloor-wilson\?n1=5$/);
    assert.match(held, /^holds 0\.9\d{2} cm3, can be made: true$/);
    assert.match(written, /^\d{5,} bytes for a printer$/);
    assert.match(refused, /^unit: .+$/);
    const short = run(project, "short.mjs", javascriptOf("crates/pasu-wasm/js/README.md"));
    assert.match(short, /^\d+ triangles: 1\/bloor-wilson\?n1=5\n$/);
  });
});

/** Three domes in a row, and one apart from them; a point on the first is higher by so much. */
function network(z = 0) {
  const vertices = [];
  const patches = [];
  for (const x of [0, 2, 4, 20]) {
    const first = vertices.length;
    const around = [
      [0, 0],
      [1, 0],
      [2, 0],
      [2, 1],
      [2, 2],
      [1, 2],
      [0, 2],
      [0, 1],
    ];
    vertices.push(...around.map(([a, b]) => [x + a, b, a === 1 || b === 1 ? 2 : 0]));
    const frame = around.map((_, place) => first + place);
    // The last side of the one before is the first of this one.
    if (x === 2 || x === 4)
      for (const [own, other] of [
        [0, 2],
        [7, 3],
        [6, 4],
      ])
        frame[own] = patches.at(-1).frame[other];
    patches.push({ frame });
  }
  vertices[1] = [1, 0, 2 + z];
  return { pasu: 1, parts: [{ shape: { kind: "vertex-frame", vertices, patches } }] };
}

test("a network whose points are moved is told by what of its mesh is another", async () => {
  await inFreshProject(async (project) => {
    for (const entry of ["pasu.js", "drawing.js"]) {
      const pasu = await import(pathToFileURL(join(project, "node_modules/pasu", entry)).href);
      await pasu.default();
      await pasu.widen?.();
      const grid = { rows: 10, columns: 10 };
      const { mesh, moved } = pasu.follow(network(), grid);
      assert.deepEqual(mesh, pasu.follow(network(), grid).mesh);
      for (const none of [undefined, null, {}])
        assert.deepEqual(pasu.follow(network(), none).mesh, pasu.mesh(network()));
      // Somebody else has asked meanwhile.
      assert.equal(moved([1, 1, 0, 0.5]), undefined);
      const { mesh: now, moved: on } = pasu.follow(network(), grid);
      for (const z of [0.5, 0.75]) {
        const { ranges, positions, normals } = on(Float64Array.of(1, 1, 0, 2 + z));
        let next = 0;
        let count = 0;
        for (let pair = 0; pair < ranges.length; pair += 2) {
          for (const [all, some] of [
            [now.positions, positions],
            [now.normals, normals],
          ])
            all.set(some.subarray(next, next + 3 * ranges[pair + 1]), 3 * ranges[pair]);
          next += 3 * ranges[pair + 1];
          count += ranges[pair + 1];
        }
        assert.equal(next, positions.length);
        assert.ok(count > 0 && count < now.positions.length / 3);
        const whole = pasu.mesh(network(z), grid);
        assert.deepEqual([now.positions, now.normals], [whole.positions, whole.normals]);
        // That was of the design that follows.
        assert.ok(on([]) !== undefined);
      }
      const refused = (moves, code, path) => assert.throws(() => on(moves), { name: "PasuError", code, path });
      refused([1, 2], "wrong-type", "moves");
      refused("here", "wrong-type", "moves");
      refused([1.5, 0, 0, 0], "no-such-point", "moves[0]");
      refused([99, 0, 0, 0], "no-such-point", "parts[0].shape.vertices[99]");
      refused([1, 0, Number.NaN, 0], "not-finite", "parts[0].shape.vertices[1][1]");
      refused([2, 0, 0, 0], "pinched-surface", "parts[0].shape.patches[0].frame");
      assert.throws(() => pasu.follow(VASE, grid).moved([0, 0, 0, 0]), {
        code: "unsupported-shape",
        path: "parts[0].shape",
      });
    }
  });
});

test("a vase comes in another order, and a hand learns what it drags, from both entries", async () => {
  await inFreshProject(async (project) => {
    for (const entry of ["pasu.js", "drawing.js"]) {
      const pasu = await import(pathToFileURL(join(project, "node_modules/pasu", entry)).href);
      await pasu.default();
      const shape = { kind: "second-order", r: [1, 0.1, 0.6, 0.06], height: 4 };
      const { shape: fourth, lost } = pasu.convert(shape, "fourth-order");
      assert.deepEqual([fourth.kind, fourth.r1, fourth.r0, fourth.h1, lost], ["fourth-order", 1, 0.6, 4, ["petals"]]);
      const { rim, list } = pasu.handles(fourth);
      assert.equal(rim, "end");
      assert.deepEqual(
        list.map(({ id }) => id),
        ["rim", "rim-slope", "foot-slope", "foot"],
      );
      assert.deepEqual(list[0], {
        id: "rim",
        radial: [
          { path: "r1", by: 1 },
          { path: "rm", by: 0.25 },
        ],
        axial: [{ path: "h1", by: 1 }],
        restraints: [],
      });
      assert.throws(() => pasu.convert(shape, "third-order"), {
        name: "PasuError",
        code: "unknown-name",
        path: "order",
      });
      assert.throws(() => pasu.handles(), { name: "PasuError", code: "wrong-type", path: "shape" });
    }
  });
});

test("a point that is pulled comes along, or tells how far it stayed behind", async () => {
  await inFreshProject((project) => {
    const printed = run(
      project,
      "pull.mjs",
      `
      import assert from "node:assert/strict";
      import init, * as pasu from "pasu";
      await init();
      const [x, y, z] = pasu.evaluate("#1/fourth-order", 0, [0.5, 0]);
      const hand = { at: [0.5, 0], to: [x + 0.3, y, z], keep: ["r0"] };
      const design = pasu.pull("#1/fourth-order", 0, hand);
      const moved = pasu.evaluate(design, 0, hand.at);
      assert.ok(Math.hypot(moved[0] - x - 0.3, moved[1] - y, moved[2] - z) < 1e-9);
      assert.deepEqual(pasu.parse(design), design);
      assert.equal(design.parts[0].shape.r0, 0.4);
      const { design: same, behind } = pasu.pulled("#1/fourth-order", 0, { ...hand, to: Float64Array.of(x + 0.3, y + 0.2, z) });
      assert.ok(Math.abs(behind - 0.2) < 1e-9);
      const there = pasu.evaluate(same, 0, hand.at);
      assert.ok(Math.hypot(there[0] - moved[0], there[1] - moved[1], there[2] - moved[2]) < 1e-9);
      const spout = { at: [1, 0], to: [3.4, 0, 20.5], width: 0.8 };
      const jug = pasu.pulled("#1/rings", 0, spout);
      assert.deepEqual(jug.at, [1, 0]);
      const lip = pasu.evaluate(jug.design, 0, jug.at);
      assert.ok(Math.hypot(lip[0] - 3.4, lip[1], lip[2] - 20.5) < 1e-9);
      const refused = (hand, code, path) =>
        assert.throws(() => pasu.pull("#1/fourth-order", 0, hand), { name: "PasuError", code, path });
      refused(undefined, "wrong-type", "hand");
      refused({ to: [0, 0, 0] }, "missing-field", "at");
      refused({ at: [0.5], to: [0, 0, 0] }, "wrong-type", "at");
      refused({ ...hand, to: [0, 0, NaN] }, "not-finite", "to[2]");
      refused({ ...hand, at: [2, 0] }, "no-such-point", "at[0]");
      refused({ ...hand, petals: 1.5 }, "out-of-range", "petals");
      refused({ ...hand, petals: 4294967295 }, "out-of-range", "petals");
      refused({ ...hand, keep: ["belly"] }, "unknown-name", "keep[0]");
      refused({ ...hand, sideways: 1 }, "unknown-field", "sideways");
      console.log("pulled");
      `,
    );
    assert.equal(printed, "pulled\n");
  });
});

test("what is no pot of rings becomes one: a vase of another kind, and a drawn line", async () => {
  await inFreshProject((project) => {
    const printed = run(
      project,
      "fit.mjs",
      `
      import assert from "node:assert/strict";
      import init, * as pasu from "pasu";
      await init();
      const freed = pasu.free("#1/fourth-order", 0, { tolerance: 0.001 });
      assert.equal(freed.design.parts[0].shape.kind, "rings");
      assert.ok(freed.distance > 0 && freed.distance <= 0.001);
      assert.deepEqual(pasu.parse(freed.design), freed.design);
      const bottle = pasu.fit({ right: [4, 0, 5, 10, 2, 14, 2, 20] }, { tolerance: 0.01 });
      const { rings } = bottle.design.parts[0].shape;
      assert.deepEqual(rings.map(({ sharp }) => sharp ?? false), [false, true, true, false]);
      assert.ok(bottle.distance <= 0.01);
      const right = Float64Array.of(3, 0, 4, 10);
      const leaning = pasu.fit({ right, left: [3, 0, 5, 12] }, { tolerance: 0.01 }).design;
      const [x, , z] = pasu.evaluate(leaning, 0, [1, Math.PI]);
      assert.ok(Math.abs(x + 5) < 0.01 && Math.abs(z - 12) < 0.01);
      const refused = (call, code, path) => assert.throws(call, { name: "PasuError", code, path });
      refused(() => pasu.free("#1/fourth-order", 0), "wrong-type", "options");
      refused(() => pasu.free("#1/fourth-order", 1, { tolerance: 1 }), "no-such-point", "part");
      refused(() => pasu.free("#1/fourth-order", 0, { tolerance: 0 }), "out-of-range", "tolerance");
      refused(() => pasu.fit({ right: [1, 2] }, { tolerance: 1 }), "wrong-type", "right");
      refused(() => pasu.fit({ right: [1, 2, 1, NaN] }, { tolerance: 1 }), "not-finite", "right[3]");
      refused(() => pasu.fit({ tolerance: 1 }), "unknown-field", "tolerance");
      // A scan: a cup with petals, away from the origin.
      const cup = pasu.parse({
        pasu: 1,
        parts: [
          {
            shape: {
              kind: "rings",
              rings: [
                { u: 0, r: { mean: 3, waves: [{ n: 6, cos: 0.2 }] }, z: { mean: 0 } },
                { u: 1, r: { mean: 4 }, z: { mean: 8 } },
              ],
            },
            place: { shift: [5, 0, 1] },
          },
        ],
      });
      const { positions, indices } = pasu.mesh(cup, { rows: 120, columns: 181 });
      const scanned = pasu.fit({ positions, indices }, { tolerance: 0.05 });
      assert(scanned.distance <= 0.05 && scanned.rms <= scanned.distance && scanned.withoutHandle === null);
      assert(Math.abs(scanned.design.parts[0].place.shift[0] - 5) < 0.01);
      const levels = pasu.levels({ positions, indices });
      assert.ok(levels.heights instanceof Float64Array && levels.radii.length === levels.heights.length);
      assert.ok(levels.radii.every((section) => section instanceof Float64Array && section.length === 180));
      const { away, ...found } = pasu.fit(levels, { tolerance: 0.05 });
      assert.deepEqual(found, scanned);
      assert.equal(away.length % levels.heights.length, 0);
      assert.ok(Math.abs(Math.max(...away.map(Math.abs)) - found.distance) < 1e-6);
      refused(() => pasu.levels({}), "wrong-type", "positions");
      refused(() => pasu.levels({ positions: new Float32Array(9) }), "unsupported-shape", "positions");
      const { heights, radii } = levels;
      refused(() => pasu.fit({ heights: [0, 1], radii }, { tolerance: 1 }), "wrong-type", "heights");
      refused(() => pasu.fit({ heights }, { tolerance: 1 }), "wrong-type", "radii");
      refused(() => pasu.fit({ heights, radii: [[1, 2]] }, { tolerance: 1 }), "wrong-type", "radii[0]");
      refused(() => pasu.fit({ heights, radii: Array(1e9) }, { tolerance: 1 }), "too-large", "radii");
      refused(() => pasu.fit({ heights, radii: [new Float64Array(181)] }, { tolerance: 1 }), "too-large", "radii[0]");
      refused(() => pasu.fit({ ...levels, axis: "x" }, { tolerance: 1 }), "wrong-type", "axis");
      refused(() => pasu.fit({ positions: [1, 2, 3] }, { tolerance: 1 }), "wrong-type", "positions");
      refused(() => pasu.fit({ positions, indices: [0, 1, 2] }, { tolerance: 1 }), "wrong-type", "indices");
      refused(() => pasu.fit({ positions, indices: new Uint32Array([0, 1, 1e9]) }, { tolerance: 1 }), "out-of-range", "indices[2]");
      const gone = new Float32Array(9);
      structuredClone(gone.buffer, { transfer: [gone.buffer] });
      refused(() => pasu.fit({ positions: gone }, { tolerance: 1 }), "wrong-type", "positions");
      refused(() => pasu.fit({ get positions() { throw new Error("no"); } }, { tolerance: 1 }), "wrong-type", "positions");
      console.log("fitted");
      `,
    );
    assert.equal(printed, "fitted\n");
  });
});

test("a refusal says where in space the pot went wrong", async () => {
  await inFreshProject(async (project) => {
    const pasu = await import(pathToFileURL(join(project, "node_modules/pasu/pasu.js")).href);
    await pasu.default();
    const shape = { kind: "second-order", r: [2, 0, -2, 0], t: [0, 0], n: [1, 2], height: 5 };
    const design = { pasu: 1, parts: [{ shape, wall: { thickness: 0.2, base: 0.3 } }] };
    assert.throws(
      () => pasu.solid(design),
      ({ code, path, place }) => {
        assert.deepEqual([code, path], ["pinched-surface", "parts[0].shape"]);
        assert.deepEqual(
          place.map((x) => Math.round(1e9 * x) / 1e9 + 0),
          [0, 0, 2.5],
        );
        return true;
      },
    );
  });
});

test("a file opens the design again, and can be saved as it is", async () => {
  const pasu = await import(pathToFileURL(join(ROOT, "crates/pasu-wasm/pkg/pasu.js")).href);
  await pasu.default();
  const wall = { thickness: 0.2, base: 0.2 };
  const design = pasu.parse({ pasu: 1, parts: [{ shape: pasu.parse(VASE).parts[0].shape, wall }] });
  const bytes = pasu.write(design, "3mf", { size: { height: 12 }, tolerance: 0.05 });
  assert.ok(bytes instanceof Uint8Array && bytes.byteOffset === 0 && bytes.buffer.byteLength === bytes.length);
  assert.deepEqual(pasu.parse(pasu.open(bytes)), design);
  assert.equal(pasu.open(new Uint8Array(4)), null);
  const making = { product: "pot", size: { height: 12 }, shrinkage: 0, tolerance: 0.05 };
  assert.deepEqual(pasu.provenance(bytes), { link: pasu.link(design), making });
  assert.equal(pasu.provenance(new Uint8Array(4)), null);
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

test("meshes of one topology share no array", async () => {
  await inFreshProject(async (project) => {
    const pasu = await import(pathToFileURL(join(project, "node_modules/pasu/pasu.js")).href);
    await pasu.default();
    const grid = { rows: 9, columns: 17 };
    const keys = ["bound", "groups", "indices", "normals", "positions", "topology", "uvs"];
    const meshes = [0, 1, 2, 3].map(() => pasu.mesh(VASE, grid));
    const { indices, uvs, groups } = pasu.mesh(VASE, { ...grid, into: {} });
    for (const mesh of meshes) {
      assert.deepEqual(Object.keys(mesh).sort(), keys);
      assert.deepEqual([mesh.indices, mesh.uvs, mesh.groups], [indices, uvs, groups]);
      assert.equal(mesh.indices, mesh.indices);
      // Written over or given away, they are missing in no other mesh.
      mesh.indices.fill(7);
      const given = structuredClone(mesh, { transfer: [mesh.uvs.buffer, mesh.positions.buffer] });
      assert.deepEqual([given.uvs, given.groups, mesh.uvs.length], [uvs, groups, 0]);
      mesh.groups = undefined;
      assert.equal(mesh.groups, undefined);
    }
    // Another topology, and the first one again.
    assert.equal(pasu.mesh(VASE, { rows: 12, columns: 17 }).indices.length, 6 * 11 * 16);
    for (let i = 0; i < 3; i++) assert.deepEqual(pasu.mesh(VASE, grid).indices, indices);
  });
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
  assert.deepEqual(Object.keys(bare).sort(), ["bound", "normals", "positions", "topology"]);
  assert.deepEqual(bare.positions, pasu.mesh(VASE, grid).positions);

  const finer = pasu.mesh(VASE, { rows: 10, columns: 17, into: first });
  assert.notEqual(finer.positions, positions);
  assert.deepEqual(finer, pasu.mesh(VASE, { rows: 10, columns: 17 }));

  for (const into of [null, 5, [], { positions: new Float64Array(9 * 17 * 3), indices: "none" }]) {
    assert.deepEqual(pasu.mesh(VASE, { ...grid, into }), pasu.mesh(VASE, grid));
  }
});

test("a list or a word in the place of options is refused by every function that takes some", async () => {
  const pasu = await import(pathToFileURL(join(ROOT, "crates/pasu-wasm/pkg/pasu.js")).href);
  await pasu.default();
  const calls = {
    mesh: (options) => pasu.mesh(VASE, options),
    bound: (options) => pasu.bound(VASE, options),
    sketch: (options) => pasu.sketch(VASE, options),
    measure: (options) => pasu.measure(VASE, options),
    solid: (options) => pasu.solid(VASE, options),
    constraints: (options) => pasu.constraints(VASE, options),
  };
  for (const [name, call] of Object.entries(calls)) {
    for (const options of [[], [1], "coarse", 5, true]) {
      assert.throws(() => call(options), { name: "PasuError", code: "wrong-type" }, `${name} ${options}`);
    }
    for (const none of [undefined, null, {}]) {
      let refusal;
      try {
        call(none);
      } catch (error) {
        refusal = error.code;
      }
      assert.notEqual(refusal, "wrong-type", `${name} ${none}`);
    }
  }
});

test("a network of patches is read, evaluated, meshed, measured and written", async () => {
  await inFreshProject((project) => {
    const text = `
      import init, { check, evaluate, link, mesh, parse, write } from "pasu";
      await init();
      const round = [[-1, -1], [0, -1], [1, -1], [1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0]];
      const vertices = [];
      const patches = [0, 1, 2, 3, 4, 5].map((face) => ({
        frame: round.map(([a, b]) => {
          const at = [0, 0, 0].fill(face % 2 === 0 ? -1 : 1);
          at[(Math.floor(face / 2) + 1) % 3] = a;
          at[(Math.floor(face / 2) + 2) % 3] = b;
          const known = vertices.findIndex((each) => each.join() === at.join());
          return known === -1 ? vertices.push(at) - 1 : known;
        }),
      }));
      const design = parse({ pasu: 1, parts: [{ shape: { kind: "vertex-frame", vertices, patches } }] });
      console.log(design.parts[0].shape.patches.length, link(design).startsWith("1~"));
      console.log([...evaluate(design, 0, [1, 0.5, 0.5, 0, 0, 0])].join());
      console.log(mesh(design, { tolerance: 0.01 }).indices.length / 3, check(design).ok, check(design).meshes[0].genus);
      console.log(new DataView(write(design, "stl").buffer).getUint32(80, true));
      try {
        evaluate(design, 0, [6, 0, 0]);
      } catch ({ code, path }) {
        console.log(code, path);
      }
    `;
    assert.deepEqual(run(project, "network.mjs", text).trim().split("\n"), [
      "6 true",
      "1,0,0,-1,-1,-1",
      "12 true 0",
      "12",
      "no-such-point at[0]",
    ]);
  });
});

test("a scene says what is where and whether it keeps its constraints", async () => {
  await inFreshProject((project) => {
    const text = `
      import init, { at, constraints, pick } from "pasu";
      await init();
      const ball = (x, object) => ({ object, shape: { kind: "octant", exponents: [2, 2, 2] }, place: { shift: [x, 0, 0] } });
      const scene = { pasu: 1, parts: [ball(0, 0), ball(0.5, 1)] };
      const hits = pick(scene, { origin: [0.6, 0.1, -1], direction: [0, 0, 2] });
      console.log(hits.map(({ part, patch }) => [part, patch].join()).join(" "), hits[0].distance, hits[0].normal.join());
      console.log(at(scene, [0.6, 0.2, 0.15]).map(({ part, distance }) => part + " " + distance.toFixed(6)).join(" "));
      const { isKept, breaches } = constraints(scene, { slack: 0.001, progress: () => true });
      console.log(isKept, breaches.map(({ code, isProved }) => [code, isProved].join()).join(" "));
      try {
        pick(scene, { origin: [0, 0, Number.NaN], direction: [0, 0, 1] });
      } catch ({ code, path }) {
        console.log(code, path);
      }
    `;
    assert.deepEqual(run(project, "space.mjs", text).trim().split("\n"), [
      "0,3 1,3 0,0 1,0 1 0,0,-1",
      "1 0.100000 0 0.150000",
      "false interference,true",
      "not-finite ray.origin[2]",
    ]);
  });
});

test("a scene that is asked again is known by what it says, and as the same object only where nothing of it can change", async () => {
  await inFreshProject((project) => {
    const text = `
      import init, { at, pick } from "pasu";
      await init();
      const ball = (x) => ({ shape: { kind: "octant", exponents: [2, 2, 2] }, place: { shift: [x, 0, 0] } });
      const ray = { origin: [0.6, 0.1, -1], direction: [0, 0, 1] };
      const said = (scene, about = ray) => {
        try {
          return pick(scene, about).map(({ part }) => part).join();
        } catch ({ code, path }) {
          return code + " " + path;
        }
      };
      const scene = { pasu: 1, parts: [ball(0), ball(0.5)] };
      console.log(said(scene), said(scene), at(scene, [0.6, 0.2, 0.15]).map(({ part }) => part).join());
      // Changed where it is, and back: the answers are those of what it says now.
      scene.parts[1].place.shift[0] = 5;
      console.log(said(scene), at(scene, [0.6, 0.2, 0.15]).map(({ part }) => part).join());
      scene.parts[1].place.shift[0] = 0.5;
      console.log(said(scene), said(structuredClone(scene)));
      // Of what is known the ray is read as strictly.
      console.log(said(scene, { ...ray, origin: [0, 0, Number.NaN] }), "|", said(scene, { ...ray, more: 1 }));
      // What would be one text is not one design, and what is refused of it stays refused.
      for (const x of [Number.NaN, null, undefined, "0", [0.5]]) {
        scene.parts[1].place.shift[0] = x;
        console.log(said(scene), "|", said(scene));
      }
      scene.parts[1].place.shift = new Float64Array([0.5, 0, 0]);
      console.log(said(scene));
      scene.parts[1].place.shift[0] = 5;
      console.log(said(scene));
      scene.parts[1].place.shift = { 0: 0.5, 1: 0, 2: 0 };
      console.log(said(scene));
      scene.parts[1] = ball(0.5);
      console.log(said(scene));
      scene.parts[1].extra = 1;
      console.log(said(scene));
      delete scene.parts[1].extra;
      // A getter is asked, whatever it said before; what it throws is refused, and a call from within it too.
      let x = 0.5;
      Object.defineProperty(scene.parts[1].place, "shift", { enumerable: true, get: () => [x, 0, 0] });
      console.log(said(scene), said(scene));
      x = 5;
      console.log(said(scene));
      let calls = 0;
      Object.defineProperty(scene.parts[1], "wall", { enumerable: true, configurable: true, get: () => (calls++, pick(scene, ray)) });
      console.log(said(scene), calls < 100);
      Object.defineProperty(scene.parts[1], "wall", { enumerable: true, get: () => { throw new Error("no"); } });
      console.log(said(scene));
      const round = { pasu: 1, parts: [] };
      round.parts.push(round);
      console.log(said(round));
      const { proxy, revoke } = Proxy.revocable({ pasu: 1, parts: [ball(0)] }, {});
      console.log(said(proxy), said(proxy));
      revoke();
      console.log(said(proxy));
      // Texts are known by what they say as well; another one is read.
      const written = (x) => JSON.stringify({ pasu: 1, parts: [ball(0), ball(x)] });
      console.log(said(written(0.5)), said(written(0.5)), said(written(5)), said("no design"), said(written(0.5)));
      // What is frozen through and through is not looked at again; what only seems to be is.
      const freeze = (value) => (Object.values(value).filter((each) => each instanceof Object).forEach(freeze), Object.freeze(value));
      const fixed = freeze({ pasu: 1, parts: [ball(0), ball(0.5)] });
      console.log(said(fixed), said(fixed), said({ ...fixed, parts: [ball(0), ball(5)] }), said(fixed));
      const half = Object.freeze({ pasu: 1, parts: Object.freeze([ball(0), ball(0.5)]) });
      console.log(said(half));
      half.parts[1].place.shift[0] = 5;
      console.log(said(half));
      x = 0.5;
      const computed = freeze({ pasu: 1, get parts() { return [ball(0), ball(x)]; } });
      console.log(said(computed));
      x = 5;
      console.log(said(computed));
    `;
    assert.deepEqual(run(project, "again.mjs", text).trim().split("\n"), [
      "0,1,0,1 0,1,0,1 1,0",
      "0,0 0",
      "0,1,0,1 0,1,0,1",
      "not-finite ray.origin[2] | unknown-field ray.more",
      "not-finite parts[1].place.shift[0] | not-finite parts[1].place.shift[0]",
      ...Array(4).fill("wrong-type parts[1].place.shift[0] | wrong-type parts[1].place.shift[0]"),
      "0,1,0,1",
      "0,0",
      "wrong-type parts[1].place.shift",
      "0,1,0,1",
      "unknown-field parts[1].extra",
      "0,1,0,1 0,1,0,1",
      "0,0",
      "wrong-type parts[1].wall true",
      "wrong-type parts[1].wall",
      "too-large ",
      "0,0 0,0",
      "wrong-type ",
      "0,1,0,1 0,1,0,1 0,0 damaged-link  0,1,0,1",
      "0,1,0,1 0,1,0,1 0,0 0,1,0,1",
      "0,1,0,1",
      "0,0",
      "0,1,0,1",
      "0,0",
    ]);
  });
});
