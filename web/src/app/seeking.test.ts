import { expect, test, vi } from "vitest";
import type { Outcome } from "../worker/port";
import { Seeking } from "./seeking";

function host() {
  return {
    addController: vi.fn(),
    removeController: vi.fn(),
    requestUpdate: vi.fn(),
    updateComplete: Promise.resolve(true),
  };
}

const done = (value: string): Outcome<string> => ({ state: "done", value });

test("of many questions the last is asked, and its answer is ready", async () => {
  const page = host();
  const seeking = new Seeking<string>(page, 1);
  expect(seeking.coming).toBe(false);
  const early = vi.fn(async () => done("early"));
  seeking.soon(early);
  seeking.soon(async () => done("late"));
  expect(seeking.coming).toBe(true);
  await vi.waitFor(() => expect(seeking.ready).toBe("late"));
  expect(early).not.toHaveBeenCalled();
});

test("an answer to an earlier question is none, and what was found before is seen until there is a newer one", async () => {
  const seeking = new Seeking<string>(host(), 0);
  seeking.soon(async () => done("first"));
  await vi.waitFor(() => expect(seeking.ready).toBe("first"));
  let answer: (outcome: Outcome<string>) => void = () => {};
  const asked = vi.fn(() => new Promise<Outcome<string>>((resolve) => (answer = resolve)));
  seeking.soon(asked);
  await vi.waitFor(() => expect(asked).toHaveBeenCalled());
  seeking.soon(async () => done("third"));
  answer(done("second"));
  expect(seeking.ready).toBeNull();
  expect(seeking.found).toEqual(done("first"));
  await vi.waitFor(() => expect(seeking.ready).toBe("third"));
});

test("what could not be fetched is no answer, and what is forgotten or has left the page finds nothing", async () => {
  const seeking = new Seeking<string>(host(), 0);
  seeking.soon(async () => null);
  await vi.waitFor(() => expect(seeking.coming).toBe(false));
  expect(seeking.found).toBeNull();
  seeking.soon(async () => done("gone"));
  seeking.forget();
  expect(seeking.coming).toBe(false);
  seeking.soon(async () => done("gone"));
  seeking.hostDisconnected();
  await new Promise((resolve) => setTimeout(resolve, 5));
  expect([seeking.coming, seeking.found]).toEqual([false, null]);
});
