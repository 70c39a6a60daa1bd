// The types of the package, seen by a strict TypeScript project with and without a bundler.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { inFreshProject, ROOT } from "./install.mjs";

const TSC = join(ROOT, "web/node_modules/typescript/bin/tsc");

const CONSUMER = `
import init, {
  bound, check, type Conversion, convert, type Derivatives, type Design, derivatives, evaluate, fingerprint, type Finding, type Handle, type HandleId, handles, link, type Making, type Measures, measure,
  type Mesh, mesh, objMaterials, open, paint, parse, PasuError, type PasuErrorCode, type Provenance, provenance, pull, pulled, type Report, type Sketch, sketch, type Solid, solid, type Water, water, write,
} from "pasu";
import start, { convert as switched, mesh as drawn, type Mesh as Drawn, PasuError as Refused } from "pasu/drawing";

const ready: Promise<void> = init(new URL("https://example.org/pasu_bg.wasm"));
await ready;
const design: Design = parse({ pasu: 1, parts: [] });
for (const part of design.parts) {
  const { shape } = part;
  switch (shape.kind) {
    case "second-order": { const r: number = shape.r[3]; void r; break; }
    case "mixed-order": { const rise: number = shape.rise; void rise; break; }
    case "fourth-order": { const rm: number = shape.rm; void rm; break; }
    case "bloor-wilson": { const a: number = shape.a; void a; break; }
    case "rings": { const radius: number | undefined = shape.rings[0]?.r.mean; void radius; break; }
    case "boundary-value": { const span: number | "2pi" = shape.span; void span; break; }
    case "vertex-frame": { const corner: number | undefined = shape.patches[0]?.frame[7]; void corner; break; }
    case "octant": { const exponent: number = shape.exponents[2]; void exponent; break; }
    case "blend": { const height: number = shape.start.z; void height; break; }
    default: { const none: never = shape; void none; }
  }
}
const text: string = link(design) + fingerprint(text_of(design));
const made: Mesh = mesh(design, { rows: 3, columns: undefined });
const off: number = made.bound ?? bound(design, { rows: 3, columns: 5 });
const numbers: Float32Array = made.positions;
const indices: Uint32Array = made.indices;
const at: Float64Array = evaluate(design, 0, [0, 0]);
const slopes: Derivatives = derivatives(design, 0, at);
try { parse("#1"); } catch (error) {
  if (error instanceof PasuError) { const code: PasuErrorCode = error.code; const path: string = error.path; void code; void path; }
}
function text_of(design: Design): string { return JSON.stringify(design); }
const making: Making = { product: "pot", size: { height: 12 }, shrinkage: 8, tolerance: 0.02 };
const measures: Measures = measure(design, { fill: 3, density: 2.1 });
const brim: number | undefined = measures.parts[0]?.capacity?.brim.value;
const report: Report = check(design, { ...making, progress: (done) => done < 0.5 });
const findings: Finding[] = report.findings.filter(({ severity }) => severity === "error");
const file: Blob = new Blob([write(design, "3mf", making)]);
const heard: number[] = [];
const drawn_solid: Solid = solid(design, { progress: (done) => void heard.push(done) });
const under_hand: Sketch = sketch(design, { tolerance: 0.02, fill: 0.5 });
const again: Sketch = sketch(design, { into: under_hand });
const level: number | undefined = again.water?.level;
const linings = drawn_solid.faces.filter(({ kind }) => kind === "lining");
const colours: Float32Array = paint(design, "thickness", { rows: 3, columns: 5 }).values;
const wet: Water = water(design, 2);
const kept: string | null = open(new Uint8Array(8));
const clays: Blob = new Blob([objMaterials(), write(design, "obj.zip"), write(design, "a4.svg")]);
const behind: number = pulled(design, 0, { at: [0.5, 0], to: [1, 0, 1], keep: ["r"] }).behind;
const pulled_there: Design = pull(design, 0, { at: at, to: at, width: 0.5, petals: 3 });
const told: Provenance | null = provenance(new Uint8Array(8));
if (told?.making) write(told.link, "stl", told.making);
const fourth: Conversion = convert({ kind: "mixed-order", r: [1, 0, 0.6, 0], rise: -10 }, "fourth-order");
const dragged: readonly Handle[] = handles(fourth.shape).list;
const moved: readonly [HandleId, string | undefined, number | undefined][] = dragged.map(({ id, radial: [step] }) => [id, step?.path, step?.by]);
const level_rise: boolean = switched(fourth.shape, "second-order").lost.includes("rise");
void moved; void level_rise;
void brim; void findings; void file; void linings; void level; void colours; void wet; void kept; void clays;
await start();
const same: Mesh = drawn(design) satisfies Drawn;
const refused: PasuError = new Refused("not-json", "", "");
void same; void refused; void text; void off; void numbers; void indices; void slopes;

// @ts-expect-error an object that is no design
parse({ pot: 1 });
// @ts-expect-error a part is named by its index
evaluate(design, "0", at);
// @ts-expect-error there is no such option
mesh(design, { row: 3 });
// @ts-expect-error a design has a unit of length
const wrong: Design = { pasu: 1, unit: "furlong", parts: [] };
// @ts-expect-error one size is enough
check(design, { size: { height: 1, width: 2 } });
// @ts-expect-error there is no such format
write(design, "doc");
// @ts-expect-error no vase is of third order
convert(fourth.shape, "third-order");
// @ts-expect-error there is no such map
paint(design, "heat");
// @ts-expect-error there is no such kind
const teapot: Design["parts"][number]["shape"] = { kind: "teapot" };
void wrong; void teapot;
`;

for (const [module, moduleResolution] of [
  ["ESNext", "Bundler"],
  ["NodeNext", "NodeNext"],
]) {
  test(`a strict project compiles against the types (${moduleResolution})`, async () => {
    await inFreshProject((project) => {
      writeFileSync(join(project, "consumer.mts"), CONSUMER);
      const compilerOptions = {
        target: "ES2022",
        lib: ["ES2022", "DOM"],
        types: [],
        module,
        moduleResolution,
        strict: true,
        exactOptionalPropertyTypes: true,
        noUncheckedIndexedAccess: true,
        noEmit: true,
        skipLibCheck: false,
      };
      writeFileSync(join(project, "tsconfig.json"), JSON.stringify({ compilerOptions, include: ["consumer.mts"] }));
      try {
        execFileSync(process.execPath, [TSC, "--project", project], { encoding: "utf8" });
      } catch (error) {
        assert.fail(error.stdout);
      }
    });
  });
}

test("the types list exactly the error codes that Rust can give", () => {
  const words = (path, pattern) =>
    [...readFileSync(join(ROOT, path), "utf8").matchAll(pattern)].map((match) => match[1]);
  const rust = words("crates/pasu/src/error.rs", /Code::\w+ => "([a-z-]+)"/g);
  const types = words("crates/pasu-wasm/js/pasu.d.ts", /^ {2}\| "([a-z-]+)"/gm);
  assert.ok(rust.length > 10);
  assert.deepEqual(types.toSorted(), [...rust, "not-ready", "busy"].toSorted());
});
