// What every file of browser tests begins with: a site, a browser, and visits that end with their test.

import type { Browser } from "playwright-core";
import { afterAll, afterEach, beforeAll, expect } from "vitest";
import { launch, shared } from "./browser.ts";
import { type Site, serve } from "./server.ts";
import { QUICK, type Visit, type VisitOptions, visit } from "./visit.ts";

export interface Stay {
  readonly site: Site;
  readonly browser: Browser;
  /** Opens the designer in a profile of its own, as is usual in this file unless something else is asked for. After the test it is closed and must have had no trouble. */
  enter(options?: VisitOptions): Promise<Visit>;
}

/** `options` are those of {@link launch}; where there are none the browser is that of the files before. `usual` are those of visits: where nothing is said neither the picture nor the copy of the site for later can be looked at. */
export function stay(options: Parameters<typeof launch>[0] = {}, usual: VisitOptions = QUICK): Stay {
  let site: Site | undefined;
  let browser: Browser | undefined;
  const isShared = Object.keys(options).length === 0;
  let visits: Visit[] = [];
  const present = <T>(thing: T | undefined): T => {
    if (thing === undefined) throw new Error("the site and the browser start with the first test");
    return thing;
  };
  beforeAll(async () => {
    [site, browser] = await Promise.all([serve(), isShared ? shared() : launch(options)]);
  });
  afterEach(async () => {
    const ended = visits;
    visits = [];
    for (const each of ended) await each.leave();
    expect(ended.flatMap((each) => each.troubles)).toEqual([]);
    expect(present(site).missing.splice(0)).toEqual([]);
  });
  afterAll(async () => {
    if (!isShared) await browser?.close();
    await site?.close();
  });
  return {
    get site() {
      return present(site);
    },
    get browser() {
      return present(browser);
    },
    async enter(visitOptions) {
      const there = await visit(present(browser), present(site).url, { ...usual, ...visitOptions });
      visits.push(there);
      return there;
    },
  };
}
