import { expect, test } from "vitest";
import { Notices } from "./notices";

test("a notice goes when it is dismissed, and a newer one stays", () => {
  const notices = new Notices();
  expect(notices.notice).toBeNull();
  notices.say("Saved.");
  const first = notices.notice?.id ?? 0;
  notices.say("Link copied.");
  notices.dismiss(first);
  expect(notices.notice?.text).toBe("Link copied.");
  notices.dismiss(notices.notice?.id ?? 0);
  expect(notices.notice).toBeNull();
});

test("what is said twice is gone in between, and of several the last stays", async () => {
  const notices = new Notices();
  notices.say("Link copied.");
  notices.say("Link copied.");
  expect(notices.notice).toBeNull();
  await expect.poll(() => notices.notice?.text).toBe("Link copied.");
  notices.say("Link copied.");
  notices.say("Saved.");
  await new Promise((resolve) => setTimeout(resolve, 20));
  expect(notices.notice?.text).toBe("Saved.");
});

test("what a notice tells of is taken back once, and that is told too", async () => {
  const notices = new Notices();
  let taken = 0;
  const act = async () => {
    taken += 1;
    return "Taken back.";
  };
  notices.say("Deleted.", { label: "Undo", act });
  await Promise.all([notices.undo(), notices.undo()]);
  expect([taken, notices.notice?.text, notices.notice?.undo]).toEqual([1, "Taken back.", null]);
});
