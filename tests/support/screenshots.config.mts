// Takes the pictures of screenshots.ts with the set-up of the browser tests.

import browser from "../../web/vitest.browser.config.ts";

export default {
  ...browser,
  test: { ...browser.test, include: ["tests/support/screenshots.ts"], testTimeout: 120_000 },
};
