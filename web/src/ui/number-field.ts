/** A labelled number: slider and text field together. Typed values may leave the slider's range; the wheel does nothing. */

import { css, html, LitElement, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { formatNumber, parseLength, stepped } from "../number";
import { controls } from "../words/english/controls";
import { quantities } from "../words/english/quantities";
import { numberProblemWords } from "../words/typed";
import { icon } from "./icons";
import { type Range, reaching, usable } from "./range";
import { base, buttons, fields } from "./styles";
import { symbol } from "./symbol";

const COARSE_STEPS = 10;

/** The person chose a number; `gesture` says that more may follow before `number-done`. */
export class NumberChangeEvent extends Event {
  readonly value: number;
  readonly gesture: boolean;
  constructor(value: number, gesture: boolean) {
    super("number-change", { bubbles: true, composed: true });
    this.value = value;
    this.gesture = gesture;
  }
}

/** The person wants the number back that was opened, or the one that the paper printed. */
export class NumberResetEvent extends Event {
  readonly to: "opened" | "paper";
  constructor(to: "opened" | "paper") {
    super("number-reset", { bubbles: true, composed: true });
    this.to = to;
  }
}

const ANY = [-Infinity, Infinity] as const;

@customElement("pasu-number")
export class PasuNumber extends LitElement {
  @property() label = "";
  /** What sets this number apart from others of the same label, for example "in x". */
  @property() qualifier = "";
  @property() symbol = "";
  @property() unit = "";
  @property() help = "";
  /** The solver's objection to this very number. */
  @property() problem = "";
  @property({ type: Number }) value = 0;
  @property({ type: Number }) min = 0;
  @property({ type: Number }) max = 1;
  @property({ type: Number }) step = 0.01;
  @property({ type: Boolean }) explain = false;
  /** Without a slider, in a table. */
  @property({ type: Boolean }) compact = false;
  /** There is no number yet: one can be typed, and keys count from `value`. */
  @property({ type: Boolean }) blank = false;
  /** Neither 0 nor less can be typed. */
  @property({ type: Boolean }) positive = false;
  /** What a reset leads back to. */
  @property({ type: Number }) opened: number | null = null;
  /** What the paper printed, to go back to as well. */
  @property({ type: Number }) paper: number | null = null;
  /** What is typed and not (yet) a number, or not yet left. */
  @state() private draft: string | null = null;
  @state() private typo = "";
  @query("#field") private readonly field!: HTMLInputElement;
  @query(".slider") private readonly slider!: HTMLInputElement | null;
  /** Nothing outside of this can be typed, and of what is counted nothing between whole numbers. Nothing that is seen goes by these. */
  within: readonly [least: number, most: number] | undefined;
  counted = false;
  private inGesture = false;
  /** What the slider reaches: from `min` to `max`, and to every number that there was outside of them, unless it was far outside. */
  private range: Range = { low: 0, high: 1 };

  /** The slider where there is one: a field would bring up the keys of a phone. */
  override focus(options?: FocusOptions): void {
    (this.slider ?? this.field).focus(options);
  }

  override willUpdate(changed: Map<PropertyKey, unknown>): void {
    const usual = { low: this.min, high: this.max };
    const isNew = changed.has("min") || changed.has("max");
    // What a hand is at keeps its ends.
    const kept = isNew ? usual : this.inGesture ? this.range : usable(this.range, usual, this.value);
    this.range = reaching(kept, this.value);
    // The number changed from elsewhere (undo, a handle): what was typed no longer stands for anything. Under the hand of who types it stays, whatever was made of it: more digits may follow.
    const stale = changed.has("value") || (changed.has("problem") && this.problem === "");
    if (stale && !this.matches(":focus-within")) this.forget();
  }

  override render() {
    const message = this.typo !== "" ? this.typo : this.problem;
    const text = this.draft ?? (this.blank ? "" : formatNumber(this.value));
    const described = [message === "" ? "" : "problem", this.help === "" ? "" : "help"].filter(Boolean).join(" ");
    const name = this.qualifier === "" ? this.label : controls.qualified(this.label, this.qualifier);
    return html`
      <div class=${this.compact ? "row compact" : "row"} @dblclick=${this.reset}>
        <label for="field" title=${this.explain ? nothing : this.help}>
          <span class=${this.compact ? "spoken" : "name"}>${this.label}</span>
          ${this.qualifier === "" ? nothing : html`<span class="qualifier">${this.qualifier}</span>`}
          ${this.symbol === "" ? nothing : html`<span class="symbol" aria-hidden="true">${symbol(this.symbol)}</span>`}
        </label>
        <span class="ways">${this.back(name, "paper", this.paper)}${this.back(name, "opened", this.opened)}</span>
        <span class="typed" @dblclick=${keepToItself}>
          <input
            id="field"
            class="field"
            type="text"
            inputmode=${this.unit === "" && this.range.low >= 0 ? "decimal" : "text"}
            role="spinbutton"
            autocomplete="off"
            spellcheck="false"
            aria-label=${name}
            .value=${text}
            aria-valuenow=${this.blank ? nothing : this.value}
            aria-valuetext=${this.draft ?? (this.blank ? controls.blank : this.told(text))}
            aria-invalid=${message === "" ? "false" : "true"}
            aria-describedby=${described === "" ? nothing : described}
            @input=${this.typedInto}
            @keydown=${this.fieldKey}
            @keyup=${this.keyUp}
            @focus=${this.selectAll}
            @blur=${this.leave}
          />
          ${this.unit === "" ? nothing : html`<span class="unit" aria-hidden="true">${this.sign}</span>`}
        </span>
        ${
          this.compact
            ? nothing
            : html`<input
                class="slider"
                type="range"
                aria-label=${name}
                aria-valuetext=${this.draft ?? this.told(text)}
                min=${this.range.low}
                max=${this.range.high}
                step="any"
                @input=${this.slid}
                @change=${this.finish}
                @pointerup=${this.finish}
                @pointercancel=${this.cancel}
                @keydown=${this.sliderKey}
                @keyup=${this.keyUp}
                @blur=${this.finish}
              />`
        }
      </div>
      ${message === "" ? nothing : html`<p id="problem" class="problem">${icon("warn")}<span>${message}</span></p>`}
      ${this.help === "" ? nothing : html`<p id="help" class=${this.explain ? "help" : "spoken"}>${this.help}</p>`}
    `;
  }

  /** The unit as it is written. */
  private get sign(): string {
    return quantities.units[this.unit as keyof typeof quantities.units] ?? this.unit;
  }

  private told(number: string): string {
    return this.unit === "" ? number : quantities.spoken(number, this.sign);
  }

  /** A way back to a number, which it names; there is none to where the number is. */
  private back(name: string, to: "opened" | "paper", goal: number | null) {
    if (goal === null || !Number.isFinite(goal) || goal === this.value || this.compact) return nothing;
    // In the paper's pot and in this one a number of the same name may be the same.
    if (to === "paper" && goal === this.opened) return nothing;
    const text = this.told(formatNumber(goal));
    const words = to === "opened" ? controls.resetTo(name, text) : controls.setToPaper(name, text);
    return html`<button
      class="button bare reset"
      type="button"
      aria-label=${words}
      title=${words}
      @click=${() => this.goBack(to)}
    >
      ${icon(to === "opened" ? "reset" : "paper")}${to === "opened" ? html`<span>${formatNumber(goal, 4)}</span>` : nothing}
    </button>`;
  }

  override updated(): void {
    // What only a slider shows would have the browser find the styles of the field again.
    if (!this.slider) return;
    // The browser cuts a value off at the ends that it has at the time: the ends come first, and every time.
    this.slider.value = String(this.value);
    const { low, high } = this.range;
    const share = (this.value - low) / (high - low);
    const fill = Number.isFinite(share) ? Math.min(1, Math.max(0, share)) : 0;
    this.style.setProperty("--fill", `${(100 * fill).toFixed(2)}%`);
  }

  /** A field of a length takes any unit of length; another one its own sign, which says nothing more. */
  private read(text: string) {
    const plain = /[%°]/.test(this.unit) ? text.replace(/(%|°|deg(rees?)?)\s*$/i, "") : text;
    return parseLength(plain, this.unit);
  }

  private send(value: number, gesture: boolean): void {
    this.inGesture = gesture;
    this.dispatchEvent(new NumberChangeEvent(value, gesture));
  }

  private readonly slid = (event: Event): void => {
    const raw = Number((event.target as HTMLInputElement).value);
    this.forget();
    // The browser's own rounding to a step would start at `min`; ours starts at 0 and leaves the ends within reach.
    const { low, high } = this.range;
    const value = raw <= low || raw >= high ? raw : stepped(0, this.step, Math.round(raw / this.step));
    if (value !== this.value) this.send(value, true);
    // Back on the step, where field and fill are.
    else this.updated();
  };

  /** Letting go counts too: a slider that is back where the drag began says nothing of a change. */
  private readonly finish = (): void => {
    if (!this.inGesture) return;
    this.inGesture = false;
    this.requestUpdate();
    this.dispatchEvent(new Event("number-done", { bubbles: true, composed: true }));
  };

  /** The browser took the finger for scrolling: the slider was only in its way. */
  private readonly cancel = (): void => {
    if (!this.inGesture) return;
    this.inGesture = false;
    this.dispatchEvent(new Event("number-cancel", { bubbles: true, composed: true }));
  };

  private readonly typedInto = (event: Event): void => {
    this.draft = (event.target as HTMLInputElement).value;
    const typed = this.read(this.draft);
    if ("problem" in typed) {
      this.typo = numberProblemWords(typed.problem);
      return;
    }
    this.typo = this.refused(typed.value);
    // In an empty field every number is another one.
    if (this.typo === "" && (this.blank || typed.value !== this.value)) this.send(typed.value, true);
  };

  /** Why that cannot be typed here; empty where it can. */
  private refused(value: number): string {
    const [least, most] = this.within ?? ANY;
    if (this.positive && value <= 0) return controls.positive;
    if (value >= least && value <= most && (!this.counted || Number.isInteger(value))) return "";
    return controls.within(this.counted, formatNumber(least), formatNumber(most));
  }

  /** What cannot be stays as it was typed, beside what is said of it. */
  private readonly leave = (): void => {
    if (this.typo === "" && this.problem === "") this.forget();
    this.finish();
  };

  private readonly selectAll = (): void => {
    if (this.typo === "") this.field.select();
  };

  private readonly fieldKey = (event: KeyboardEvent): void => {
    if (event.key === "Enter") {
      this.leave();
    } else if (event.key === "Escape" && this.draft !== null) {
      event.stopPropagation();
      this.forget();
    } else if (event.key === "ArrowUp" || event.key === "ArrowDown") {
      this.nudge(event, event.key === "ArrowUp" ? 1 : -1);
    } else if (event.key === "PageUp" || event.key === "PageDown") {
      this.nudge(event, event.key === "PageUp" ? COARSE_STEPS : -COARSE_STEPS);
    }
  };

  private readonly sliderKey = (event: KeyboardEvent): void => {
    const { key } = event;
    if (key === "ArrowUp" || key === "ArrowRight") this.nudge(event, 1);
    else if (key === "ArrowDown" || key === "ArrowLeft") this.nudge(event, -1);
    else if (key === "PageUp") this.nudge(event, COARSE_STEPS);
    else if (key === "PageDown") this.nudge(event, -COARSE_STEPS);
    else if (key === "Delete" || key === "Backspace") {
      event.preventDefault();
      this.reset();
    }
  };

  private nudge(event: KeyboardEvent, steps: number): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.forget();
    const whole = event.shiftKey && Math.abs(steps) === 1 ? steps * COARSE_STEPS : steps;
    const [least, most] = this.within ?? ANY;
    this.send(Math.min(Math.max(stepped(this.value, this.step, whole), least), most), true);
  }

  private readonly keyUp = (event: KeyboardEvent): void => {
    if (event.key.startsWith("Arrow") || event.key.startsWith("Page") || event.key === "Home" || event.key === "End") {
      this.finish();
    }
  };

  private readonly reset = (): void => {
    if (this.opened !== null && this.opened !== this.value) this.goBack("opened");
  };

  private goBack(to: "opened" | "paper"): void {
    this.forget();
    this.finish();
    this.dispatchEvent(new NumberResetEvent(to));
    // The button is gone with the way that it went.
    this.field.focus({ preventScroll: true });
  }

  private forget(): void {
    this.draft = null;
    this.typo = "";
  }

  static override readonly styles = [
    base,
    buttons,
    fields,
    css`
      :host {
        display: block;
        min-width: 0;
        padding: 5px 0;
      }
      .row {
        display: grid;
        grid-template-columns: 1fr auto auto;
        align-items: center;
        column-gap: 4px;
      }
      label {
        display: flex;
        align-items: baseline;
        gap: 8px;
        min-width: 0;
        /* Two lines are no higher than the field beside them. */
        line-height: 1.2;
      }
      .qualifier {
        color: var(--soft);
        font-size: 0.88em;
      }
      .symbol {
        color: var(--soft);
        font: italic 0.95em var(--font-brand);
        white-space: nowrap;
      }
      .symbol sub {
        font-size: 0.72em;
        line-height: 0;
      }
      .typed {
        position: relative;
        grid-column: 3;
      }
      .field {
        width: 7rem;
        text-align: right;
        font-variant-numeric: tabular-nums;
      }
      .unit {
        position: absolute;
        right: 0.5625rem;
        top: 50%;
        translate: 0 -50%;
        color: var(--soft);
        font-size: 0.86em;
        pointer-events: none;
      }
      .typed:has(.unit) .field {
        padding-right: 2.125rem;
      }
      .ways {
        grid-column: 2;
        display: flex;
      }
      .reset span {
        font-size: 0.84em;
        font-variant-numeric: tabular-nums;
      }
      .reset:has(span) {
        gap: 3px;
        padding-inline: 4px;
      }
      .reset {
        min-width: 30px;
        min-height: 30px;
        opacity: 0;
        color: var(--soft);
      }
      .reset .icon {
        width: 16px;
        height: 16px;
      }
      .row:hover .reset,
      .row:focus-within .reset {
        opacity: 1;
      }
      @media (hover: none) {
        .reset {
          opacity: 1;
          min-width: var(--touch);
          min-height: var(--touch);
        }
      }
      .slider {
        grid-column: 1 / -1;
        width: 100%;
        height: 26px;
        margin: 0;
        background: transparent;
        appearance: none;
        touch-action: pan-y;
        cursor: pointer;
        border-radius: 8px;
      }
      @media (pointer: coarse) {
        .slider {
          height: 40px;
        }
      }
      /* Where colours are forced there are no backgrounds of one's own, and this line is seen in their place. */
      .slider::-webkit-slider-runnable-track {
        height: 4px;
        border-radius: 2px;
        outline: 1px solid transparent;
        background: linear-gradient(to right, var(--accent) var(--fill), var(--line) var(--fill));
      }
      .slider::-moz-range-track {
        height: 4px;
        border-radius: 2px;
        outline: 1px solid transparent;
        background: var(--line);
      }
      .slider::-moz-range-progress {
        height: 4px;
        border-radius: 2px;
        background: var(--accent);
      }
      .slider::-webkit-slider-thumb {
        appearance: none;
        width: 18px;
        height: 18px;
        margin-top: -7px;
        border: 2px solid var(--accent);
        border-radius: 50%;
        background: var(--sheet);
        box-shadow: 0 1px 3px var(--shadow);
      }
      .slider::-moz-range-thumb {
        width: 14px;
        height: 14px;
        border: 2px solid var(--accent);
        border-radius: 50%;
        background: var(--sheet);
        box-shadow: 0 1px 3px var(--shadow);
      }
      .slider:active::-webkit-slider-thumb {
        background: var(--accent);
      }
      .compact {
        grid-template-columns: minmax(0, 1fr);
      }
      .compact label {
        position: absolute;
      }
      .compact .typed {
        grid-column: 1;
      }
      .compact .field {
        width: 100%;
      }
      .problem {
        display: flex;
        gap: 6px;
        padding: 4px 0;
        color: var(--warn);
        font-size: 0.92em;
      }
      .problem .icon {
        width: 1.0625rem;
        height: 1.0625rem;
        margin-top: 2px;
      }
      .help {
        color: var(--soft);
        font-size: 0.88em;
        padding-bottom: 4px;
        text-wrap: pretty;
      }
    `,
  ];
}

function keepToItself(event: Event): void {
  event.stopPropagation();
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-number": PasuNumber;
  }
}
