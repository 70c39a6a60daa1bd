// Runs what measures in a browser, `*.bench.ts`, one file after the other. `cargo xtask bench` builds everything first.

import e2e from "../../web/vitest.e2e.config.ts";

export default {
  ...e2e,
  test: { ...e2e.test, include: ["tests/bench/*.bench.ts"], testTimeout: 600_000 },
};
