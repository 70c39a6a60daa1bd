// The same bytes everywhere: natively (the golden file), in Node and in Chromium, by the one module.

import { readFileSync } from "node:fs";
import init, { fingerprint, link } from "pasu";
import { beforeAll, expect, test } from "vitest";
import { stay } from "../support/stay.ts";

interface Case {
  readonly name: string;
  readonly family?: object;
  readonly shape: object;
}

const read = (path: string): unknown => JSON.parse(readFileSync(new URL(path, import.meta.url), "utf8"));
const corpus = read("../reference/surfaces.json") as Case[];
const goldens = read("../goldens/fingerprints.json") as Record<string, string>;

/** Numbers need no pictures, and those take most of the time in software. */
const here = stay({ webgl: false });
beforeAll(() => init());

test("every surface of the corpus has the same fingerprint in Chromium, in Node and natively", {
  timeout: 150_000,
}, async () => {
  const found: Record<string, string> = {};
  const pot = await here.enter();
  let before = await pot.fingerprint();
  for (const { name, family, shape } of corpus) {
    const address = link({ pasu: 1, parts: [{ shape: family ?? shape }] });
    expect(fingerprint(address), `${name} in Node`).toBe(goldens[name]);
    await pot.openLink(`#${address}`);
    before = await pot.fingerprintOtherThan(before);
    found[name] = before;
  }
  expect(found).toEqual(goldens);
});
