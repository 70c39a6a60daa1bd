/** A pot of rings: radius, height and place of each, from the rim to the foot. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import type { Path } from "../../document/path";
import { type Hoop, withSharp } from "../../document/ring-numbers";
import { DesignerElement } from "../../element/designer-element";
import { changeRing } from "../../state/ring-actions";
import { cells } from "../../ui/cells";
import { checks } from "../../ui/checks";
import { base, pointed } from "../../ui/styles";
import { rings as words } from "../../words/english/rings";
import { shapeNumber } from "./shape-number";

@customElement("pasu-rings")
export class PasuRings extends DesignerElement {
  override render() {
    const { design, part } = this.designer.state;
    const shape = design.parts[part]?.shape;
    if (shape?.kind !== "rings") return nothing;
    return html`
      <span class="cell"
        ><span aria-hidden="true">${words.smoothing}</span>${this.number(words.smoothing, ["a"], shape.a ?? 1)}</span
      >
      <ol>
        ${shape.rings.map((hoop, index) => this.hoop(hoop, index, shape.rings.length - 1)).reverse()}
      </ol>
    `;
  }

  private hoop(hoop: Hoop, index: number, last: number) {
    const name = index === 0 ? words.foot : index === last ? words.rim : words.ring(index);
    const between = index > 0 && index < last;
    const waves = (hoop.r.waves?.length ?? 0) + (hoop.z.waves?.length ?? 0);
    const cell = (label: string, path: Path, value: number) => html`<span class="cell"
      ><span aria-hidden="true">${label}</span>${this.number(words.of(label, name), path, value)}</span
    >`;
    return html`<li>
      <h3>${name}${waves === 0 ? nothing : html` <span>${words.waves(waves)}</span>`}</h3>
      <div class="numbers">
        ${cell(words.radius, ["rings", index, "r", "mean"], hoop.r.mean)}
        ${cell(words.height, ["rings", index, "z", "mean"], hoop.z.mean)}
        ${between ? cell(words.place, ["rings", index, "u"], hoop.u) : nothing}
      </div>
      ${
        between
          ? html`<label class="check">
              <input
                type="checkbox"
                .checked=${hoop.sharp ?? false}
                @change=${(event: Event) => this.sharpen(index, (event.target as HTMLInputElement).checked)}
              />
              ${words.sharp}
            </label>`
          : nothing
      }
    </li>`;
  }

  private number(label: string, path: Path, value: number) {
    return shapeNumber(this.designer, label, path, value, this.problemAt(path));
  }

  private sharpen(index: number, sharp: boolean): void {
    this.designer.apply(changeRing(this.designer.state, index, (hoop) => withSharp(hoop, sharp)));
  }

  static override readonly styles = [
    base,
    cells,
    checks,
    pointed,
    css`
      :host {
        display: block;
      }
      ol {
        display: grid;
        gap: 10px;
        margin: 10px 0;
        padding: 0;
        list-style: none;
      }
      li {
        padding: 8px 12px 12px;
        border-radius: 12px;
        background: var(--well);
      }
      h3 {
        padding: 2px 0 6px;
        font-size: 0.95rem;
        font-weight: 650;
      }
      h3 span {
        color: var(--soft);
        font-weight: 400;
      }
      .numbers {
        display: grid;
        grid-template-columns: repeat(3, minmax(0, 1fr));
        gap: 6px 8px;
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-rings": PasuRings;
  }
}
