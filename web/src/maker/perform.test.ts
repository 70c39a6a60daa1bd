import { expect, test } from "vitest";
import { POT as design } from "../../testing/jar";
import { realMaker } from "../../testing/real-maker";

test("a check and a file tell how far they are, from the beginning to the end, and other work does not", async () => {
  const { maker } = realMaker({ free: true });
  const told = { check: [] as number[], write: [] as number[], measure: [] as number[] };
  const check = await maker.ask({ kind: "check", design, making: {} }, "check", (done) => told.check.push(done));
  const write = await maker.ask({ kind: "write", design, format: "stl", making: {} }, "write", (done) =>
    told.write.push(done),
  );
  await maker.ask({ kind: "measure", design, product: "pot", fill: null }, "measure", (done) =>
    told.measure.push(done),
  );
  expect(check.state).toBe("done");
  expect(write.state === "done" && write.value.bytes.length).toBeGreaterThan(84);
  for (const heard of [told.check, told.write]) {
    expect(heard.length).toBeGreaterThan(0);
    expect(heard).toEqual([...heard].sort((a, b) => a - b));
    expect(heard.every((done) => 0 <= done && done <= 1)).toBe(true);
    expect(heard.at(-1)).toBe(1);
  }
  expect(told.measure).toEqual([]);
});
