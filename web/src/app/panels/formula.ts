/**
 * A formula as MathML. While a hand drags, only its numbers change, and only they are written again. Its numbers are pointed at with the mouse, or with the arrow keys once it has the focus; Enter or a press goes to the field of the one that is
 * pointed at.
 */

import { css, html, LitElement } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import temml from "temml";
import type { Formula } from "../../equation/writer";
import { base } from "../../ui/styles";
import { equation } from "../../words/english/equation";

/** A number is pointed at: the places of what it is made of, none when it no longer is. */
export class FormulaPointEvent extends Event {
  readonly places: readonly string[];
  constructor(places: readonly string[]) {
    super("formula-point", { bubbles: true, composed: true });
    this.places = places;
  }
}

/** Somebody wants the field of a number. */
export class FormulaChooseEvent extends Event {
  readonly places: readonly string[];
  constructor(places: readonly string[]) {
    super("formula-choose", { bubbles: true, composed: true });
    this.places = places;
  }
}

/** A marked number that is nothing but digits. */
const NUMBER = /(\\class\{m(\d+)\}\{)(\d+(?:(?:\.|\{.\})\d+)?)\}/g;

@customElement("pasu-formula")
export class PasuFormula extends LitElement {
  @property({ attribute: false }) formula: Formula = { tex: "", marks: [] };
  @property() label = "";
  /** The places that are pointed at. */
  @property({ attribute: false }) pointed: readonly string[] = [];
  @query(".math") private readonly math!: HTMLElement;
  /** What is drawn: the formula without its numbers. */
  private drawn = "";
  /** The number that the keys are at. */
  private at = -1;

  override render() {
    return html`<div
      class="math"
      role="group"
      tabindex="0"
      aria-label=${this.label}
      aria-describedby="keys"
      @pointerover=${this.over}
      @pointerleave=${this.leave}
      @blur=${this.leave}
      @click=${this.choose}
      @keydown=${this.key}
    ></div>
    <p id="keys" class="spoken">${equation.keys}</p>`;
  }

  override updated(changed: Map<PropertyKey, unknown>): void {
    if (changed.has("formula")) this.draw();
    if (changed.has("formula") || changed.has("pointed")) this.mark();
  }

  private draw(): void {
    const { tex } = this.formula;
    const frame = tex.replace(NUMBER, "$1}");
    if (frame === this.drawn) {
      for (const [, , mark, number = ""] of tex.matchAll(NUMBER)) {
        const [node] = this.math.getElementsByClassName(`m${mark}`);
        const text = number.replace(/[{}]/g, "");
        if (node && node.textContent !== text) node.textContent = text;
      }
      return;
    }
    this.drawn = frame;
    try {
      temml.render(tex, this.math, {
        displayMode: true,
        throwOnError: true,
        trust: ({ command }: { readonly command: string }) => command === "\\class",
      });
    } catch {
      // Numbers that are none, while something impossible is typed.
      this.drawn = "";
      this.math.textContent = tex;
    }
  }

  private numbers(): Element[] {
    return [...this.math.querySelectorAll("[class]")].filter((each) => placeOf(each) !== null);
  }

  private mark(): void {
    for (const each of this.numbers()) {
      const places = this.formula.marks[placeOf(each) ?? -1] ?? [];
      each.classList.toggle(
        "pointed",
        places.some((place) => this.pointed.includes(place)),
      );
    }
  }

  /** The places of the number that something happened to. */
  private placesOf(event: Event): readonly string[] {
    for (const each of event.composedPath()) {
      if (each === this.math || !(each instanceof Element)) return [];
      const mark = placeOf(each);
      if (mark !== null) return this.formula.marks[mark] ?? [];
    }
    return [];
  }

  private readonly over = (event: Event): void => {
    this.dispatchEvent(new FormulaPointEvent(this.placesOf(event)));
  };

  private readonly leave = (): void => {
    this.at = -1;
    this.dispatchEvent(new FormulaPointEvent([]));
  };

  private readonly choose = (event: Event): void => {
    const places = this.placesOf(event);
    if (places.length > 0) this.dispatchEvent(new FormulaChooseEvent(places));
  };

  private readonly key = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const numbers = this.numbers();
    const last = numbers.length - 1;
    const goal = { ArrowRight: Math.min(this.at + 1, last), ArrowLeft: Math.max(this.at - 1, 0), Home: 0, End: last }[
      event.key
    ];
    if (goal !== undefined) {
      event.preventDefault();
      const number = numbers[goal];
      if (!number) return;
      this.at = goal;
      number.scrollIntoView({ block: "nearest", inline: "nearest" });
      this.dispatchEvent(new FormulaPointEvent(this.formula.marks[placeOf(number) ?? -1] ?? []));
    } else if (event.key === "Enter") {
      const places = this.formula.marks[placeOf(numbers[this.at]) ?? -1] ?? [];
      if (places.length > 0) this.dispatchEvent(new FormulaChooseEvent(places));
    } else if (event.key === "Escape" && this.at >= 0) {
      event.stopPropagation();
      this.leave();
    }
  };

  static override readonly styles = [
    base,
    css`
      :host {
        display: block;
        min-width: 0;
      }
      .math {
        padding: 6px 4px;
        overflow-x: auto;
        overflow-y: hidden;
        border-radius: 8px;
        scrollbar-width: thin;
        outline-offset: -2px;
      }
      math {
        width: max-content;
        min-width: 0;
        margin: 0;
        font-size: 1.06rem;
      }
      /* What Temml's own style sheet would say of the tables that it makes. */
      mtable {
        text-align: left;
      }
      mtd.tml-right {
        text-align: right;
      }
      mtd.tml-left {
        text-align: left;
      }
      [class^="m"] {
        border-radius: 4px;
        cursor: pointer;
      }
      .pointed {
        background: var(--accent-wash);
        color: var(--accent-strong);
        outline: 2px solid var(--accent);
        outline-offset: 1px;
      }
      @media (forced-colors: active) {
        .pointed {
          outline-color: Highlight;
        }
      }
    `,
  ];
}

/** The number of a mark, from its class. */
function placeOf(element: Element | undefined): number | null {
  const [, mark] = /(?:^|\s)m(\d+)(?:\s|$)/.exec(element?.getAttribute("class") ?? "") ?? [];
  return mark === undefined ? null : Number(mark);
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-formula": PasuFormula;
  }
}
