/** The library's own words where the page has none of its own. */

/** A message of the library as a sentence of its own. */
export function asSentence(message: string): string {
  const ended = /[.!?]$/.test(message) ? message : `${message}.`;
  return ended.charAt(0).toUpperCase() + ended.slice(1);
}
