/** The link in a text that is about it, as a mail is. */

/** Where a link of this or of another version has its design. */
const DESIGN = /#\d+[/~]/;

/** What ends a link, and what begins one: white space, brackets and quotation marks, of which links have none. */
const AROUND = /[\s()[\]{}<>"'“”„‘’‚«»]/;

/** What stands behind a link at the end of a sentence. */
const STOPS = /[.,;:!?]+$/;

/** The first one, with the view before its `#`; null where there is none, or a document. Each letter is looked at once or twice, however many marks of links there are. */
export function linkInText(text: string): string | null {
  const at = text.search(DESIGN);
  if (at < 0 || /^\ufeff?\s*\{/.test(text)) return null;
  let [from, to] = [at, at];
  while (from > 0 && !AROUND.test(text.charAt(from - 1))) from -= 1;
  while (to < text.length && !AROUND.test(text.charAt(to))) to += 1;
  return text.slice(from, to).replace(STOPS, "");
}
