import { Backdrop } from "./backdrop";
import type { Camera } from "./camera";
import type { Device, Tenant } from "./gl/device";
import { Scene } from "./gl/scene";
import { Ground, WHOLE } from "./ground";
import type { Bounds, StageModel } from "./mesh";
import { NOISE } from "./noise";
import { Pot } from "./pot";
import { face, furnish, newStudio, type Studio, type Theme } from "./studio";
import { along, type Triple } from "./triple";

/** The gap between two pots side by side, as a share of the wider one. */
const GAP = 0.22;

/** The clip planes enclose the shadow on the table too, which reaches this many radii of what stands there. */
const SURROUNDINGS = 3.6;

/** The model's frame of reference: scene space is `(model - centre) / radius`. */
export interface Frame {
  centre: Triple;
  radius: number;
}

/** What is photographed: one pot or two on a table before a backdrop, in the light of the studio. */
export class Tableau implements Tenant {
  readonly scene = new Scene();
  readonly studio: Studio;
  readonly backdrop: Backdrop;
  readonly ground: Ground;
  readonly main: Pot;
  frame: Frame = { centre: [0, 0, 0], radius: 1 };
  private beside: Pot | null = null;
  private stale = true;
  /** Where the pot was cut when its shadow was taken; null when it has to be taken again. */
  private shaded: readonly number[] | null = null;
  /** What is seen fills that, where something is hidden. */
  private seenNow: Bounds | null = null;

  constructor(theme: Theme) {
    this.studio = newStudio(theme);
    this.backdrop = new Backdrop(this.studio);
    this.ground = new Ground(this.studio);
    this.main = new Pot(this.studio);
    this.scene.add(this.main, { drawables: [this.backdrop.drawable, this.ground.drawable] });
  }

  set theme(theme: Theme) {
    furnish(this.studio, theme);
  }

  show(model: StageModel): void {
    this.stale = true;
    this.seenNow = null;
    this.main.update(model);
  }

  /** Takes the backdrop away, as for a picture that is cut out, or puts it back. */
  set cutOut(cutOut: boolean) {
    this.backdrop.drawable.visible = !cutOut;
    this.ground.narrow = cutOut;
  }

  /** Puts a second pot to the right of the first, or takes it away. */
  compare(other: StageModel | null): void {
    this.seenNow = null;
    if (other) {
      if (!this.beside) {
        this.beside = new Pot(this.studio);
        this.scene.add(this.beside);
      }
      this.beside.update(other);
    } else if (this.beside) {
      this.scene.remove(this.beside);
      this.beside.release();
      this.beside = null;
    }
    this.stale = true;
  }

  get comparing(): boolean {
    return this.beside !== null;
  }

  /** How far the second pot is moved, in model units: to the right of the first, on the same table. */
  get offset(): Triple {
    const a = this.main.bounds;
    const b = this.beside?.bounds;
    if (!a || !b) return [0, 0, 0];
    const gap = GAP * Math.max(a.max[0] - a.min[0], b.max[0] - b.min[0]);
    return [a.max[0] - b.min[0] + gap, a.centre[1] - b.centre[1], a.min[2] - b.min[2]];
  }

  /** Everything that stands there, in model units; null when there is nothing. */
  get bounds(): Bounds | null {
    const a = this.main.bounds;
    const b = this.beside?.bounds;
    if (!a || !b) return a ?? b ?? null;
    const by = this.offset;
    const min = a.min.map((x, i) => Math.min(x, (b.min[i] as number) + (by[i] as number))) as unknown as Triple;
    const max = a.max.map((x, i) => Math.max(x, (b.max[i] as number) + (by[i] as number))) as unknown as Triple;
    const centre: Triple = [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2, (min[2] + max[2]) / 2];
    return { min, max, centre, radius: Math.hypot(max[0] - centre[0], max[1] - centre[1], max[2] - centre[2]) };
  }

  /** What everything fills that is not hidden, in model units; where all is hidden, everything. */
  get seen(): Bounds | null {
    if (this.main.seen.length === this.main.parts.length) return this.bounds;
    this.seenNow ??= boxed(this.outline()) ?? this.bounds;
    return this.seenNow;
  }

  /** Points (xyz, model units) that a fitted view must contain: about so many of the vertices of what is not hidden. */
  outline(count = 20_000): number[] {
    const points: number[] = [];
    const add = (pot: Pot, by: Triple) => {
      const { seen } = pot;
      const vertices = seen.reduce((sum, part) => sum + part.vertices, 0);
      // An odd stride wanders over the columns of a grid instead of following some of them.
      const stride = 2 * Math.floor(vertices / count) + 1;
      for (const part of seen) {
        for (let v = 0; v < part.vertices; v += stride) points.push(...along(part.at(v), by, 1));
      }
    };
    if (this.main.bounds) add(this.main, [0, 0, 0]);
    if (this.beside?.bounds) add(this.beside, this.offset);
    return points;
  }

  /** What is seen, in scene space. */
  private contents(): Pick<Bounds, "centre" | "radius"> {
    const { seen } = this;
    const { centre, radius } = this.frame;
    if (!seen) return { centre: [0, 0, 0], radius: 1 };
    return {
      centre: along([0, 0, 0], along(seen.centre, centre, -1), 1 / radius),
      radius: Math.max(seen.radius / radius, 1e-6),
    };
  }

  /** Must be called after a change of `frame`. */
  reframe(frame: Frame): void {
    this.frame = frame;
    this.stale = true;
  }

  /** Gives up everything on the GPU, and computes again what is only there when it is next drawn. */
  release(): void {
    this.stale = true;
    this.shaded = null;
    for (const part of [this.main, this.beside, this.backdrop, this.ground]) part?.release();
  }

  /** Brings everything that depends on meshes up to date; cheap when nothing changed. */
  prepare(device: Device): void {
    if (!this.stale) return;
    this.stale = false;
    // One for all tableaus: it goes with the context.
    device.admit(NOISE);
    const { centre, radius } = this.frame;
    this.studio.frame.value = [...centre, 1 / radius];
    const offset = this.offset;
    if (this.beside) this.beside.shift.value = along([0, 0, 0], offset, 1 / radius);
    const { bounds } = this;
    // What is hidden stands on the table all the same.
    this.studio.table.value = bounds ? (bounds.min[2] - centre[2]) / radius : -1;
    this.shaded = null;
  }

  /** Takes the shadow again if it is another one. Only the first pot is ever cut: its parts, each before its own plane, as `cut` is before that of all. */
  shade(device: Device, cut: readonly number[] = WHOLE): void {
    if (this.shaded?.every((each, i) => each === cut[i])) return;
    this.shaded = cut;
    const { centre, radius } = this.contents();
    const standing = [this.main, ...(this.beside ? [this.beside] : [])].filter(({ bounds }) => bounds);
    this.ground.bake(device, standing, [centre[0], centre[1]], radius);
  }

  /** Aims a camera and turns the studio to it. */
  light(camera: Camera, aspect: number): void {
    const { centre, radius } = this.contents();
    camera.aim(this.frame.centre, this.frame.radius, aspect, { centre, radius: radius * SURROUNDINGS });
    this.studio.eye.value = camera.view.eye;
    face(this.studio, camera.pose.azimuth, camera.pose.polar);
  }
}

/** The box round points, and the ball round that. */
function boxed(points: readonly number[]): Bounds | null {
  const ends = (pick: (a: number, b: number) => number, from: number): Triple => {
    const found: [number, number, number] = [from, from, from];
    for (const [i, x] of points.entries()) found[(i % 3) as 0 | 1 | 2] = pick(found[(i % 3) as 0 | 1 | 2], x);
    return found;
  };
  if (points.length === 0) return null;
  const [min, max] = [ends(Math.min, Number.POSITIVE_INFINITY), ends(Math.max, Number.NEGATIVE_INFINITY)];
  const centre: Triple = [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2, (min[2] + max[2]) / 2];
  return { min, max, centre, radius: Math.hypot(max[0] - centre[0], max[1] - centre[1], max[2] - centre[2]) };
}
