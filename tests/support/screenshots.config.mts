// Takes the pictures of screenshots.ts with the set-up of the browser tests.

import e2e from "../../web/vitest.e2e.config.ts";

export default {
  ...e2e,
  test: { ...e2e.test, include: ["tests/support/screenshots.ts"], testTimeout: 120_000 },
};
