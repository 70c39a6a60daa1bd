/** Where a design comes from: a link, in itself or at the end of an address, or a document at an address. */

import type { Refusal } from "../../document/types";
import { pot } from "../../words/english/pot";

export type Source =
  | { readonly kind: "link"; readonly link: string }
  | { readonly kind: "document"; readonly address: string };

/** The largest document that is fetched, in bytes. */
export const MOST_BYTES = 2 ** 20;

/** A link begins with its version. */
const LINK = /^#\d+[/~]/;

/**
 * What `src` says, as seen from a page.
 *
 * @throws {Refusal}
 */
export function sourceOf(src: string, base: string): Source {
  const text = src.trim();
  if (text.startsWith("#")) return { kind: "link", link: text };
  let address: URL;
  try {
    address = new URL(text, base);
  } catch {
    throw refused("not-an-address", pot.noAddress(text));
  }
  if (LINK.test(address.hash)) return { kind: "link", link: address.hash };
  return { kind: "document", address: address.href };
}

/**
 * The text of a document.
 *
 * @throws {Refusal}
 */
export async function textAt(address: string, signal: AbortSignal): Promise<string> {
  let response: Response;
  try {
    response = await fetch(address, { signal });
  } catch (error) {
    if (signal.aborted) throw error;
    throw refused("unreachable", pot.unreachable(address));
  }
  if (!response.ok) throw refused("unreachable", pot.status(address, response.status));
  return new TextDecoder().decode(await bytesOf(response, address));
}

/** What an answer holds, as far as that is not too much: what it says of its length may be wrong. */
async function bytesOf(response: Response, address: string): Promise<Uint8Array> {
  const reader = response.body?.getReader();
  const chunks: Uint8Array[] = [];
  let length = 0;
  for (let next = await reader?.read(); next && !next.done; next = await reader?.read()) {
    length += next.value.length;
    if (length > MOST_BYTES) {
      void reader?.cancel();
      throw refused("too-large", pot.tooLarge(address, MOST_BYTES));
    }
    chunks.push(next.value);
  }
  const bytes = new Uint8Array(length);
  let at = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, at);
    at += chunk.length;
  }
  return bytes;
}

function refused(code: string, message: string): Refusal {
  return { code, path: "src", message };
}
