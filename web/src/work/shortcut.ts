/** The link in a shortcut, which is what a desktop makes of an address that is dragged out of a browser. */

import { decoded } from "./decoded";

const NAME = /\.(url|website|desktop|webloc)$/i;

/** The lines of Windows and of Linux. */
const LINE = /^[ \t]*URL=[ \t]*(\S+)/im;

/** The XML of macOS, in which `&` is escaped. */
const ELEMENT = /<key>\s*URL\s*<\/key>\s*<string>\s*([^<\s]+)\s*<\/string>/i;

/** The bytes of macOS: before a long string `_` and by how many bytes its length is told: one, two or four. */
const LONG_STRING = 0x5f;
const LENGTH_BYTES = new Map([
  [0x10, 1],
  [0x11, 2],
  [0x12, 4],
]);

const SCHEME = new TextEncoder().encode("http");

/** A link of this or of another version. */
const LINK = /#\d+[/~]/;

export function isShortcut(name: string): boolean {
  return NAME.test(name);
}

/** Null where it leads elsewhere. */
export function linkIn(bytes: Uint8Array): string | null {
  const text = decoded(bytes);
  const address = text.startsWith("bplist")
    ? addressIn(bytes)
    : (LINE.exec(text)?.[1] ?? ELEMENT.exec(text)?.[1]?.replaceAll("&amp;", "&"));
  return address !== undefined && LINK.test(address) ? address : null;
}

/** The first string that is an address. No other is decoded: a damaged file may have millions, each as long as itself. */
function addressIn(bytes: Uint8Array): string | undefined {
  for (let at = bytes.indexOf(LONG_STRING); at >= 0; at = bytes.indexOf(LONG_STRING, at + 1)) {
    const first = at + 2 + (LENGTH_BYTES.get(bytes[at + 1] ?? 0) ?? 0);
    if (!SCHEME.every((letter, place) => bytes[first + place] === letter)) continue;
    const length = bytes.subarray(at + 2, first).reduce((sum, byte) => 256 * sum + byte, 0);
    return decoded(bytes.subarray(first, first + length));
  }
  return undefined;
}
