/** Frame models as OBJ files, in and out. */

import { labelOf } from "../document/label";
import type { Network } from "../document/network/network";
import { type ObjTrouble, writeObj } from "../document/network/obj";
import { LIMITS } from "../document/tables.gen";
import type { Design } from "../document/types";
import { isolated } from "../language";
import { networkOfFaces } from "../maker/faces";
import { formatNumber } from "../number";
import { networks as words } from "../words/english/networks";
import { refusalWords } from "../words/refusals";
import type { Designer } from "./designer";
import { fileName, pickFile, saveBlob } from "./files";

/** Text of some hundred thousand points. */
const MOST = 32 * 1024 * 1024;

/** Opens the network of a file that a person chooses, as a design of its own; whether it did. */
export async function openObj(designer: Designer): Promise<boolean> {
  const file = await pickFile(".obj,model/obj");
  if (!file) return false;
  // What was wrong with the file before is nothing about this one.
  const { notice } = designer.notices;
  if (notice && !notice.undo) designer.notices.dismiss(notice.id);
  return await designer.opening.openRead(file, async (stopped) => {
    const read = await readNetwork(designer, file, stopped);
    if (!read) return null;
    if ("network" in read) return designOf(designer, file, read.network);
    designer.notices.say(read.trouble);
    return null;
  });
}

/** What is wrong with it in words, and whether it may have been meant as a network: triangles are none. */
interface NoNetwork {
  readonly trouble: string;
  readonly isMeant: boolean;
}

/** The network that the faces of a file are, or why they are none; null when it is stopped, something newer is read, or the maker cannot be fetched, which is said. */
export async function readNetwork(
  designer: Pick<Designer, "openMade">,
  file: File,
  stopped?: AbortSignal,
): Promise<{ readonly network: Network } | NoNetwork | null> {
  if (file.size > MOST) return { trouble: words.objTrouble.large, isMeant: false };
  const made = await designer.openMade();
  if (!made) return null;
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (stopped?.aborted) return null;
  const { maker } = made;
  const cancel = () => maker.cancel("faces");
  stopped?.addEventListener("abort", cancel);
  const outcome = await maker.ask({ kind: "faces", bytes });
  stopped?.removeEventListener("abort", cancel);
  if (outcome.state === "superseded") return null;
  if (outcome.state === "refused") return { trouble: refusalWords(outcome.refusal), isMeant: false };
  const read = outcome.value;
  if (!("trouble" in read)) return { network: networkOfFaces(read) };
  const { trouble } = read;
  const isMeant = trouble.code !== "empty" && !(trouble.code === "corners" && trouble.corners === 3);
  return { trouble: objWords(trouble), isMeant };
}

/** Opens a network that was read of a file, as a design of its own. */
export function openNetwork(designer: Designer, file: File, network: Network): void {
  designer.opening.open(designOf(designer, file, network));
}

/** The numbers of a file have no unit: they are taken in that of the design on the page, in which they are written too. */
function designOf({ store }: Designer, file: File, network: Network): Design {
  const title = labelOf(file.name.replace(/\.obj$/i, ""));
  const { unit } = store.design;
  return { pasu: 1, ...(title !== "" && { title }), ...(unit && { unit }), parts: [{ shape: network }] };
}

function objWords(trouble: ObjTrouble): string {
  const { objTrouble: told } = words;
  switch (trouble.code) {
    case "empty":
    case "crowded":
      return told[trouble.code];
    case "many":
      return told.many(formatNumber(trouble.faces), formatNumber(LIMITS.patches));
    case "corners":
      return told.corners(formatNumber(trouble.line), trouble.corners);
    case "no-point":
      return told["no-point"](formatNumber(trouble.line), isolated(trouble.named), trouble.points);
    default:
      return told[trouble.code](formatNumber(trouble.line));
  }
}

export function saveObj(designer: Designer, network: Network): void {
  saveBlob(new Blob([writeObj(network)], { type: "model/obj" }), fileName(designer.store.title, "obj"));
}
