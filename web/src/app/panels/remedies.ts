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
  const findings = (made?.report.value?.findings ?? []).filter(({ remedy }) => remedy);
  // A ring and a drain that were fitted have one wall that says so.
  const first = findings.filter(({ part }, i) => findings.findIndex((finding) => finding.part === part) === i);
  const found = first.flatMap((finding) => button(designer, finding));
  return found.length > 0 && made?.report.of === state.design ? html`<p class="remedies">${found}</p>` : nothing;
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
