import { expect, test } from "vitest";
import { MakerClient } from "../../maker/client";
import { Shared } from "./shared";

/** Clients whose worker is never started, counted as they begin and end. */
function counted() {
  const counts = { begun: 0, ended: 0 };
  class Counted extends MakerClient {
    override dispose(): void {
      counts.ended += 1;
      super.dispose();
    }
  }
  const begin = () => {
    counts.begun += 1;
    return new Counted(() => {
      throw new Error("nobody asks");
    });
  };
  return { shared: new Shared<MakerClient>(begin), counts, begin };
}

test("one is begun for all, and ended with the last that leaves, however often that says so", () => {
  const { shared, counts } = counted();
  const [one, other] = [shared.take(), shared.take()];
  expect(one.it).toBe(other.it);
  one.leave();
  one.leave();
  expect(counts).toEqual({ begun: 1, ended: 0 });
  other.leave();
  expect(counts).toEqual({ begun: 1, ended: 1 });
  expect(shared.take().it).not.toBe(one.it);
  expect(counts.begun).toBe(2);
});

test("what is lent is taken and never ended; who came before keeps what it has", () => {
  const { shared, counts, begin } = counted();
  const before = shared.take();
  const lent = begin();
  shared.lend(lent);
  const borrowed = shared.take();
  expect(borrowed.it).toBe(lent);
  borrowed.leave();
  expect(counts.ended).toBe(0);
  shared.lend(null);
  expect(shared.take().it).toBe(before.it);
});
