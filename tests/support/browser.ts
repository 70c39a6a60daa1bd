// A headless Chromium with WebGL in software, the one that `cargo xtask test` found.

import { existsSync } from "node:fs";
import { type Browser, chromium } from "playwright-core";

/** Where a test run by hand looks when PASU_BROWSER is not set. */
const USUAL = [
  "/usr/bin/chromium-headless-shell",
  "/usr/bin/chromium",
  "/usr/bin/chromium-browser",
  "/usr/bin/google-chrome",
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
];

const QUIET = [
  "--no-sandbox",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
];

/** What a browser is started with. */
export interface LaunchOptions {
  /** Whether it draws WebGL. */
  readonly webgl?: boolean;
  /** Flags beside the usual ones. */
  readonly flags?: readonly string[];
}

/** Starts a browser. Every test opens its own context, which is a fresh profile. */
export async function launch({ webgl = true, flags = [] }: LaunchOptions = {}): Promise<Browser> {
  const executablePath = process.env.PASU_BROWSER ?? USUAL.find(existsSync);
  return await chromium.launch({
    ...(executablePath === undefined ? {} : { executablePath }),
    args: [...QUIET, webgl ? "--enable-unsafe-swiftshader" : "--disable-3d-apis", ...flags],
  });
}

let running: Promise<Browser> | undefined;

/** The one browser of this process, with nothing said. It is found running by the next file of tests, and ends with the process. */
export async function shared(): Promise<Browser> {
  if (!(await running)?.isConnected()) running = launch();
  return await (running as Promise<Browser>);
}
