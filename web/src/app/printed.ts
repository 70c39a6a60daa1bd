/** What is printed in the place of the page: the picture of the pot with its title, its numbers and its link. A browser that prints waits for nothing, so that this is fetched beforehand. */

import { type CSSResult, css, html, nothing, render } from "lit";
import { unitOf } from "../document/look";
import { familyOf, fieldValue } from "../document/schema";
import type { Design, Shape, Unit } from "../document/types";
import { formatNumber } from "../number";
import { symbol } from "../ui/symbol";
import { page } from "../words/english/page";
import { parameters } from "../words/english/parameters";
import { printing } from "../words/english/printing";
import { measureGroups } from "../words/measures";
import { fieldWords } from "../words/parameters";
import { partName } from "../words/parts";
import { lengthWords } from "../words/quantities";
import type { PasuApp } from "./pasu-app";

/** Of more parts nobody reads the numbers. */
const MOST_PARTS = 12;

/** A longer link is typed by no one, and leaves no room on the page. */
const MOST_LETTERS = 600;
const SHOWN_LETTERS = 80;

/** As many as a field of the panel shows. */
const DIGITS = 6;

/** Pixels of the picture: it is eight centimetres high on paper, at 300 to an inch. */
const [WIDTH, HEIGHT] = [1600, 945] as const;

/** In the place of the page, whatever is open on it. */
const PAPER = css`
  @page {
    margin: 15mm;
  }
  @media print {
    html,
    body {
      height: auto;
      overflow: visible;
      background: none;
    }
    body > :not(pasu-printed) {
      display: none;
    }
  }
`;

const SHEET = css`
  :host {
    display: block;
    color: #000;
    font-size: 10pt;
    line-height: 1.4;
  }
  h1 {
    margin: 0;
    font: 600 18pt / 1.2 var(--font-brand);
    overflow-wrap: anywhere;
  }
  h2,
  h3 {
    margin: 4mm 0 1mm;
    font-size: 11pt;
    break-after: avoid;
  }
  p {
    margin: 1mm 0;
  }
  canvas {
    display: block;
    width: 100%;
    max-height: 80mm;
    margin: 3mm 0;
    object-fit: contain;
  }
  .numbers {
    margin-top: 5mm;
    columns: 2;
    column-gap: 8mm;
  }
  section {
    break-inside: avoid;
  }
  section > :first-child {
    margin-top: 0;
  }
  section + section {
    margin-top: 3mm;
  }
  dl {
    margin: 0;
  }
  dl div {
    display: flex;
    justify-content: space-between;
    gap: 4mm;
    border-top: 0.2mm solid #bbb;
    break-inside: avoid;
  }
  dd {
    margin: 0;
    text-align: end;
    font-variant-numeric: tabular-nums;
  }
  .symbol,
  .note {
    color: #555;
  }
  .symbol {
    font-style: italic;
  }
  .note {
    display: block;
    font-size: 8.5pt;
  }
  a {
    color: inherit;
    overflow-wrap: anywhere;
  }
`;

/** Has that printed from now on; `address` is that of the page, without the design. */
export function printed(app: PasuApp, address: () => string): void {
  const sheet = document.createElement("pasu-printed");
  const root = sheet.attachShadow({ mode: "open" });
  const [paper, own] = [sheetOf(PAPER), sheetOf(SHEET)];
  root.adoptedStyleSheets = [own];
  window.addEventListener("beforeprint", () => {
    const { shown } = app.designer.surface;
    if (!shown) return;
    render(written(app, shown.design, address()), root);
    document.adoptedStyleSheets = [...document.adoptedStyleSheets, paper];
    document.body.append(sheet);
  });
  window.addEventListener("afterprint", () => {
    document.adoptedStyleSheets = document.adoptedStyleSheets.filter((style) => style !== paper);
    sheet.remove();
    render(nothing, root);
  });
}

function sheetOf({ cssText }: CSSResult): CSSStyleSheet {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(cssText);
  return sheet;
}

function written(app: PasuApp, design: Design, address: string) {
  const { designer } = app;
  const [unit, { parts }] = [unitOf(design), design];
  const more = parts.length - MOST_PARTS;
  return html`<article>
    <h1>${design.title ?? page.untitled}</h1>
    <p>${designer.description}</p>
    ${picture(app)}
    <h2>${printing.link}</h2>
    ${link(app, design, address)}
    <div class="numbers">
      ${parts.slice(0, MOST_PARTS).map((part, place) => numbers(part, parts.length > 1 ? partName(place, part.name) : null, unit))}
      ${more > 0 ? html`<p>${printing.more(more)}</p>` : nothing} ${measured(app, design)}
    </div>
  </article>`;
}

/** As it is seen, in light colours, with nothing round it that would be ink. */
function picture({ stage: view }: PasuApp) {
  const { stage } = view;
  stage?.theme("light");
  const drawn = stage?.still(WIDTH, HEIGHT, true) ?? null;
  // It gives the stage its own colours again.
  view.requestUpdate();
  return drawn ?? copied(view.renderRoot.querySelector<HTMLCanvasElement>("canvas.still")) ?? nothing;
}

/** The still picture of a browser that has no stage. */
function copied(still: HTMLCanvasElement | null): HTMLCanvasElement | null {
  if (!still || still.width === 0) return null;
  const copy = document.createElement("canvas");
  copy.width = still.width;
  copy.height = still.height;
  copy.getContext("2d")?.drawImage(still, 0, 0);
  return copy;
}

/** Those of a named family one by one, and where the rings of a pot are; of any other shape there are too many, and they stand in the file. */
function numbers({ shape, wall }: Design["parts"][number], name: string | null, unit: Unit) {
  const length = (value: number) => lengthWords(value, unit, DIGITS);
  const clay = wall ? [line(printing.wall, length(wall.thickness)), line(printing.floor, length(wall.base))] : [];
  return html`<section>
    <h3>${name === null ? parameters.kinds[shape.kind] : printing.part(name, parameters.kinds[shape.kind])}</h3>
    <dl>${ownNumbers(shape, length)}${clay}</dl>
  </section>`;
}

function ownNumbers(shape: Shape, length: (value: number) => string) {
  if (shape.kind === "rings") {
    return shape.rings.map(({ r, z }, place) =>
      line(printing.ring(place + 1), printing.radiusAt(length(r.mean ?? 0), length(z.mean ?? 0))),
    );
  }
  const family = familyOf(shape.kind);
  return family?.fields.map((field) => {
    const value = fieldValue(shape, field);
    return line(
      html`${fieldWords(family.kind, field.key).name} <span class="symbol">${symbol(field.symbol)}</span>`,
      field.dimension === "length" ? length(value) : formatNumber(value),
    );
  });
}

/** What is known by now. */
function measured({ designer }: PasuApp, design: Design) {
  const { value, of } = designer.made?.measures ?? {};
  if (!value || of !== design) return nothing;
  const { part } = designer.store;
  const name = design.parts.length > 1 ? partName(part, design.parts[part]?.name) : null;
  return measureGroups(value, part, unitOf(design), false, name).map(
    ({ title, lines, reason }) => html`<section>
      <h3>${title}</h3>
      ${reason === undefined ? nothing : html`<p>${reason}</p>`}
      <dl>
        ${lines.map((each) => line(html`${each.name}${each.note === undefined ? nothing : html`<span class="note">${each.note}</span>`}`, each.value))}
      </dl>
    </section>`,
  );
}

function line(name: unknown, value: string) {
  return html`<div><dt>${name}</dt><dd>${value}</dd></div>`;
}

function link({ designer }: PasuApp, design: Design, address: string) {
  const { settled } = designer.surface;
  // What a hand is still at has a link when it is at rest.
  if (settled?.design !== design) return html`<p>${printing.linkUnknown}</p>`;
  const fragment = settled.solved.link;
  if (fragment === "") return html`<p>${printing.noLink}</p>`;
  const whole = `${address}#${fragment}`;
  if (whole.length <= MOST_LETTERS) return html`<p><a href=${whole}>${whole}</a></p>`;
  return html`<p>${printing.longLink(whole.length)}</p>
    <p><a href=${whole}>${whole.slice(0, SHOWN_LETTERS)}…</a></p>`;
}
