/** What is said while a file is being opened. */

import { phrases } from "../../language";

export const opening = phrases("opening", {
  opening: (file: string, megabytes: string) => `Opening ${file} (${megabytes} MB)…`,
  stays: "What was there stays until then.",
  stop: "Stop",
  unreadable: (file: string) =>
    `“${file}” cannot be read: it is a folder, has been moved, or may not be read. Open the files in a folder themselves.`,
  /** Of the name of another part. */
  nameTaken: (earlier: string) => `${earlier} has the same one. Each has to have a name of its own.`,
  stopped: (file: string) => `${file} was not opened.`,
});
