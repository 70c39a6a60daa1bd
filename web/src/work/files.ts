/** Files in and out of the page. */

import { MAX_TITLE } from "../state/actions";
import { page } from "../words/english/page";

/** A file name from a title: what every file system allows, never empty. */
export function fileName(title: string | undefined, extension: string): string {
  const name = (title ?? "")
    .normalize("NFC")
    .replace(/[^\p{Letter}\p{Number}\p{Mark} ()+,=_-]+/gu, " ")
    .replace(/\s+/g, " ")
    .trim()
    .slice(0, MAX_TITLE / 2)
    .trim();
  return `${name === "" ? page.pot : name}.${extension}`;
}

/** Offers a file to the person as a download. */
export function saveBlob(blob: Blob, name: string): void {
  const address = URL.createObjectURL(blob);
  const anchor = document.createElement("a");
  anchor.href = address;
  anchor.download = name;
  anchor.click();
  // The download has its own hold on the data once it has begun.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

/** Asks for a file; null when the person thinks better of it. */
export function pickFile(accept: string): Promise<File | null> {
  return new Promise((resolve) => {
    const input = document.createElement("input");
    input.type = "file";
    input.accept = accept;
    input.addEventListener("change", () => resolve(input.files?.[0] ?? null));
    input.addEventListener("cancel", () => resolve(null));
    input.click();
  });
}
