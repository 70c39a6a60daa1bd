// Runs what measures in a browser, `*.bench.ts`, one file after the other. `cargo xtask bench` builds everything first.

import e2e from "../../web/vitest.e2e.config.ts";

// The projects there are of the tests, and would be run in place of these.
const { projects: _, ...test } = e2e.test ?? {};

export default {
  ...e2e,
  test: { ...test, include: ["tests/bench/*.bench.ts"], fileParallelism: false, testTimeout: 600_000 },
};
