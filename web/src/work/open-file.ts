/** What a file that was dropped or chosen stands for: the text of a design, or the link in a shortcut or in something that Pasu made. */

import type { Making, Refusal } from "../document/types";
import { isolated } from "../language";
import type { MakerClient } from "../maker/client";
import type { SolverClient } from "../solver/client";
import { opening } from "../words/english/opening";
import "../words/taken-names";
import { decoded } from "./decoded";
import { linkOf } from "./link-in-text";
import { isShortcut, linkIn } from "./shortcut";

/** Documents are read as text; the format's own limit is 32 MiB of JSON, and of a link 1 MiB. */
const MAX_TEXT_BYTES = 32 * 1024 * 1024;

/** Things that were made are larger: a million triangles are 50 MB. */
const MAX_MADE_BYTES = 512 * 1024 * 1024;

const OBJECT = /^\ufeff?\s*\{/;

/** How much of a file tells a document from anything else. */
const BEGINNING = 64;

/** The text of a design, and how the file was made, where it says that. */
export type Found =
  | { readonly text: string; readonly made: Making | null }
  | { readonly text?: never; readonly refusal: Refusal }
  | null;

/** Who tells a design from other texts, and who finds one in what was made. */
interface Readers {
  readonly solver: Pick<SolverClient, "parse">;
  readonly maker: () => Promise<Pick<MakerClient, "ask"> | null>;
}

/** Null when something newer was opened meanwhile. */
export async function readFile(file: File, readers: Readers): Promise<Found> {
  try {
    return await read(file, readers);
  } catch (error) {
    // A folder, or what was moved away since it was chosen: the browser names it and gives nothing of it.
    if (!(error instanceof DOMException)) throw error;
    return { refusal: { code: "file-unreadable", path: "", message: opening.unreadable(isolated(file.name)) } };
  }
}

async function read(file: File, { solver, maker }: Readers): Promise<Found> {
  if (isShortcut(file.name) && file.size <= MAX_TEXT_BYTES) {
    const text = linkIn(await bytesOf(file));
    if (text !== null) return { text, made: null };
  }
  const document = isDocument(file.name, decoded(await bytesOf(file.slice(0, BEGINNING))));
  if (file.size > (document ? MAX_TEXT_BYTES : MAX_MADE_BYTES)) {
    return refused("file-too-large", file.name);
  }
  if (document) {
    const text = decoded(await bytesOf(file));
    // JSON of another program has not one field too few: it is no design.
    if (OBJECT.test(text)) return text.includes('"pasu"') ? { text, made: null } : refused("no-design", file.name);
    return { text: await linkOf(text, solver), made: null };
  }
  const reader = await maker();
  if (!reader) return null;
  const bytes = await bytesOf(file);
  const outcome = await reader.ask({ kind: "open", bytes });
  switch (outcome.state) {
    case "superseded":
      return null;
    case "refused":
      return { refusal: outcome.refusal };
    case "done":
      return outcome.value === null
        ? refused("no-design", file.name)
        : { text: outcome.value.link, made: outcome.value.making };
  }
}

/** Whether a file is a document or a link, which the solver reads and whose faults it names. */
export function isDocument(name: string, beginning: string): boolean {
  return /\.(json|txt)$/i.test(name) || /^\ufeff?\s*(\{|#?\d+[~/]|https?:)/.test(beginning);
}

async function bytesOf(file: Blob): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await file.arrayBuffer());
}

function refused(code: string, name: string): Found {
  return { refusal: { code, path: "", message: "", args: { name } } };
}
