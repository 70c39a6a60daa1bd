/** Opens the files that were dropped or chosen. Fetched with the first of them. */

import { scanKind } from "../document/scanned/file-kind";
import { isolated, listed } from "../language";
import { page } from "../words/english/page";
import type { Designer } from "../work/designer";

/** What the page does with what is found. */
interface Showing {
  /** Shows a design as its link says, where there is one. */
  opened(text?: string): Promise<void>;
  /** Asks about a scan. */
  scan(file: File): Promise<void>;
}

/** Opens the first that is a design, or else the first that may be a scan, and says of each of several what became of it. */
export async function openFiles(designer: Designer, files: readonly File[], showing: Showing): Promise<void> {
  const { opening } = designer;
  const refused: File[] = [];
  const scans: File[] = [];
  for (const file of files) {
    // Who stops one wants none of the others.
    const found = await opening.openFile(file);
    if (!found) return;
    await showing.opened(found.text);
    if (opening.problem === null) break;
    refused.push(file);
    // Triangles without a design may be a scan of a pot.
    if (opening.problem.code === "no-design" && scanKind(file.name)) scans.push(file);
  }
  const [scan] = scans;
  if (scan && refused.length === files.length) {
    opening.dismissProblem();
    await showing.scan(scan);
    const others = refused.filter((file) => !scans.includes(file));
    const left = [
      ...(others.length > 0 ? [page.notOpened(quoted(others))] : []),
      ...(scans.length > 1 ? [page.leftOut(quoted(scans.slice(1)))] : []),
    ];
    if (left.length > 0) designer.notices.say(page.sentences(left));
    return;
  }
  if (files.length === 1) return;
  const opened = files[refused.length];
  const left = opened ? files.slice(refused.length + 1) : [];
  const told = [
    opened ? page.opened(quoted([opened])) : page.noneOpened(quoted(files)),
    ...(opened && refused.length > 0 ? [page.notOpened(quoted(refused))] : []),
    ...(left.length > 0 ? [page.leftOut(quoted(left))] : []),
  ];
  designer.notices.say(page.sentences(told));
}

/** The names of files, as they stand in a sentence. */
function quoted(files: readonly File[]): string {
  return listed(files.map(({ name }) => page.quoted(isolated(name))));
}
