// Other people's pages with pots in them: served from an origin of their own, and what one counts in them.

import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join, normalize, sep } from "node:path";
import { fileURLToPath } from "node:url";
import type { Browser, BrowserContext, BrowserContextOptions, Page } from "playwright-core";
import { afterAll, afterEach, beforeAll, expect } from "vitest";
import { launch } from "./browser.ts";
import { DIST, type Site, serve } from "./server.ts";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The examples of the documents. */
export const EXAMPLES = here("../../docs/examples");
const MODULES = here("../../web/node_modules");

/** Where examples say that the element is, and the libraries that they use. */
const ELEMENT = "https://pasu.example/";
const LIBRARIES = "https://modules.example/";

const TYPES: Readonly<Record<string, string>> = {
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json; charset=utf-8",
  ".mjs": "text/javascript; charset=utf-8",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
};

export interface Town {
  /** The site with the element, which lets everybody fetch it. */
  readonly site: Site;
  /** Where the guests' own pages are, ending in a slash: another origin than the site's. */
  readonly url: string;
  readonly browser: Browser;
  /** Opens a page of a guest: one of a folder that is served, or one given here. Its troubles are looked at after the test. */
  open(page: string | { readonly html: string }, options?: GuestOptions): Promise<Guest>;
  /** Serves another folder as well, below a name. */
  add(name: string, folder: string): void;
}

export interface GuestOptions extends BrowserContextOptions {
  /** Headers of the page. */
  readonly headers?: Readonly<Record<string, string>>;
  /** What is in the console and was to be expected. */
  readonly expected?: RegExp;
}

export interface Guest {
  readonly page: Page;
  readonly context: BrowserContext;
  readonly troubles: string[];
}

/** What a page has made of what there should be one of, and what it asked for. */
export interface Count {
  /** WebGL contexts that were ever made and are not lost. */
  readonly contexts: number;
  readonly workers: number;
  readonly loads: number;
}

export function town(options: Parameters<typeof launch>[0] = { frugal: true }): Town {
  const folders = new Map<string, string>([["modules", MODULES]]);
  const given = new Map<string, { readonly html: string; readonly headers: Readonly<Record<string, string>> }>();
  let site: Site;
  let browser: Browser;
  let url: string;
  let close = async () => {};
  let guests: Guest[] = [];

  beforeAll(async () => {
    const shared = () => ({ "access-control-allow-origin": "*" });
    [site, browser] = await Promise.all([serve(DIST, 0, shared), launch(options)]);
    const server = createServer(async (request, response) => {
      const path = decodeURIComponent(new URL(request.url ?? "/", "http://localhost").pathname).slice(1);
      const page = given.get(path);
      const [first = "", ...rest] = path.split("/");
      const folder = folders.get(first);
      const file = folder ? within(folder, rest.join("/")) : within(EXAMPLES, path);
      const body = page ? Buffer.from(page.html) : file ? await readFile(file).catch(() => null) : null;
      if (path === "favicon.ico") {
        response.writeHead(204).end();
        return;
      }
      if (body === null) {
        response.writeHead(404, { "content-type": "text/plain" }).end("There is nothing here.\n");
        return;
      }
      const kind = page ? ".html" : extname(path);
      const text = kind === ".html" || (kind === ".js" && folder !== MODULES);
      response.writeHead(200, { "content-type": TYPES[kind] ?? "application/octet-stream", ...page?.headers });
      response.end(
        text ? body.toString("utf8").replaceAll(ELEMENT, site.url).replaceAll(LIBRARIES, `${url}modules/`) : body,
      );
    });
    await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
    url = `http://127.0.0.1:${(server.address() as AddressInfo).port}/`;
    close = async () => {
      server.closeAllConnections();
      await new Promise((resolve) => server.close(resolve));
    };
  });
  afterEach(async () => {
    const ended = guests;
    guests = [];
    for (const { context } of ended) await context.close();
    expect(ended.flatMap(({ troubles }) => troubles)).toEqual([]);
    expect(site.missing.splice(0)).toEqual([]);
  });
  afterAll(async () => {
    await browser?.close();
    await site?.close();
    await close();
  });

  return {
    get site() {
      return site;
    },
    get url() {
      return url;
    },
    get browser() {
      return browser;
    },
    add(name, folder) {
      folders.set(name, folder);
    },
    async open(page, { headers = {}, expected, ...contextOptions } = {}) {
      const context = await browser.newContext({
        viewport: { width: 900, height: 700 },
        deviceScaleFactor: 0.5,
        reducedMotion: "reduce",
        ...contextOptions,
      });
      context.setDefaultTimeout(120_000);
      const troubles: string[] = [];
      const note = (text: string) => {
        if (!expected?.test(text)) troubles.push(text);
      };
      const opened = await context.newPage();
      opened.on("console", (message) => {
        if (message.type() === "error") note(`console: ${message.text()}`);
      });
      opened.on("pageerror", (error) => note(`uncaught: ${error.message}`));
      await context.addInitScript(watchCounts);
      guests.push({ page: opened, context, troubles });
      let path = typeof page === "string" ? page : "";
      if (typeof page !== "string") {
        path = `given-${given.size}.html`;
        given.set(path, { html: page.html, headers });
      }
      await opened.goto(url + path);
      return { page: opened, context, troubles };
    },
  };
}

/** Counts from a page's first moment; runs in the browser. */
function watchCounts(): void {
  type Watched = { pasuCount: { contexts: Set<WebGL2RenderingContext>; workers: Set<Worker>; loads: number } };
  const count: Watched["pasuCount"] = { contexts: new Set(), workers: new Set(), loads: 0 };
  (globalThis as unknown as Watched).pasuCount = count;
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
    const made = (getContext as (...given: unknown[]) => unknown).call(this, kind, ...rest);
    if (/webgl/.test(kind) && made) count.contexts.add(made as WebGL2RenderingContext);
    return made;
  } as typeof getContext;
  const { terminate } = Worker.prototype;
  Worker.prototype.terminate = function (this: Worker) {
    count.workers.delete(this);
    terminate.call(this);
  };
  globalThis.Worker = class extends Worker {
    constructor(...given: ConstructorParameters<typeof Worker>) {
      super(...given);
      count.workers.add(this);
    }
  };
  document.addEventListener(
    "load",
    ({ target }) => {
      if (target instanceof HTMLElement && target.localName === "pasu-pot") count.loads += 1;
    },
    true,
  );
}

export async function counted({ page }: Guest): Promise<Count> {
  return await page.evaluate(() => {
    const { contexts, workers, loads } = (
      globalThis as unknown as {
        pasuCount: { contexts: Set<WebGL2RenderingContext>; workers: Set<Worker>; loads: number };
      }
    ).pasuCount;
    return { contexts: [...contexts].filter((gl) => !gl.isContextLost()).length, workers: workers.size, loads };
  });
}

/** Waits until so many pots are on the screen. */
export async function loaded({ page }: Pick<Guest, "page">, pots = 1): Promise<void> {
  await page.waitForFunction(
    (many) =>
      [...document.querySelectorAll("pasu-pot")].filter((pot) => (pot as { loaded?: boolean } & Element).loaded)
        .length >= many,
    pots,
  );
}

function within(folder: string, path: string): string | null {
  const file = normalize(join(folder, path));
  return file.startsWith(normalize(folder) + sep) ? file : null;
}
