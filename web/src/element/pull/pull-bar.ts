/** The small bar over the stage: which way a hand pulls, where, and how wide. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { type Brush, PETALS, SPREADS, takesRings, WAYS, WIDTHS, within } from "../../document/brush";
import { locksOf, withLock } from "../../document/locks";
import type { Shape } from "../../document/types";
import { formatNumber } from "../../number";
import type { PartId } from "../../state/part-ids";
import { barStyles } from "../../ui/bar";
import { icon } from "../../ui/icons";
import "../../ui/menu";
import { segmented, segments } from "../../ui/segments";
import { base, buttons, fields } from "../../ui/styles";
import { page } from "../../words/english/page";
import { pull as words } from "../../words/english/pull";
import { whyWords } from "../../words/refusals";
import type { Pull } from "../../work/pull";
import { verdictNow } from "../../work/verdict";
import { DesignerElement } from "../designer-element";

/** A point that stays so far behind, as a share of the pot, is seen to. */
const BEHIND = 0.02;

@customElement("pasu-pull-bar")
export class PasuPullBar extends DesignerElement {
  /** The part of which more was asked than its numbers can do: it may become one of rings. */
  @state() private stuck: PartId | null = null;
  @state() private freeing = false;
  /** What was said of how a hand was followed, and has been read. */
  private known: Pull["followed"] | null = null;
  /** Why it cannot. */
  @state() private cannot = "";

  override willUpdate(): void {
    const { pull, state } = this.designer;
    const shape = state.design.parts[state.part]?.shape;
    const id = state.ids[state.part] ?? null;
    if (!pull || !shape || takesRings(shape) || (this.stuck !== null && this.stuck !== id)) this.forget();
    // What was asked last may arrive when the hand has let go.
    else if (pull.followed.behind > BEHIND && pull.followed !== this.known) this.stuck = id;
    else if (pull.grip) this.forget();
  }

  private forget(): void {
    this.stuck = null;
    this.cannot = "";
    this.known = this.designer.pull?.followed ?? null;
  }

  override render() {
    const { pull } = this.designer;
    if (!pull) return nothing;
    const { brush } = pull;
    const { design, part } = this.designer.state;
    const shape = design.parts[part]?.shape;
    // A family of numbers follows as a whole.
    const whole = shape !== undefined && !takesRings(shape);
    const { refusal } = pull.followed;
    const offered = this.stuck !== null;
    const note = refusal ? whyWords(refusal) : pull.followed.spilt ? words.spilt : offered ? words.behind : "";
    const { fault } = this;
    return html`
      <div class="bar" role="group" aria-label=${words.tool}>
        ${choices(words.way, "way", WAYS, brush.way, words.ways, words.wayHelp, (way) => this.change({ way }))}
        ${whole ? nothing : choices(words.spread, "spread", SPREADS, brush.spread, words.spreads, null, (spread) => this.change({ spread }))}
        ${whole ? this.locks(shape) : this.detail(brush)}
        ${shape && takesRings(shape) ? this.ringLocks(shape) : nothing}
      </div>
      <div class=${note === "" ? "note silent" : "note"}>
        <p role="status">${this.cannot === "" ? note : this.cannot}</p>
        ${
          offered && this.cannot === ""
            ? html`<button class="button outlined" type="button" ?disabled=${this.freeing} @click=${this.free}>${words.free}</button>`
            : nothing
        }
        ${
          offered
            ? html`<button class="button bare" type="button" aria-label=${page.dismiss} @click=${() => this.forget()}>${icon("close")}</button>`
            : nothing
        }
      </div>
      <div class=${fault === "" ? "fault silent" : "fault"}>
        ${fault === "" ? nothing : icon("warn")}
        <p role="status">${fault}</p>
      </div>
    `;
  }

  /** The worst of what stands in the way of making the pot as it is under the hand. */
  private get fault(): string {
    const found = verdictNow(this.designer).find(
      ({ severity, support }) => severity === "error" || (severity === "warning" && !support),
    );
    return found?.brief ?? found?.text ?? "";
  }

  /** The pot under the bar stays clear of it. */
  override updated(): void {
    this.dispatchEvent(new Event("bar-shown"));
  }

  /** What of what has rings stays: there is no room for it beside how rings are pulled. */
  private ringLocks(shape: Shape) {
    const { pull } = this.designer;
    const locked = pull?.locked.length ?? 0;
    return html`<pasu-menu label=${words.keep} icon=${locked > 0 ? "locked" : "unlocked"} bare>
      ${this.locks(shape)}
      ${shape.kind === "rings" && this.walled ? html`<p class="about">${words.keepCapacity}</p>` : nothing}
    </pasu-menu>`;
  }

  private get walled(): boolean {
    const { design, part } = this.designer.state;
    return design.parts[part]?.wall !== undefined;
  }

  /** What of it stays. */
  private locks(shape: Shape) {
    const { pull } = this.designer;
    if (!pull) return nothing;
    return html`<span class="locks" role="group" aria-label=${words.keep} title=${words.keepHelp}>
      <span aria-hidden="true">${words.keep}</span>
      ${locksOf(shape, this.walled).map(
        (lock) => html`<label>
          <input
            type="checkbox"
            .checked=${pull.locked.includes(lock)}
            @change=${(event: Event) => {
              pull.locked = withLock(pull.locked, lock, (event.target as HTMLInputElement).checked);
            }}
          />
          ${words.locks[lock]}
        </label>`,
      )}
    </span>`;
  }

  private detail(brush: Brush) {
    switch (brush.spread) {
      case "all":
        return nothing;
      case "side":
        return html`<label class="width" title=${words.widthHelp}>
          <span>${words.width}</span>
          <input
            type="range"
            min=${WIDTHS.least}
            max=${WIDTHS.most}
            step="any"
            .value=${String(brush.width)}
            aria-valuetext=${words.degrees(formatNumber(brush.width, 3))}
            @input=${(event: Event) => this.change({ width: Math.round((event.target as HTMLInputElement).valueAsNumber) })}
          />
        </label>`;
      case "petals":
        return html`<span class="petals" role="group" aria-label=${words.petals}>
          <button class="button bare" type="button" aria-label=${words.fewer} @click=${() => this.count(-1)}>${icon("less")}</button>
          <output>${formatNumber(brush.petals)}</output>
          <button class="button bare" type="button" aria-label=${words.more} @click=${() => this.count(1)}>${icon("add")}</button>
        </span>`;
    }
  }

  /** Makes the part one of rings, so fine that nobody sees a difference. */
  private readonly free = async (): Promise<void> => {
    const { designer } = this;
    this.freeing = true;
    try {
      const { freeNow } = await import("../../work/free-now");
      const outcome = await freeNow(designer);
      if ("cannot" in outcome) this.cannot = outcome.cannot;
      else designer.notices.say(outcome.done);
    } catch {
      designer.notices.say(page.unfetched);
    }
    this.freeing = false;
  };

  private count(by: number): void {
    const { pull } = this.designer;
    if (pull) this.change({ petals: within(pull.brush.petals + by, PETALS.least, PETALS.most) });
  }

  private change(change: Partial<Brush>): void {
    const { pull } = this.designer;
    if (pull) pull.brush = { ...pull.brush, ...change };
  }

  static override readonly styles = [
    base,
    buttons,
    fields,
    segmented,
    barStyles,
    css`
      .bar {
        flex-wrap: wrap;
      }
      select {
        display: none;
      }
      .width {
        display: flex;
        align-items: center;
        gap: 8px;
        min-height: 34px;
      }
      .width input {
        width: 108px;
        accent-color: var(--accent);
      }
      .locks,
      .locks label {
        display: flex;
        align-items: center;
        gap: 6px;
        min-height: 34px;
      }
      .locks {
        gap: 10px;
      }
      .locks > span {
        color: var(--soft);
      }
      .locks label {
        cursor: pointer;
      }
      .locks input {
        width: 1.05rem;
        height: 1.05rem;
        margin: 0;
        accent-color: var(--accent);
      }
      pasu-menu .locks {
        flex-direction: column;
        align-items: flex-start;
        gap: 0;
        padding: 2px 8px;
      }
      .about {
        max-width: 30ch;
        padding: 4px 8px;
        color: var(--soft);
        font-size: 0.88rem;
      }
      .petals {
        display: flex;
        align-items: center;
      }
      .petals .button {
        min-width: 34px;
        min-height: 34px;
      }
      output {
        min-width: 1.6em;
        text-align: center;
        font-variant-numeric: tabular-nums;
      }
      .note,
      .fault {
        display: flex;
        align-items: center;
        gap: 8px;
        max-width: 62ch;
        padding: 5px 6px 5px 11px;
        border-radius: 9px;
        background: var(--sheet);
        font-size: 0.88rem;
      }
      /* Below what the picture makes room for: it comes and goes under the hand, and nothing may move then. */
      .fault {
        position: absolute;
        top: calc(100% + 6px);
        width: fit-content;
        padding: 7px 11px;
        text-wrap: pretty;
      }
      /* It stays where it is, for those who listen: what appears with its words is not read. */
      .silent {
        position: absolute;
        padding: 0;
        background: none;
      }
      .fault .icon {
        flex: none;
        color: var(--warn);
      }
      .note .button {
        flex: none;
        min-height: 34px;
        pointer-events: auto;
      }
      @media (pointer: coarse) {
        .note .button {
          min-height: var(--touch);
        }
        .locks label,
        .width,
        .petals .button {
          min-height: var(--touch);
        }
        .petals .button {
          min-width: var(--touch);
        }
      }
      @media (max-width: 53.6875em) {
        :host {
          inset: 4px 6px auto;
        }
        .bar {
          flex-wrap: nowrap;
          gap: 6px;
          padding: 3px 5px;
        }
        fieldset {
          display: none;
        }
        select {
          display: block;
        }
        .width span {
          position: absolute;
          clip-path: inset(50%);
        }
      }
      /* In one row on the smallest phones, and nothing is cut off at their edge. */
      @media (max-width: 22.5em) {
        .bar {
          flex-wrap: wrap;
          gap: 4px;
        }
        .bar select,
        .bar > .locks {
          font-size: 0.84rem;
        }
        .width input {
          width: 50px;
        }
        .bar > .locks,
        .bar > .locks label {
          gap: 4px;
        }
        .bar > .locks > span {
          position: absolute;
          clip-path: inset(50%);
        }
      }
    `,
  ];
}

/** A few choices beside each other in one piece, or where there is no room for that in a list. */
function choices<T extends string>(
  legend: string,
  name: string,
  all: readonly T[],
  chosen: T,
  labels: Readonly<Record<T, string>>,
  help: Readonly<Record<T, string>> | null,
  choose: (value: T) => void,
) {
  return html`${segments(legend, name, all, chosen, labels, help, choose)}
    <select
      class="field"
      aria-label=${legend}
      .value=${chosen}
      @change=${(event: Event) => choose((event.target as HTMLSelectElement).value as T)}
    >
      ${all.map((value) => html`<option value=${value} .selected=${value === chosen}>${labels[value]}</option>`)}
    </select>`;
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-pull-bar": PasuPullBar;
  }
}
