/** Saving a file to make the pot from: what, how large, how finely; what comes out and the verdict of the checks before it is saved. */

import { html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { closes } from "../../document/closes";
import { unitOf } from "../../document/look";
import {
  boundOf,
  type Choices,
  capacityIn,
  choicesOf,
  FORMATS,
  fileFormat,
  hasGlued,
  makingOf,
  type Problem,
  type SizeKind,
  scaleOf,
  toleranceIn,
  trianglesOf,
} from "../../document/saving";
import type { Format, Making, Measures, Product, Refusal, Report, Unit } from "../../document/types";
import { capacityUnit } from "../../document/volume-units";
import { formatNumber } from "../../number";
import { setExport } from "../../state/actions";
import { checks } from "../../ui/checks";
import { choiceStyles, choices } from "../../ui/choices";
import "../../ui/dialog";
import { DesignerElement } from "../../element/designer-element";
import { grouped, isolated } from "../../language";
import { base, buttons, fields } from "../../ui/styles";
import { withoutPairs, withScene } from "../../words/constraints";
import { exporting as words } from "../../words/english/export";
import { page } from "../../words/english/page";
import { quantities } from "../../words/english/quantities";
import { lengthWords } from "../../words/quantities";
import { refusalWords } from "../../words/refusals";
import { checked, inFile, madeOf, type Sentence } from "../../words/report";
import { opensAgain, problemWords, sizesOf } from "../../words/saving";
import { fileName, saveBlob } from "../../work/files";
import { hiddenNote } from "../hidden-note";
import { sentenceStyles, sentences } from "../sentences";
import { exportStyles } from "./export-styles";

const SIZES: readonly SizeKind[] = ["designed", "height", "width", "capacity"];

/** The dialogue asks for itself, whatever the panels ask meanwhile. */
const MEASURING = "export measure";
const CHECKING = "export check";

const TYPING_MS = 300;

/** More is not listed: the first say enough. */
const MOST_SENTENCES = 6;

@customElement("pasu-export")
export class PasuExport extends DesignerElement {
  @state() private chosen: Choices = { product: "pot", size: "designed", measure: "", shrinkage: "", tolerance: "" };
  @state() private measures: Measures | null = null;
  @state() private report: Report | null = null;
  @state() private refusal: Refusal | null = null;
  @state() private saving = false;
  /** How far the file is, and how far the check: from 0 to 1; null before anything is known of it. */
  @state() private written: number | null = null;
  @state() private looked: number | null = null;
  @state() private failure = "";
  /** What the report is of, or the one that is under way; empty when there is neither. */
  private asked = "";
  private ended = false;
  /** Whether the tolerance of an opened file was taken over. */
  private fine = false;
  private timer: ReturnType<typeof setTimeout> | undefined;

  override connectedCallback(): void {
    super.connectedCallback();
    this.ended = false;
    if (!this.hasUpdated) this.begin();
    void this.measure();
  }

  private begin(): void {
    const { design, session } = this.designer.state;
    const walled = design.parts.some((part) => part.wall !== undefined);
    // A file that was opened is made again as it was; otherwise the clay is that of the last pot.
    const made = this.designer.opening.making ?? { shrinkage: session.export.shrinkage };
    this.chosen = { ...this.chosen, ...choicesOf(made, unitOf(design), walled) };
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.ended = true;
    clearTimeout(this.timer);
    this.designer.made?.maker.cancel("write", MEASURING, CHECKING);
  }

  private get format(): Format {
    return this.designer.store.session.export.format;
  }

  override render() {
    const { chosen, measures } = this;
    const { design } = this.designer.state;
    const unit = unitOf(design);
    const made = measures && makingOf(this.choices, measures, unit);
    const problem = made && "field" in made ? made : null;
    const making = made && !("field" in made) ? made : null;
    const ready = making !== null && this.report?.ok === true && !this.saving;
    return html`<pasu-dialog ruled heading=${words.heading} @dialog-closed=${this.close}>
      <div class="formats">
        ${choices(
          words.format,
          FORMATS.map(({ format }) => ({ value: format, label: words.formats[format].label })),
          this.format,
          (format) => this.choose({}, { format }),
        )}
        <p class="hint">${words.notes(words.formats[this.format].note, opensAgain(this.format))}</p>
        ${hiddenNote(this.designer)}
      </div>
      ${choices(words.made, this.products(), chosen.product, (product) => this.choose({ product }))}
      <div class="row">
        <label>
          <span>${words.sizeOf}</span>
          <select
            class="field"
            @change=${(event: Event) => this.resize((event.target as HTMLSelectElement).value as SizeKind)}
          >
            ${SIZES.map(
              (value) =>
                html`<option value=${value} .selected=${chosen.size === value} ?disabled=${value === "capacity" && !measures?.capacity}>
                  ${words.sizes[value]}
                </option>`,
            )}
          </select>
        </label>
        ${
          chosen.size === "designed"
            ? nothing
            : this.text(
                "measure",
                words.finished[chosen.size],
                chosen.size === "capacity" ? capacityName(unit) : quantities.units[unit],
                problem,
              )
        }
        ${this.text("shrinkage", words.shrinkage, words.percent, problem)}
        ${fileFormat(this.format).triangles ? this.text("tolerance", words.tolerance, quantities.units.mm, problem, words.fine) : nothing}
      </div>
      ${this.canJoin ? this.join() : nothing} ${this.outcome(making)} ${this.cells()}
      <div slot="actions" class="progress">
        <p class="problem" role="alert">${this.failure}</p>
        <div role="status">
          ${this.saving ? html`<span>${words.writing}</span>${track(words.writing, this.written)}` : this.brief(making)}
        </div>
      </div>
      <button slot="actions" class="button" type="button" @click=${this.saving ? this.stop : this.close}>
        ${this.saving ? words.stop : words.cancel}
      </button>
      <button slot="actions" class="button primary" type="button" ?disabled=${!ready} @click=${() => making && void this.save(making)}>
        ${words.save(words.formats[this.format].label)}
      </button>
    </pasu-dialog>`;
  }

  /** Whether the parts that are glued can be one solid in a file of this format. */
  private get canJoin(): boolean {
    return fileFormat(this.format).triangles && hasGlued(this.designer.state.design, this.chosen.product);
  }

  /** What is asked for of this design in this format. */
  private get choices(): Choices {
    return this.canJoin ? this.chosen : { ...this.chosen, union: false };
  }

  private join() {
    return html`<label class="check">
      <input
        type="checkbox"
        name="union"
        .checked=${this.chosen.union === true}
        @change=${(event: Event) => this.choose({ union: (event.target as HTMLInputElement).checked })}
      />
      <span>${words.join}</span>
    </label>`;
  }

  /** What is inside of a solid between two sections, for programs of analysis. */
  private cells() {
    const { design, part } = this.designer.state;
    const { shape, wall } = design.parts[part] ?? {};
    if (shape?.kind !== "blend" || wall) return nothing;
    import("./export-cells").catch(() => this.designer.notices.say(page.unfetched));
    return html`<pasu-export-cells .designer=${this.designer}></pasu-export-cells>`;
  }

  private products() {
    const { parts } = this.designer.store.design;
    const walled = parts.some((part) => part.wall !== undefined);
    const note = walled
      ? words.solid.note
      : parts.every(({ shape }) => closes(shape))
        ? words.solid.closed
        : words.solid.unwalled;
    return [
      ...(walled ? [{ value: "pot" as Product, ...words.pot }] : []),
      {
        value: "solid" as Product,
        label: words.solid.label,
        note,
      },
    ];
  }

  private text(
    name: "measure" | "shrinkage" | "tolerance",
    label: string,
    unit: string,
    problem: Problem | null,
    placeholder = "0",
  ) {
    const wrong = problem?.field === name ? problemWords(problem) : "";
    return html`<label>
      <span>${label}</span>
      <span class=${unit.length > 3 ? "typed long" : "typed"}>
        <input
          class="field"
          name=${name}
          inputmode="decimal"
          autocomplete="off"
          placeholder=${placeholder}
          .value=${this.chosen[name]}
          aria-invalid=${wrong === "" ? "false" : "true"}
          aria-describedby=${wrong === "" ? nothing : `wrong-${name}`}
          @input=${(event: Event) => this.choose({ [name]: (event.target as HTMLInputElement).value })}
        /><span class="unit">${unit}</span>
      </span>
      ${wrong === "" ? nothing : html`<span class="wrong" id="wrong-${name}">${wrong}</span>`}
    </label>`;
  }

  /** What comes out: sizes, what was applied, how finely, and the verdict. */
  private outcome(making: Making | null) {
    const { measures, report, refusal } = this;
    if (refusal)
      return html`<section class="outcome">${sentences([{ severity: "error", text: refusalWords(refusal, this.designer.store.design) }])}</section>`;
    if (!measures)
      return html`<section class="outcome" aria-busy="true"><p class="wait">${words.measuring}</p></section>`;
    const unit = unitOf(this.designer.store.design);
    if (!making) return nothing;
    const { file, fired, applied } = sizesOf(making, measures, unit);
    return html`<section class="outcome" aria-label=${words.saved}>
      <dl>
        <div><dt>${words.inFile}</dt><dd>${file}</dd></div>
        ${fired === null ? nothing : html`<div><dt>${words.fired}</dt><dd>${fired}</dd></div>`}
        ${applied === "" ? nothing : html`<div><dt>${words.appliedTo}</dt><dd>${applied}</dd></div>`}
        ${report ? this.fineness(report, making, measures) : nothing}
      </dl>
      <div role="status">
        ${
          report && this.isSceneKnown
            ? sentences(this.verdict(report, making, measures))
            : html`<div class="wait">${page.checking}${track(page.checking, this.looked)}</div>`
        }
      </div>
    </section>`;
  }

  private fineness(report: Report, making: Making, measures: Measures) {
    if (!fileFormat(this.format).triangles || report.meshes.length === 0) return nothing;
    const { millimetres } = scaleOf(making, measures, unitOf(this.designer.store.design));
    return html`
      <div><dt>${words.triangles}</dt><dd>${grouped(trianglesOf(report))}</dd></div>
      <div><dt>${words.within}</dt><dd>${lengthWords(boundOf(report, millimetres), "mm", 2)}</dd></div>
    `;
  }

  /** All that the checks say, and how thin the wall is at this size. */
  private found(report: Report, making: Making, measures: Measures): readonly Sentence[] {
    const { state: now, surface } = this.designer;
    const [outline, unit] = [surface.shown?.solved.facts?.outline ?? [], unitOf(now.design)];
    // A closed solid has no wall: how thick it is printed is the slicer's.
    const scene = now.design.parts.length > 1 ? this.designer.made?.constraints.value : null;
    const { millimetres } = scaleOf(making, measures, unit);
    const found = inFile(scene ? withoutPairs(report, scene, now.design) : report, millimetres);
    const own =
      this.chosen.product === "pot"
        ? madeOf(found, measures, outline, unit, millimetres)
        : checked(found, measures, outline, unit, millimetres);
    return scene ? withScene(own, scene, now.design, report) : own;
  }

  /** Whether it is known of several parts how they fit together, or that it cannot be: before that none is called good. */
  private get isSceneKnown(): boolean {
    const { made, store } = this.designer;
    return store.design.parts.length === 1 || made?.isOfNow(made.constraints) === true;
  }

  private verdict(report: Report, making: Making, measures: Measures): readonly Sentence[] {
    const all = this.found(report, making, measures);
    const rest = all.length - MOST_SENTENCES;
    if (rest <= 0) return all;
    return [...all.slice(0, MOST_SENTENCES), { severity: "note", text: words.moreOf(rest) }];
  }

  /** How much there is to mind, where the verdict itself may be out of sight; it is read to nobody twice. */
  private brief(making: Making | null) {
    const { report, measures } = this;
    if (!report || !measures || !making || !this.isSceneKnown || this.failure !== "") return nothing;
    const count = this.found(report, making, measures).filter(({ severity }) => severity === "warning").length;
    if (report.ok && count === 0) return nothing;
    const brief: Sentence = report.ok
      ? { severity: "warning", text: words.warnings(count) }
      : { severity: "error", text: words.unmakeable };
    return html`<div class="brief" aria-hidden="true">${sentences([brief])}</div>`;
  }

  private choose(change: Partial<Choices>, exported: { readonly format?: Format } = {}): void {
    const { designer } = this;
    this.failure = "";
    this.chosen = { ...this.chosen, ...change };
    designer.apply(setExport(designer.state, exported));
    if ("product" in change) {
      this.forget();
      void this.measure();
    } else this.checkSoon();
  }

  /** Begins at the size that the pot has. */
  private resize(size: SizeKind): void {
    const { measures } = this;
    const unit = unitOf(this.designer.store.design);
    const now = {
      designed: undefined,
      height: measures?.height.value,
      width: measures?.width.greatest.value,
      capacity: measures?.capacity && capacityIn(measures.capacity.brim.value, unit),
    }[size];
    this.choose({ size, measure: now === undefined || now === null ? "" : formatNumber(now) });
  }

  private async measure(): Promise<void> {
    const { designer } = this;
    const { product } = this.chosen;
    const opened = await designer.openMade();
    if (!opened) {
      this.close();
      return;
    }
    const { design } = designer.state;
    const outcome = await opened.maker.ask({ kind: "measure", design, product, fill: null }, MEASURING);
    if (this.ended || outcome.state === "superseded" || product !== this.chosen.product) return;
    this.refusal = outcome.state === "refused" ? outcome.refusal : null;
    this.measures = outcome.state === "done" ? outcome.value : null;
    this.beAsFine();
    await this.check();
  }

  /** The first time, as finely as the file that was opened: a tolerance goes by the size, which is known only now. */
  private beAsFine(): void {
    const { measures } = this;
    const { opening, store } = this.designer;
    if (!measures || !opening.making || this.fine) return;
    this.fine = true;
    const tolerance = toleranceIn(opening.making, measures, unitOf(store.design));
    if (this.chosen.tolerance === "") this.chosen = { ...this.chosen, tolerance };
  }

  /** A verdict holds for what it was asked of alone: nothing else is saved by it, not even while the typing goes on. */
  private forget(): void {
    clearTimeout(this.timer);
    this.asked = "";
    this.report = null;
  }

  /** Once the typing rests: to check takes seconds. */
  private checkSoon(): void {
    if (this.asked !== "" && this.asked === this.making()) return;
    this.forget();
    this.timer = setTimeout(() => void this.check(), TYPING_MS);
  }

  /** What the fields ask for, to be compared; empty when that makes no sense. */
  private making(): string {
    const made = this.measures && makingOf(this.choices, this.measures, unitOf(this.designer.store.design));
    return made && !("field" in made) ? JSON.stringify(made) : "";
  }

  private async check(): Promise<void> {
    this.forget();
    const { designer } = this;
    const { design } = designer.state;
    const asked = this.making();
    if (asked === "") return;
    this.asked = asked;
    const making = JSON.parse(asked) as Making;
    this.looked = null;
    const outcome = await designer.made?.maker.ask({ kind: "check", design, making }, CHECKING, (done) => {
      this.looked = done;
    });
    if (this.ended || !outcome || outcome.state === "superseded" || asked !== this.asked) return;
    this.refusal = outcome.state === "refused" ? outcome.refusal : null;
    if (outcome.state === "done") this.report = outcome.value;
    else this.asked = "";
  }

  private async save(making: Making): Promise<void> {
    const { designer, format } = this;
    const { design } = designer.state;
    const maker = designer.made?.maker;
    if (!maker) return;
    this.saving = true;
    this.written = null;
    this.failure = "";
    const outcome = await maker.ask({ kind: "write", design, format, making }, "write", (done) => {
      this.written = done;
    });
    this.saving = false;
    if (this.ended || outcome.state === "superseded") return;
    if (outcome.state === "refused") {
      this.failure = refusalWords(outcome.refusal, design);
      return;
    }
    const { shrinkage = 0 } = making;
    designer.apply(setExport(designer.state, { shrinkage }));
    const name = fileName(design.title, format);
    saveBlob(new Blob([outcome.value.bytes], { type: fileFormat(format).type }), name);
    designer.notices.say(page.savedAs(isolated(name)));
    this.close();
  }

  private readonly stop = (): void => {
    this.designer.made?.maker.cancel("write");
  };

  private readonly close = (): void => {
    this.dispatchEvent(new Event("export-closed"));
  };

  static override readonly styles = [base, buttons, fields, checks, choiceStyles, sentenceStyles, exportStyles];
}

/** How far something is; as long as nothing is known of it, that it goes on. */
function track(label: string, done: number | null) {
  return html`<progress class="track" aria-label=${label} max="1" value=${done ?? nothing}></progress>`;
}

function capacityName(unit: Unit): string {
  return capacityUnit(unit).name === "ml" ? quantities.millilitres : quantities.customary.ounce;
}

declare global {
  interface HTMLElementTagNameMap {
    "pasu-export": PasuExport;
  }
}
