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
