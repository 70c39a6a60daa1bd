// The glTF validator: no error and no warning in any GLB. Counts as Node's test runner does.

import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const require = createRequire(fileURLToPath(new URL("../../web/package.json", import.meta.url)));
const validator = require("gltf-validator");

const folder = process.argv[2] ?? "";
const { specimens } = JSON.parse(readFileSync(join(folder, "specimens.json"), "utf8"));
const shown = specimens.filter(({ files }) => files.glb);

const say = (line) => process.stdout.write(`${line}\n`);

/** A sentence for each fault. */
async function judge({ files, triangles }) {
  const { issues, info } = await validator.validateBytes(new Uint8Array(readFileSync(join(folder, files.glb))));
  const faults = issues.messages
    .filter(({ severity }) => severity <= 1)
    .map(({ code, message, pointer }) => `${code} at ${pointer}: ${message}`);
  if (info?.totalTriangleCount !== triangles) {
    faults.push(`number of triangles is ${info?.totalTriangleCount}, expected ${triangles}`);
  }
  return faults;
}

/** The GLB with another text of the same length in its JSON. */
function edited({ name, files, ...others }, pattern, by, damage) {
  const text = readFileSync(join(folder, files.glb), "latin1");
  const changed = text.replace(pattern, (found) => by.padEnd(found.length).slice(0, found.length));
  if (changed === text) throw new Error(`the file has no ${pattern}`);
  const glb = `damaged/glTF-validator/${damage.replaceAll(" ", "-")}.glb`;
  mkdirSync(join(folder, "damaged/glTF-validator"), { recursive: true });
  writeFileSync(join(folder, glb), changed, "latin1");
  return { ...others, name: `${name} ${damage}`, files: { glb } };
}

let passed = 0;
let failed = 0;
for (const specimen of shown) {
  const faults = await judge(specimen);
  for (const fault of faults) say(`not ok: ${specimen.name}: glTF validator: ${fault}`);
  if (faults.length > 0) failed += 1;
  else passed += 1;
}
for (const [damaged, words] of [
  [edited(shown[0], /"version":"2.0"/, '"version":"9.0"', "of another version"), "UNKNOWN_ASSET_MAJOR_VERSION"],
  [edited(shown[0], /"componentType":5126/, '"componentType":5999', "of unknown numbers"), "VALUE_NOT_IN_LIST"],
]) {
  const faults = await judge(damaged);
  const right = faults.find((fault) => fault.startsWith(words));
  if (right) passed += 1;
  else failed += 1;
  const verdict = right ? "refused, as it must be" : "not ok";
  say(`${verdict}: ${damaged.name}: glTF validator: ${right ?? `expected a fault \`${words} ..\`, found ${faults}`}`);
}
say(`# pass ${passed}\n# fail ${failed}`);
process.exitCode = failed > 0 ? 1 : 0;
