/** Marks on the stage where a report on the scene has its witness: seen through whatever lies before it, and brought into the picture where it is not in it. */

import { css, html } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { longestOf } from "../../document/boxes";
import { across } from "../../render/place/onto";
import { Watch } from "../../render/place/watch";
import type { Stage } from "../../render/stage";
import { base } from "../../ui/styles";
import { breachWords, witnessWords } from "../../words/constraints";
import { boxesOf } from "../../work/held";
import type { Shown } from "../../work/witness";
import { DesignerElement } from "../designer-element";
import { Lent } from "../lent";

/** So much of the stage at its edge is not looked at, as a share. */
const EDGE = 0.14;
/** Parts that are smaller on the stage than this share of it are brought nearer, until they are as large as that. */
const SMALL = 0.18;
const LARGE = 0.45;

@customElement("pasu-witness")
export class PasuWitness extends DesignerElement {
  @property({ attribute: false }) stage: Stage | null = null;
  @query(".mark") private readonly mark!: HTMLElement;
  private readonly lent = new Lent(
    this,
    (bench) => new Watch(bench),
    (tool) => {
      tool.onFrame = () => this.follow();
    },
  );
  /** The one that was brought into the picture last. */
  private sought: Shown | null = null;

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.sought = null;
  }

  override render() {
    const { shown } = this.designer.witness;
    const at = shown?.breach.at ?? null;
    return html`
      <div class="mark" aria-hidden="true" ?hidden=${at === null} data-severity=${shown?.breach.severity ?? ""}>
        <span>${shown ? witnessWords(shown.breach, shown.of) : ""}</span>
      </div>
      <p class="spoken" role="status">${shown ? breachWords(shown.breach, shown.of) : ""}</p>
    `;
  }

  override updated(): void {
    this.follow();
  }

  /** Moves the mark to where its place is seen. */
  private follow(): void {
    const { shown } = this.designer.witness;
    const at = shown?.breach.at;
    const { stage } = this;
    const { tool: watch } = this.lent;
    const see = watch?.sight();
    if (!shown || !at || !stage || !watch || !see || !this.mark) return;
    const spot = see(at);
    this.mark.style.setProperty("visibility", spot ? "visible" : "hidden");
    if (!spot) return;
    this.mark.style.setProperty("translate", `${spot.x.toFixed(1)}px ${spot.y.toFixed(1)}px`);
    if (this.sought === shown) return;
    this.sought = shown;
    const [width, height] = watch.screen;
    const { ids } = this.designer.store;
    const boxes = boxesOf(this.designer);
    const sizes = [shown.breach.part, shown.breach.other].flatMap((place) => {
      const box = boxes.get(ids[place] ?? -1);
      return box ? [longestOf(box)] : [];
    });
    const largest = Math.max(...sizes, 0) || 1;
    const share = across(see, at, largest) / Math.min(width, height);
    const near = share > 0 && share < SMALL;
    const within = (x: number, long: number) => x > EDGE * long && x < (1 - EDGE) * long;
    if (near || !within(spot.x, width) || !within(spot.y, height)) stage.pan(width / 2 - spot.x, height / 2 - spot.y);
    if (near) stage.zoom(LARGE / share);
  }

  static override readonly styles = [
    base,
    css`
      :host {
        position: absolute;
        z-index: 3;
        inset: 0;
        overflow: hidden;
        pointer-events: none;
      }
      .mark {
        position: absolute;
        top: -13px;
        left: -13px;
        width: 26px;
        height: 26px;
      }
      .mark::before {
        content: "";
        position: absolute;
        inset: 0;
        border: 3px solid var(--warn);
        border-radius: 50%;
        box-shadow:
          0 0 0 2px var(--sheet),
          inset 0 0 0 2px var(--sheet);
      }
      .mark::after {
        content: "";
        position: absolute;
        inset: 10px;
        border-radius: 50%;
        background: var(--warn);
        box-shadow: 0 0 0 2px var(--sheet);
      }
      .mark[data-severity="note"]::before {
        border-color: var(--accent);
      }
      .mark[data-severity="note"]::after {
        background: var(--accent);
      }
      .mark span {
        position: absolute;
        left: 32px;
        top: -20px;
        padding: 3px 9px;
        border: 1px solid var(--line);
        border-radius: 9px;
        background: var(--sheet);
        color: var(--ink);
        font-size: 0.88rem;
        white-space: nowrap;
      }
      @media (forced-colors: active) {
        .mark::before {
          border-color: Highlight;
        }
        .mark::after {
          background: Highlight;
          forced-color-adjust: none;
        }
      }
    `,
  ];
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-witness": PasuWitness;
  }
}
