/** A parameter's symbol as the papers print it: `h_0'` as an italic letter with its index and prime. */

import { html, nothing, type TemplateResult } from "lit";

export function symbol(text: string): TemplateResult {
  // A difference of two has an index each.
  return html`${text.split(" ").map((piece, place) => html`${place === 0 ? nothing : " "}${letter(piece)}`)}`;
}

function letter(text: string): TemplateResult {
  const prime = text.endsWith("'");
  const [letter, index] = (prime ? text.slice(0, -1) : text).split("_");
  return html`${letter}${index === undefined ? nothing : html`<sub>${index}</sub>`}${prime ? "′" : nothing}`;
}
