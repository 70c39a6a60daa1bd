import { expect, test } from "vitest";
import { settled } from "../../testing/held-worker";
import { tall } from "../../testing/jar";
import { realSolver } from "../../testing/real-solver";
import { Page } from "../../testing/surroundings";
import { compareWith } from "../state/actions";
import { Designer } from "./designer";

test("all that follows the document begins with the first pot, can be left, and followed again", async () => {
  const page = new Page();
  const { solver, worker } = realSolver({ free: true });
  const designer = new Designer(solver, page);
  const { comparison, opening, store, surface } = designer;
  surface.grid = () => ({ rows: 13, columns: 25 });
  const rests = async () => {
    while (surface.settled === null) await settled();
  };
  const leave = designer.connect();
  await opening.start();
  await rests();
  designer.apply({ design: tall(store.design, 21), undo: "step" });
  await rests();
  expect(page.hash).toContain("h1=21");
  leave();
  const before = worker.sent.length;
  designer.apply({ design: tall(store.design, 22), undo: "step" });
  designer.apply(compareWith("mixed-order"));
  await settled();
  expect(worker.sent).toHaveLength(before);
  expect(page.hash).toContain("h1=21");
  designer.connect();
  await rests();
  expect(page.hash).toContain("h1=22");
  await expect.poll(() => comparison.shown?.order).toBe("mixed-order");
});
