import type { Tenant } from "../gl/device";
import type { Uniform } from "../gl/material";
import type { Source } from "../gl/scene";
import type { View } from "../gl/view";
import { WHOLE } from "../ground";
import type { Bounds } from "../mesh";
import type { Pot } from "../pot";
import { type Studio, type Theme, toScene } from "../studio";
import type { Triple } from "../triple";
import { type Dimension, dimensionsOf, type Size } from "./dimensions";
import { type Box, clearOf, Label, paint, type Spot } from "./label";
import { ofArrows, ofPolylines, reachOf } from "./segments";
import { type Pen, type Pieces, Stroke, type StrokeStyle } from "./stroke";
import { Wireframe } from "./wireframe";

/** Lines on the surface of a part, computed by the solver: xyz polylines in model units. */
export interface StageLines {
  readonly iso_u: readonly Float32Array[];
  readonly iso_v: readonly Float32Array[];
  readonly rim: Float32Array | null;
  readonly foot: Float32Array | null;
  /** Slopes at the boundary: where, and the derivative there. */
  readonly tangents: readonly { readonly at: Float32Array; readonly along: Float32Array }[];
}

/** Which overlays are seen. */
export interface StageOverlays {
  isoU: boolean;
  isoV: boolean;
  wireframe: boolean;
  boundary: boolean;
  axes: boolean;
}

/** A word at a point of the model. */
export interface Word {
  readonly text: string;
  readonly at: Triple;
}

const WHITE = [1, 1, 1] as const;
const INK = [0.06, 0.06, 0.075] as const;

/**
 * Colours that are told apart with every kind of colour vision (after Okabe and Ito), each with a border of the opposite lightness so that it
 * is seen on white and on black glaze alike.
 */
const STYLES = {
  isoU: { width: 1.9, colour: [0, 0.4, 0.72], border: WHITE, borderWidth: 0.9, opacity: 1, hidden: 0 },
  isoV: { width: 1.9, colour: [0.97, 0.66, 0.02], border: INK, borderWidth: 0.8, opacity: 1, hidden: 0 },
  rim: { width: 3.2, colour: [0.86, 0.33, 0], border: WHITE, borderWidth: 1.1, opacity: 1, hidden: 0.28 },
  foot: { width: 3.2, colour: [0, 0.55, 0.4], border: WHITE, borderWidth: 1.1, opacity: 1, hidden: 0.28 },
  tangents: { width: 2.4, colour: [0.75, 0.36, 0.62], border: WHITE, borderWidth: 1, opacity: 1, hidden: 0.28 },
  axes: { width: 1.6, colour: INK, border: WHITE, borderWidth: 0.6, opacity: 1, hidden: 0.3 },
  pointed: { width: 4.2, colour: [0.95, 0.9, 0.26], border: INK, borderWidth: 1.2, opacity: 1, hidden: 0.4 },
} as const satisfies Record<string, StrokeStyle>;

/** Length of the arrows as a share of the radius of the pot. */
const ARROW = 0.3;

/** Room for a label in CSS pixels. */
const LABEL_WIDTH = 84;
const LABEL_HEIGHT = 28;

function within(x: number, margin: number, size: number): number {
  return size > 2 * margin ? Math.min(Math.max(x, margin), size - margin) : size / 2;
}

type StrokeName = keyof typeof STYLES;

/** Everything that is drawn over the pot to explain it. */
export class Overlays implements Tenant {
  /** In the order in which they are drawn. */
  readonly sources: Source[] = [];
  /** The plane before which lines on the pot are taken away with it. */
  readonly cut: Uniform<readonly number[]> = { value: WHOLE };
  /** Which side of a part stands for its cut: -1 its back, 1 its front, 0 neither. */
  coreOf: (place: number) => number = () => 0;
  readonly pen: Pen = { viewport: { value: [1, 1] }, ratio: { value: 1 } };
  private readonly wireframe: Wireframe;
  private readonly strokes: Record<StrokeName, Stroke>;
  private readonly labels: Label[] = [];
  /** What lies over the stage: words keep clear of it. */
  furniture: readonly Box[] = [];
  private extra: readonly Word[] = [];
  private given: readonly StageLines[] = [];
  private shown: StageOverlays = { isoU: false, isoV: false, wireframe: false, boundary: false, axes: false };
  private dimensions: Dimension[] = [];
  private size: Size | null = null;
  private hinted: readonly Float32Array[] = [];
  /** The part that they are on. */
  private hintedOn = 0;
  private stale = true;
  /** Which sides of the pot face the eye: the dimension lines change their place with it. */
  private side = "";

  constructor(
    private readonly studio: Studio,
    private readonly host: HTMLElement,
    private theme: Theme,
    /** How a length is written. */
    public lengths: (length: number) => string,
  ) {
    const stroke = (name: StrokeName, order: number) => {
      // Dimensions stand beside the pot, and are whole.
      const made = new Stroke(studio, this.pen, STYLES[name], order, name === "axes" ? { value: WHOLE } : this.cut);
      this.sources.push(made);
      return made;
    };
    this.strokes = {
      isoU: stroke("isoU", 20),
      isoV: stroke("isoV", 30),
      rim: stroke("rim", 40),
      foot: stroke("foot", 42),
      tangents: stroke("tangents", 44),
      axes: stroke("axes", 50),
      pointed: stroke("pointed", 48),
    };
    this.wireframe = new Wireframe(studio, this.cut, 10);
    this.sources.push(this.wireframe);
    this.appearance = theme;
  }

  /** Those of every part, in the order of the document. */
  set lines(lines: readonly StageLines[]) {
    this.given = lines;
    this.stale = true;
  }

  /** Curves on a part that somebody points at. */
  point(lines: readonly Float32Array[], part: number): void {
    this.hinted = lines;
    this.hintedOn = part;
    this.stale = true;
  }

  set overlays(overlays: StageOverlays) {
    this.shown = { ...overlays };
    this.stale = true;
  }

  set appearance(theme: Theme) {
    this.theme = theme;
    for (const label of this.labels) label.theme = theme;
    if (theme === "light") this.strokes.axes.recolour(INK, WHITE);
    else this.strokes.axes.recolour(WHITE, INK);
  }

  /** What is said beside the dimensions. */
  set words(words: readonly Word[]) {
    this.extra = words;
  }

  /** How high and wide the pot is said to be. */
  set measures(size: Size | null) {
    this.size = size;
    this.stale = true;
  }

  /** Must be called when the mesh changed. */
  forget(): void {
    this.stale = true;
  }

  /** Brings the lines up to date with the pot; only those that are seen cost anything. */
  prepare(pot: Pot, towards: readonly [number, number]): void {
    const bounds = pot.bounds;
    const side = `${towards[0] >= 0}${towards[1] >= 0}`;
    if (this.shown.axes && bounds && (this.stale || side !== this.side)) this.measureUp(bounds, towards);
    this.side = side;
    if (!this.stale) return;
    this.stale = false;
    const { shown, strokes, given } = this;
    for (const [name, stroke] of Object.entries(strokes) as [StrokeName, Stroke][]) {
      const isSeen =
        name === "pointed"
          ? this.hinted.length > 0
          : shown[name === "rim" || name === "foot" || name === "tangents" ? "boundary" : name];
      stroke.visible = bounds !== null && isSeen;
    }
    this.wireframe.visible = bounds !== null && shown.wireframe;
    if (!bounds) return;
    if (shown.wireframe) this.wireframe.update(pot, this.coreOf);
    // Of what is hidden nothing is seen, and of what is cut open no more than of the surface.
    const onEach = (segments: (lines: StageLines) => Float32Array): readonly Pieces[] =>
      given.flatMap((lines, place) => {
        const part = pot.parts[place];
        return part?.drawable.visible ? [{ segments: segments(lines), middle: part.middle }] : [];
      });
    const line = (one: Float32Array | null) => ofPolylines(one ? [one] : []);
    if (this.hinted.length > 0) {
      const { middle = null } = pot.parts[this.hintedOn] ?? {};
      strokes.pointed.pieces = [{ segments: ofPolylines(this.hinted), middle }];
    }
    if (shown.isoU) strokes.isoU.pieces = onEach(({ iso_u }) => ofPolylines(iso_u));
    if (shown.isoV) strokes.isoV.pieces = onEach(({ iso_v }) => ofPolylines(iso_v));
    if (shown.boundary) {
      strokes.rim.pieces = onEach(({ rim }) => line(rim));
      strokes.foot.pieces = onEach(({ foot }) => line(foot));
      // Among others each has arrows by what it reaches itself: those of a cup are not as long as the table.
      strokes.tangents.pieces = onEach(({ tangents }) =>
        ofArrows(tangents, ARROW * (given.length > 1 ? reachOf(tangents) : bounds.radius)),
      );
    }
  }

  /** Points (xyz, model units) that a fitted view must contain besides the pot: the dimension lines, when they are seen. */
  outline(bounds: Bounds, azimuth: number): number[] {
    if (!this.shown.axes || !this.size) return [];
    return dimensionsOf(bounds, [Math.cos(azimuth), Math.sin(azimuth)], this.size).flatMap(
      (dimension) => dimension.segments,
    );
  }

  /** Sets the size of what is drawn next, in device pixels, and device pixels per CSS pixel. */
  scale(width: number, height: number, ratio: number): void {
    this.pen.viewport.value = [width, height];
    this.pen.ratio.value = ratio;
  }

  /** Moves the labels to where their lines are on a screen of so many CSS pixels. */
  label(view: View, width: number, height: number): void {
    const words = this.placed(view, width, height).map(({ text, spot }) => ({
      text,
      spot: clearOf(spot, [LABEL_WIDTH, LABEL_HEIGHT], this.furniture, height),
    }));
    while (this.labels.length < words.length) {
      const label = new Label(this.host);
      label.theme = this.theme;
      this.labels.push(label);
    }
    this.labels.forEach((label, i) => {
      const word = words[i];
      label.place(word?.text ?? "", word?.spot ?? null);
    });
  }

  /** Writes the labels on a picture. */
  paint(context: CanvasRenderingContext2D, view: View, width: number, height: number, scale: number): void {
    for (const { text, spot } of this.placed(view, width / scale, height / scale)) {
      paint(context, text, { x: spot.x * scale, y: spot.y * scale }, this.theme, scale);
    }
  }

  /** Gives up everything on the GPU. */
  release(): void {
    this.stale = true;
    for (const stroke of Object.values(this.strokes)) stroke.release();
    this.wireframe.release();
  }

  dispose(): void {
    for (const label of this.labels) label.dispose();
  }

  private measureUp(bounds: Bounds, towards: readonly [number, number]): void {
    this.dimensions = this.size ? dimensionsOf(bounds, towards, this.size) : [];
    const segments = new Float32Array(this.dimensions.flatMap((dimension) => dimension.segments));
    this.strokes.axes.pieces = [{ segments, middle: null }];
  }

  private placed(view: View, width: number, height: number): { text: string; spot: Spot }[] {
    if (!this.shown.axes) return [];
    const words: { text: string; spot: Spot }[] = [];
    const dimensions = this.dimensions.map(({ label, length }) => ({ at: label, text: this.lengths(length) }));
    for (const { at: point, text } of [...dimensions, ...this.extra]) {
      const { x, y, before } = view.see(toScene(this.studio, point));
      if (!before) continue;
      words.push({
        text,
        // A label stays on the stage when the middle of its line leaves it.
        spot: {
          x: within(x * width, LABEL_WIDTH / 2, width),
          y: within(y * height, LABEL_HEIGHT / 2, height),
        },
      });
    }
    return words;
  }
}
