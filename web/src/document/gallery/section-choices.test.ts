import { expect, test } from "vitest";
import { realMaker } from "../../../testing/real-maker";
import { designOf } from "./exhibit";
import { PLAN_NAMES, vaseBetween } from "./section-choices";

const { maker } = realMaker({ free: true });

test.each(PLAN_NAMES)("from %s into every other section there is a vase that can be made", async (foot) => {
  for (const rim of PLAN_NAMES) {
    const design = designOf(vaseBetween(foot, rim));
    const report = await maker.ask({ kind: "check", design, making: { craft: "clay" } });
    if (report.state !== "done") throw new Error(JSON.stringify(report));
    const found = report.value.findings.filter(({ severity }) => severity !== "note");
    expect([rim, report.value.ok, found.map(({ code, message }) => [code, message])]).toEqual([rim, true, []]);
  }
});
