// What is shown or read aloud on a page that speaks the pseudo-language, and did not come from the catalogue.

import type { Visit } from "./visit.ts";

/** The address of the page in English whose every letter is changed: see `web/src/words/pseudo.ts`. */
export const PSEUDO = "?lang=en-XA";

/** What the library says in sentences of its own, the words of the format, and what is quoted. */
const EXCUSED = [
  "This link is damaged or cut short \\([^)]*\\); copy it once more, from its first to its last letter\\.",
  "This is neither a design nor a link to one: .*; a link looks like .*\\.",
  "second-order, mixed-order, fourth-order, bloor-wilson, boundary-value, rings, vertex-frame, blend, or octant",
  "“[^”]*”",
];

/**
 * Every text, name, tip and description that a person meets and that has a plain letter, with where it is. Excused are only symbols of equations, which are the same everywhere, places in the
 * document, which are code, what is quoted (“so”), and the sentences of the library that the page has no words for.
 */
export async function unmarked(pot: Visit): Promise<string[]> {
  return await pot.page.evaluate((excused) => {
    const NAMES = [
      "aria-label",
      "aria-valuetext",
      "aria-roledescription",
      "aria-description",
      "title",
      "placeholder",
      "alt",
      "label",
    ];
    const found: string[] = [];
    const where = (element: Element) => `${element.localName}.${element.className}`;
    const judge = (text: string | null, element: Element, of: string) => {
      const own = excused.reduce((rest, pattern) => rest.replace(new RegExp(pattern, "g"), ""), text ?? "");
      if (/[a-z]/i.test(own)) found.push(`${where(element)} ${of}: ${own.trim()}`);
    };
    const isSymbol = (element: Element) =>
      element.closest("code") !== null ||
      // As `Intl` writes it, which does not speak the pseudo-language.
      element.closest("time") !== null ||
      element.closest(".symbol, math") !== null ||
      /^[nstw]$/.test(element.textContent ?? "");
    const walk = (node: Node) => {
      if (node instanceof Text) {
        const { parentElement } = node;
        if (parentElement && !isSymbol(parentElement)) judge(node.data, parentElement, "says");
        return;
      }
      if (node instanceof Element) {
        if (node instanceof HTMLStyleElement || node instanceof HTMLScriptElement || node.localName === "noscript")
          return;
        if (!(node instanceof HTMLOptionElement) && !node.checkVisibility() && node.localName !== "slot") return;
        for (const name of NAMES) judge(node.getAttribute(name), node, name);
        if (node.shadowRoot) walk(node.shadowRoot);
      }
      for (const child of node.childNodes) walk(child);
    };
    walk(document.body);
    judge(document.title, document.body, "is titled");
    return [...new Set(found)];
  }, EXCUSED);
}

/** How many texts there are, so that a page without any is no good page. */
export async function said(pot: Visit): Promise<number> {
  return await pot.page.evaluate(() => {
    let count = 0;
    const walk = (node: Node) => {
      if (node instanceof Text && node.data.includes("⟦")) count += 1;
      if (node instanceof Element && node.shadowRoot) walk(node.shadowRoot);
      for (const child of node.childNodes) walk(child);
    };
    walk(document.body);
    return count;
  });
}
