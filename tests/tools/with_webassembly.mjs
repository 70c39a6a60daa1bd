// The package as it ships: its module writes, byte for byte, the files of the native build. Counts as Node's test runner does.

import { readFileSync } from "node:fs";
import { join } from "node:path";

const pasu = await import(new URL("../../crates/pasu-wasm/pkg/pasu.js", import.meta.url));
await pasu.default();

const folder = process.argv[2] ?? "";
const { specimens } = JSON.parse(readFileSync(join(folder, "specimens.json"), "utf8"));
const say = (line) => process.stdout.write(`${line}\n`);

/** A sentence for each file that differs, or that cannot be written. */
function judge({ link, making, files }, kinds) {
  return kinds.flatMap((kind) => {
    const native = readFileSync(join(folder, files[kind]));
    try {
      const written = Buffer.from(pasu.write(link, kind, making));
      if (written.equals(native)) return [];
      const at = written.findIndex((byte, index) => byte !== native[index]);
      return [`${kind} has ${written.length} bytes, expected ${native.length}; the first that differs is at ${at}`];
    } catch (error) {
      return [`${kind}: ${error.code} at ${error.path}: ${error.message}`];
    }
  });
}

let passed = 0;
let failed = 0;
for (const [index, specimen] of specimens.entries()) {
  // Every format is written of some specimens, and one of each of all: they hold the same triangles.
  const kinds = Object.keys(specimen.files);
  const faults = judge(specimen, [kinds[index % kinds.length]]);
  for (const fault of faults) say(`not ok: ${specimen.name}: WebAssembly: ${fault}`);
  if (faults.length > 0) failed += 1;
  else passed += 1;
}
const [first] = specimens;
const other = { ...first, making: { ...first.making, shrinkage: 1e-9 } };
const [fault] = judge(other, ["stl"]);
if (fault) passed += 1;
else failed += 1;
say(
  `${fault ? "refused, as it must be" : "not ok"}: ${first.name} of another size: WebAssembly: ${fault ?? "the same"}`,
);
say(`# pass ${passed}\n# fail ${failed}`);
process.exitCode = failed > 0 ? 1 : 0;
