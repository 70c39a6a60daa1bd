/** A length that somebody chooses: never 0 and never less. */

import { html } from "lit";
import type { Unit } from "../../document/types";
import "../../ui/number-field";
import type { NumberChangeEvent } from "../../ui/number-field";

const STEPS = 400;

interface Length {
  readonly label: string;
  readonly help: string;
  readonly unit: Unit;
  readonly value: number;
  /** What the slider reaches; more can be typed. */
  readonly most: number;
  /** `gesture` says that more may follow before `done`. */
  readonly set: (value: number, gesture: boolean) => void;
  readonly done?: () => void;
  readonly cancel?: () => void;
}

export function lengthField({ label, help, unit, value, most, set, done, cancel }: Length) {
  return html`<pasu-number
    .label=${label}
    .unit=${unit}
    .help=${help}
    .value=${value}
    .positive=${true}
    .min=${0}
    .max=${most}
    .step=${most / STEPS}
    @number-change=${({ value: chosen, gesture }: NumberChangeEvent) => {
      if (chosen > 0) set(chosen, gesture);
    }}
    @number-done=${done}
    @number-cancel=${cancel}
  ></pasu-number>`;
}
