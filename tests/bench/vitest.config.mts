// Runs what measures in a browser, `*.bench.ts`, one file after the other. `cargo xtask bench` builds everything first.

import browser from "../../web/vitest.browser.config.ts";

export default {
  ...browser,
  test: { ...browser.test, include: ["tests/bench/*.bench.ts"], testTimeout: 600_000 },
};
