// The package of the element as it is published: what it holds, that a bundler takes it, that its types and its manifest say the same.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { before, test } from "node:test";
import { gzipSync } from "node:zlib";
import { inFreshProject, ROOT } from "./install.mjs";

const WEB = join(ROOT, "web");
const PACKAGE = join(WEB, "pot/pkg");
const VITE = join(WEB, "node_modules/vite/bin/vite.js");
const TSC = join(WEB, "node_modules/typescript/bin/tsc");

before(() => {
  execFileSync(process.execPath, [VITE, "build", "--config", "vite.pot.config.ts", "--logLevel", "error"], {
    cwd: WEB,
  });
});

/** An import of anything but a file beside it. Words of the page may end with "from" too. */
const IMPORT_FROM_ELSEWHERE =
  /\b(?:import|export)\b[^;"'`()]*\bfrom\s*["'](?!\.\/)|\bimport\s*["'](?!\.\/)|\bimport\(\s*["'`](?!\.\/)/;

const inProject = (use) => inFreshProject(use, PACKAGE);

test("the package of the element holds what it promises and nothing else", async () => {
  await inProject((project) => {
    const home = join(project, "node_modules/pasu-pot");
    assert.deepEqual(readdirSync(home).sort(), [
      "LICENSE-APACHE",
      "LICENSE-MIT",
      "README.md",
      "assets",
      "custom-elements.json",
      "design.d.ts",
      "package.json",
      "pasu-pot.d.ts",
      "pasu-pot.js",
    ]);
    const assets = readdirSync(join(home, "assets")).map((file) => file.replace(/-[\w-]{8}\./, "."));
    assert.deepEqual(assets.sort(), [
      "define.js",
      "glaze.js",
      "ground.js",
      "maker.js",
      "pasu_bg.wasm",
      "pasu_drawing_bg.wasm",
      "pasu_scalar_bg.wasm",
      "pot-wall.js",
      "sliders.js",
      "solver.js",
      "stage.js",
      "still-picture.js",
    ]);
    const manifest = JSON.parse(readFileSync(join(home, "package.json"), "utf8"));
    const library = JSON.parse(readFileSync(join(ROOT, "crates/pasu-wasm/pkg/package.json"), "utf8"));
    assert.equal(manifest.version, library.version);
    // Whatever address the files have, they find each other.
    for (const file of [
      "pasu-pot.js",
      ...readdirSync(join(home, "assets")).flatMap((name) => (name.endsWith(".js") ? [`assets/${name}`] : [])),
    ]) {
      assert.doesNotMatch(readFileSync(join(home, file), "utf8"), IMPORT_FROM_ELSEWHERE, file);
    }
  });
});

test("what is fetched before a pot is near, and then, is no more than the documents say", () => {
  const text = readFileSync(join(ROOT, "docs/embedding.md"), "utf8");
  const [, own, then] = /own module \((\d+) kB gzip\) .*?\bthen, once, (\d+) kB/s.exec(text).map(Number);
  const weight = (pattern) => {
    const files = readdirSync(join(PACKAGE, "assets")).filter((file) => pattern.test(file));
    return files.reduce((sum, file) => sum + gzipSync(readFileSync(join(PACKAGE, "assets", file))).length, 0) / 1000;
  };
  const [before, after] = [weight(/^define-/), weight(/^(stage|ground|glaze|solver|pasu_drawing_bg)-/)];
  assert.ok(before > 10 && before <= own, `${before} kB`);
  assert.ok(after > 100 && after <= then, `${after} kB`);
});

test("a bundler takes the element with its worker and its module", async () => {
  await inProject((project) => {
    writeFileSync(join(project, "index.html"), '<!doctype html><script type="module" src="./main.js"></script>');
    writeFileSync(
      join(project, "main.js"),
      'import { PasuPotElement } from "pasu-pot"; document.body.append(new PasuPotElement());',
    );
    execFileSync(process.execPath, [VITE, "build", "--target", "es2022", "--logLevel", "error"], { cwd: project });
    const files = readdirSync(join(project, "dist/assets"));
    const home = join(project, "node_modules/pasu-pot/assets");
    const copied = readdirSync(home).filter((file) => /^(solver|maker)-|\.wasm$/.test(file));
    assert.equal(copied.length, 5);
    for (const name of copied) {
      const bytes = readFileSync(join(home, name));
      assert.ok(
        files.some((file) => readFileSync(join(project, "dist/assets", file)).equals(bytes)),
        `${name} is not among ${files}`,
      );
    }
    // Nobody copies what these would import.
    for (const worker of copied.filter((file) => file.endsWith(".js"))) {
      assert.doesNotMatch(readFileSync(join(home, worker), "utf8"), /\b(?:import\(?|from)\s*["'`]\./, worker);
    }
  });
});

const CONSUMER = `
import { PasuPotElement, type Design, type PotChange, type PotProblem } from "pasu-pot";

const pot = document.createElement("pasu-pot");
pot.src = "#1/bloor-wilson?n1=5";
pot.loading = "eager";
pot.cameraOrbit = String(pot.getCameraOrbit());
const design: Design | null = pot.design;
if (design) pot.design = { ...design, title: "Mine" };
pot.addEventListener("change", ({ detail }) => void (detail satisfies PotChange).link);
pot.addEventListener("error", ({ detail }) => void (detail satisfies PotProblem).code);
pot.addEventListener("pointerdown", ({ clientX }) => void clientX);
const picture: Promise<Blob> = pot.toBlob({ width: 100, height: 100 });
const same: PasuPotElement | null = document.querySelector("pasu-pot");
void picture; void same;
// @ts-expect-error there is no such theme
pot.theme = "sepia";
// @ts-expect-error the link follows the design
pot.link = "#1/second-order";
`;

test("a strict project compiles against the types of the element", async () => {
  await inProject((project) => {
    writeFileSync(join(project, "consumer.ts"), CONSUMER);
    const compilerOptions = {
      target: "ES2022",
      lib: ["ES2022", "DOM"],
      types: [],
      module: "NodeNext",
      moduleResolution: "NodeNext",
      strict: true,
      exactOptionalPropertyTypes: true,
      noEmit: true,
    };
    writeFileSync(join(project, "tsconfig.json"), JSON.stringify({ compilerOptions, include: ["consumer.ts"] }));
    try {
      execFileSync(process.execPath, [TSC, "--project", project], { encoding: "utf8" });
    } catch (error) {
      assert.fail(error.stdout);
    }
  });
});

/** What the manifest lists under a name. */
function listed(kind, key = "name") {
  const manifest = JSON.parse(readFileSync(join(WEB, "pot/custom-elements.json"), "utf8"));
  return manifest.modules[0].declarations[0][kind].map((each) => each[key]);
}

const source = (file) => readFileSync(join(WEB, "src/element/pot", file), "utf8");
const all = (text, pattern) => [...new Set([...text.matchAll(pattern)].map((match) => match[1]))].sort();

test("the manifest lists what there is: attributes, events, slots, parts, custom properties", () => {
  const element = source("pasu-pot.ts");
  const styles = source("pot-styles.ts");
  const properties = all(element, /@property\((?:[^()]|\([^()]*\))*\) (\w+)/g);
  assert.deepEqual(listed("attributes", "fieldName").toSorted(), properties);
  const named = all(element, /attribute: "([a-z-]+)"/g);
  assert.deepEqual(
    listed("attributes")
      .filter((name) => name.includes("-"))
      .toSorted(),
    named,
  );
  assert.deepEqual(listed("events").toSorted(), all(element, /new (?:Custom)?Event\("([a-z-]+)"/g));
  assert.deepEqual(listed("slots").toSorted(), ["", ...all(element, /<slot name="([a-z]+)"/g)]);
  assert.deepEqual(listed("cssParts").toSorted(), all(element, / part="([a-z]+)"/g));
  assert.deepEqual(listed("cssProperties").toSorted(), all(styles, /var\((--(?:pasu-pot|poster)-[a-z]+)/g));
  const documented = readFileSync(join(ROOT, "docs/embedding.md"), "utf8");
  for (const name of [...listed("attributes"), ...listed("events"), ...listed("members"), ...listed("cssProperties")]) {
    assert.ok(documented.includes(`\`${name}`), `docs/embedding.md says nothing of ${name}`);
  }
});
