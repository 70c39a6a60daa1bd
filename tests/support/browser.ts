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

/**
 * For a browser that opens hundreds of pages for seconds each: it draws in its own process, and compiles what WebAssembly repeats again, for speed, after ten times
 * as much use as it would. A tenth of the processor's time of all tests goes into the two. Nothing is measured in such a browser.
 */
const FRUGAL = ["--in-process-gpu", "--js-flags=--wasm-tiering-budget=130000000"];

/** What a browser is started with. */
export interface LaunchOptions {
  /** Whether it draws WebGL. */
  readonly webgl?: boolean;
  /** Flags beside the usual ones. */
  readonly flags?: readonly string[];
  /** Whether it is a frugal one, and not as people have it. */
  readonly frugal?: boolean;
}

/** Starts a browser. Every test opens its own context, which is a fresh profile. */
export async function launch({ webgl = true, flags = [], frugal = false }: LaunchOptions = {}): Promise<Browser> {
  const executablePath = process.env.PASU_BROWSER ?? USUAL.find(existsSync);
  return await chromium.launch({
    ...(executablePath === undefined ? {} : { executablePath }),
    args: [...QUIET, webgl ? "--enable-unsafe-swiftshader" : "--disable-3d-apis", ...(frugal ? FRUGAL : []), ...flags],
  });
}

let running: Promise<Browser> | undefined;

/** The one browser of this process, a frugal one. It is found running by the next file of tests, and ends with the process. */
export async function shared(): Promise<Browser> {
  if (!(await running)?.isConnected()) running = launch({ frugal: true });
  return await (running as Promise<Browser>);
}
