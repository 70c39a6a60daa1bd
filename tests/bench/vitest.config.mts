// Runs what measures in a browser, `*.bench.ts`, one file after the other. `cargo xtask bench` builds everything first. A slow machine takes three times as long as a quick one.

import browser from "../../web/vitest.browser.config.ts";

export default {
  ...browser,
  test: { ...browser.test, include: ["tests/bench/*.bench.ts"], testTimeout: 3_600_000 },
};
