/** What would make a pot of a part that cannot be made, and what is made of one that was fitted, as buttons. */

import { css, html, nothing } from "lit";
import { unitOf } from "../../document/look";
import type { Finding } from "../../document/types";
import { isolated } from "../../language";
import { setWall } from "../../state/wall-actions";
import { report } from "../../words/english/report";
import { partName } from "../../words/parts";
import { remedyWords } from "../../words/remedies";
import type { Designer } from "../../work/designer";

/** One button for each part that has a remedy. */
export function remedies(designer: Designer) {
  const { made, state } = designer;
  const reported = made?.report.of === state.design ? (made.report.value?.findings ?? []) : [];
  const findings = reported.filter(({ remedy }) => remedy);
  // A ring and a drain that were fitted have one wall that says so.
  const first = findings.filter(({ part }, i) => findings.findIndex((finding) => finding.part === part) === i);
  const found = [
    ...first.flatMap((finding) => button(designer, finding)),
    ...state.design.parts.flatMap((_, part) => rounded(designer, part)),
  ];
  return found.length > 0 ? html`<p class="remedies">${found}</p>` : nothing;
}

/** Whether the wall of a part had to be thinned somewhere. */
export function isThinned({ made, state }: Designer, part: number): boolean {
  const measured = made?.measures.of === state.design ? made.measures.value?.parts[part] : null;
  return (measured?.thickness?.thinned.value ?? 0) > 0;
}

function button(designer: Designer, { part, remedy }: Finding) {
  const { design } = designer.state;
  const asked = design.parts[part]?.wall;
  if (!remedy || !asked) return [];
  const words = remedyWords(asked, remedy.wall, unitOf(design));
  const several = design.parts.length > 1;
  return html`<button
    class="button outlined"
    type="button"
    @click=${() => designer.apply(setWall(designer.state, part, remedy.wall))}
  >
    ${several ? report.ofPart(isolated(partName(part, design.parts[part]?.name)), words) : words}
  </button>`;
}

/** A wall that is thinned keeps its thickness where its inside does not follow the outside. */
function rounded(designer: Designer, part: number) {
  const { state } = designer;
  const { shape, wall, name } = state.design.parts[part] ?? {};
  if (!wall || wall.lining || wall.side === "outside" || shape?.kind === "vertex-frame") return [];
  if (!isThinned(designer, part)) return [];
  const words = report.remedies.roundInside;
  return html`<button
    class="button outlined"
    type="button"
    @click=${() => designer.apply(setWall(designer.state, part, { ...wall, lining: {} }))}
  >
    ${state.design.parts.length > 1 ? report.ofPart(isolated(partName(part, name)), words) : words}
  </button>`;
}

export const remedyStyles = css`
  .remedies {
    display: grid;
    gap: 7px;
    justify-items: start;
    padding-block: 9px;
  }
  .remedies .button {
    padding-block: 8px;
    line-height: 1.35;
    text-align: start;
    white-space: normal;
  }
`;
