/** What a pot is traced from: the lines of an SVG file, or the silhouette on a photograph. */

import type { ReactiveController, ReactiveControllerHost } from "lit";
import type { Spot } from "../../document/drawn/knot";
import { MARGIN, SHEET } from "../../document/drawn/sheet";
import { type Sides, sidesOf } from "../../document/drawn/sides";
import type { Smoothing } from "../../document/drawn/stroke";
import { sidesSeen } from "../../document/drawn/tracing";
import { type Photo, photoOf } from "./photo";
import { onSheet, type SvgLine, type SvgRefusal, svgLines } from "./svg-lines";

/** Why nothing was traced. */
export type Trouble = SvgRefusal | "flat" | "no-photo" | "no-pot";

/** Photographs are noisy, lines of a file are not. */
const GRAIN: Smoothing = 4;
const PLAIN: Smoothing = 0;

/** Who draws what was traced; `settled` once the hand has let go. */
interface Tracer extends ReactiveControllerHost {
  takeTraced(sides: Sides, smoothing: Smoothing, settled: boolean): void;
  /** `isOther` where the outline that is there is that of another photograph. */
  failTracing(why: Trouble, isOther?: boolean): void;
}

export class Tracing implements ReactiveController {
  readonly #host: Tracer;
  #photo: Photo | null = null;
  #sensitivity = 0;
  #lines: readonly SvgLine[] = [];
  #chosen = 0;
  /** The file that is being read: of several the last counts. */
  #reading: Blob | null = null;

  constructor(host: Tracer) {
    this.#host = host;
    host.addController(this);
  }

  hostDisconnected(): void {
    this.#reading = null;
  }

  get photo(): Photo | null {
    return this.#photo;
  }

  /** How much of the photograph belongs to the pot: 0 is what was found to be best. */
  get sensitivity(): number {
    return this.#sensitivity;
  }

  get lines(): readonly SvgLine[] {
    return this.#lines;
  }

  /** Which of the lines is traced. */
  get chosen(): number {
    return this.#chosen;
  }

  /** What else the file has. */
  get ghosts(): readonly (readonly Spot[])[] {
    return this.#lines.length > 1 ? this.#lines.map(({ points }) => points) : [];
  }

  get isEmpty(): boolean {
    return this.#photo === null && this.#lines.length === 0;
  }

  read(file: File): Promise<void> {
    return /svg/i.test(`${file.type} ${file.name}`) ? this.readSvg(file) : this.readPhoto(file);
  }

  async readSvg(file: Blob): Promise<void> {
    this.#reading = file;
    const lines = await svgLines(file);
    if (this.#reading !== file) return;
    if (typeof lines === "string") {
      this.#host.failTracing(lines);
      return;
    }
    this.#photo = null;
    this.#lines = onSheet(lines, SHEET, MARGIN);
    this.choose(0);
  }

  async readPhoto(file: Blob): Promise<void> {
    this.#reading = file;
    const photo = await photoOf(file, SHEET);
    if (this.#reading !== file) return;
    if (!photo) {
      this.#host.failTracing("no-photo");
      return;
    }
    const isOther = this.#photo !== null;
    this.#photo = photo;
    this.#lines = [];
    this.tell(0, true, isOther);
  }

  /** Another line of the file. */
  choose(index: number): void {
    const line = this.#lines[index];
    if (!line) return;
    this.#chosen = index;
    const sides = sidesOf(line.points, line.closed, null);
    if (sides) this.#host.takeTraced(sides, PLAIN, true);
    else this.#host.failTracing("flat");
    this.#host.requestUpdate();
  }

  /** Tells the pot on the photograph from what is behind it. */
  tell(sensitivity: number, settled: boolean, isOther = false): void {
    const photo = this.#photo;
    if (!photo) return;
    this.#sensitivity = sensitivity;
    const sides = sidesSeen(photo.picture, photo, sensitivity);
    if (sides) this.#host.takeTraced(sides, GRAIN, settled);
    else this.#host.failTracing("no-pot", isOther);
    this.#host.requestUpdate();
  }

  /** The outline is again one that was traced with this. */
  recall(sensitivity: number): void {
    this.#sensitivity = sensitivity;
    this.#host.requestUpdate();
  }

  withoutPhoto(): void {
    this.#photo = null;
    this.#host.requestUpdate();
  }

  clear(): void {
    this.#reading = null;
    this.#lines = [];
    this.withoutPhoto();
  }
}
