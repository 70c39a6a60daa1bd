// axe-core, the accessibility checker, inside the page.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { AxeResults, RunOptions } from "axe-core";
import type { Visit } from "./visit.ts";

const source = readFileSync(
  createRequire(new URL("../../web/package.json", import.meta.url)).resolve("axe-core/axe.min.js"),
  "utf8",
);

/** Every finding as one line: the rule, where, and what is wrong. Nothing is excused. */
export async function findings(pot: Pick<Visit, "page">): Promise<string[]> {
  // The debugger's own evaluation is not bound by the page's policy, and nothing of the page is changed. It is half a megabyte, which is sent once.
  if (!(await pot.page.evaluate(() => "axe" in globalThis))) await pot.page.evaluate(`(() => { ${source} })()`);
  const results = await pot.page.evaluate(async () => {
    const { axe } = globalThis as unknown as { axe: { run(options: RunOptions): Promise<AxeResults> } };
    // Every rule runs on everything; what passes is not listed element by element.
    return await axe.run({ resultTypes: ["violations"] });
  });
  if (results.passes.length < 10) throw new Error("axe-core found next to nothing to check");
  return results.violations.flatMap((rule) =>
    rule.nodes.map((node) => `${rule.id}: ${node.target.flat().join(" ")}: ${node.failureSummary ?? rule.help}`),
  );
}
