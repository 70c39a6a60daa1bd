/** What a person puts into a page of their own to have a pot there: an element, or a frame. */

export interface Embedding {
  /** Where the designer is, ending in a slash, and the folder of the element below it. */
  readonly site: string;
  readonly folder: string;
  /** The link of the design, with its `#`. */
  readonly link: string;
  /** What is seen, for whoever does not see it. */
  readonly alt: string;
  /** The names of the parameters to show, in order. */
  readonly controls: readonly string[];
  readonly turns: boolean;
}

/** For pages that may have scripts. */
export function elementSnippet({ site, folder, link, alt, controls, turns }: Embedding): string {
  const attributes = [
    `src="${escaped(link)}"`,
    `alt="${escaped(alt)}"`,
    ...(controls.length > 0 ? [`controls="${escaped(controls.join(", "))}"`] : []),
    ...(turns ? ["auto-rotate"] : []),
  ];
  return `<script type="module" src="${escaped(new URL(`${folder}/pasu-pot.js`, site).href)}"></script>
<pasu-pot ${attributes.join(" ")}></pasu-pot>`;
}

/** For systems that allow only frames. */
export function frameSnippet({ site, link, alt, controls, turns }: Embedding): string {
  const address = new URL("embed.html", site);
  if (alt !== "") address.searchParams.set("alt", alt);
  if (controls.length > 0) address.searchParams.set("controls", controls.join(","));
  if (turns) address.searchParams.set("auto-rotate", "");
  address.hash = link;
  return `<iframe src="${escaped(address.href)}" title="${escaped(alt)}" width="480" height="480" loading="lazy" frameborder="0"></iframe>`;
}

function escaped(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
}
