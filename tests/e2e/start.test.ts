// How the page starts: what it needs is fetched side by side and once, and the solver is compiled while it arrives.

import { expect, test } from "vitest";
import { serve } from "../support/server.ts";
import { stay } from "../support/stay.ts";
import { COARSE, type Visit, visit } from "../support/visit.ts";

const here = stay({}, { ...COARSE, painted: false });

/** Counts by name how the page makes WebAssembly modules. */
async function countCompiling(pot: Visit): Promise<void> {
  await pot.context.addInitScript(() => {
    const counted = globalThis as unknown as { pasuCompiled: string[] };
    counted.pasuCompiled = [];
    for (const name of ["compile", "compileStreaming", "instantiate", "instantiateStreaming"] as const) {
      const real = WebAssembly[name] as (...parameters: unknown[]) => unknown;
      Object.assign(WebAssembly, {
        [name]: (...parameters: unknown[]) => {
          counted.pasuCompiled.push(name);
          return real(...parameters);
        },
      });
    }
  });
}

const compiled = (pot: Visit) =>
  pot.page.evaluate(() => (globalThis as unknown as { pasuCompiled: string[] }).pasuCompiled);

/** What was fetched, in order of asking, with when it was asked for and when it was there, in milliseconds since navigation. */
async function fetched(pot: Visit) {
  return await pot.page.evaluate(() =>
    performance
      .getEntriesByType("resource")
      .map((entry) => entry as PerformanceResourceTiming)
      .map(({ name, startTime, responseEnd }) => ({ file: name.replace(/^.*\//, ""), startTime, responseEnd }))
      .sort((a, b) => a.startTime - b.startTime),
  );
}

test("the solver and the renderer are asked for before either has arrived, and once", async () => {
  const pot = await here.enter();
  await pot.fingerprint();
  const files = await fetched(pot);
  const one = (pattern: RegExp) => {
    const found = files.filter(({ file }) => pattern.test(file));
    expect(found.map(({ file }) => file)).toHaveLength(1);
    return found[0] as (typeof files)[number];
  };
  const wasm = one(/\.wasm$/);
  const renderer = one(/^tableau-/);
  const entry = one(/^index-.*\.js$/);
  expect(wasm.startTime).toBeLessThan(renderer.responseEnd);
  expect(renderer.startTime).toBeLessThan(wasm.responseEnd);
  // Both by the hints of the page itself: no script had to run for that.
  expect(wasm.startTime).toBeLessThan(entry.responseEnd);
  expect(renderer.startTime).toBeLessThan(entry.responseEnd);
});

test("the module is compiled while it arrives", async () => {
  const pot = await here.enter({ before: countCompiling });
  await pot.fingerprint();
  expect(await compiled(pot)).toEqual(["compileStreaming"]);
});

test("a host that does not know the type of the module serves the page all the same", async () => {
  const plain = await serve(
    undefined,
    0,
    (file): Record<string, string> => (file.endsWith(".wasm") ? { "content-type": "application/octet-stream" } : {}),
  );
  try {
    const pot = await visit(here.browser, plain.url, { before: countCompiling });
    await pot.fingerprint();
    expect(await compiled(pot)).toEqual(["compile"]);
    expect(pot.troubles).toEqual([]);
    await pot.leave();
  } finally {
    await plain.close();
  }
});
