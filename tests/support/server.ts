// A static host as people have them: one folder of files below a sub-path, right types, honest 404s, no fallbacks.

import { createReadStream } from "node:fs";
import { stat } from "node:fs/promises";
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join, normalize, relative, sep } from "node:path";
import { fileURLToPath } from "node:url";

const TYPES: Readonly<Record<string, string>> = {
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json; charset=utf-8",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
};

/** Where the site appears; not the root, because most static hosts put a project below one. */
const SUB_PATH = "/pot/";

/** A running server. */
export interface Site {
  /** The address of the designer, ending in a slash. */
  readonly url: string;
  /** Paths that were asked for and are not there. */
  readonly missing: string[];
  /** Files that were asked for and are there, below the site, and when, in milliseconds as `Date.now()` has them. */
  readonly asked: { readonly file: string; readonly at: number }[];
  /** Serves another folder from now on, as after a deployment. */
  replace(folder: string): void;
  /** Ends the server and every connection. Serving the site again takes a new one. */
  close(): Promise<void>;
}

/** The site that `cargo xtask build` makes. */
export const DIST = fileURLToPath(new URL("../../web/dist", import.meta.url));

/** Headers of a page whose clocks are exact to some microseconds: it shares its process with nothing from elsewhere. */
export const ISOLATED = {
  "cross-origin-opener-policy": "same-origin",
  "cross-origin-embedder-policy": "require-corp",
} as const;

/**
 * Serves a folder on a free port, or on a given one (to come back after an outage at the same address). `headers` come to
 * those of every file, or in their place.
 */
export async function serve(
  folder: string = DIST,
  port = 0,
  headers: (file: string) => Readonly<Record<string, string>> = () => ({}),
): Promise<Site> {
  let current = folder;
  const missing: string[] = [];
  const asked: { file: string; at: number }[] = [];
  const server = createServer(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? "/", "http://localhost").pathname);
    const file = path.startsWith(SUB_PATH) ? await fileBelow(current, path.slice(SUB_PATH.length)) : undefined;
    if (file === undefined) {
      missing.push(path);
      response.writeHead(404, { "content-type": "text/plain; charset=utf-8" }).end("There is nothing here.\n");
      return;
    }
    asked.push({ file: relative(current, file), at: Date.now() });
    const type = TYPES[extname(file)] ?? "application/octet-stream";
    response.writeHead(200, {
      "content-type": type,
      "cache-control": "no-cache",
      "x-content-type-options": "nosniff",
      ...headers(file),
    });
    if (request.method === "HEAD") response.end();
    else createReadStream(file).pipe(response);
  });
  await new Promise<void>((resolve, reject) => {
    server.once("error", reject);
    server.listen(port, "127.0.0.1", resolve);
  });
  const address = server.address() as AddressInfo;
  return {
    // Service workers run on plain http for this name only.
    url: `http://localhost:${address.port}${SUB_PATH}`,
    missing,
    asked,
    replace(next) {
      current = next;
    },
    async close() {
      server.closeAllConnections();
      await new Promise((resolve) => server.close(resolve));
    },
  };
}

async function fileBelow(folder: string, path: string): Promise<string | undefined> {
  const file = normalize(join(folder, path === "" || path.endsWith("/") ? `${path}index.html` : path));
  if (!file.startsWith(normalize(folder) + sep)) return undefined;
  const found = await stat(file).catch(() => undefined);
  return found?.isFile() ? file : undefined;
}
