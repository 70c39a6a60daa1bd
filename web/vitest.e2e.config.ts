// Browser tests: tests/e2e against the built site on a static server. Two files run side by side: while one waits for the
// next frame the other draws. What counts frames runs by itself afterwards. `cargo xtask test` builds the site and finds a browser first.

import { defineConfig } from "vitest/config";
import browser from "./vitest.browser.config";

const ALONE = ["tests/e2e/drag.test.ts"];

export default defineConfig({
  ...browser,
  test: {
    ...browser.test,
    fileParallelism: true,
    maxWorkers: 2,
    // A shared machine may stall for seconds between two steps of a hand: what fails there is tried once more, and the report says so.
    retry: process.env.CI ? 1 : 0,
    projects: [
      {
        extends: true,
        // Files share what they import, and a browser: to start one, and to draw in it for the first time, takes as long as a test.
        test: {
          name: "together",
          include: ["tests/e2e/**/*.test.ts"],
          exclude: ALONE,
          isolate: false,
          sequence: { groupOrder: 0 },
        },
      },
      {
        extends: true,
        test: { name: "alone", include: ALONE, fileParallelism: false, sequence: { groupOrder: 1 } },
      },
    ],
  },
});
