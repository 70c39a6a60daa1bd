import { vec4 } from "gl-matrix";
import type { Camera } from "../camera";
import type { Drawable } from "../gl/drawable";
import type { PartId } from "../mesh";
import type { Bench, Tool } from "../stage";
import { at, type Triple } from "../triple";
import { Band, type Touch } from "./band";
import { Feeler } from "./feeler";
import type { See, Spot } from "./reach";

type Quad = readonly [number, number, number, number];

/** A point of a part that is seen on the screen. */
export interface Felt {
  /** The place of the part among the others. */
  readonly place: number;
  readonly u: number;
  /** From 0 to 1 round the axis. */
  readonly v: number;
}

/** What pulls at the pot on the stage: it feels what is under the pointer, shows what would move, and knows where things are seen. */
export class Hand implements Tool {
  visible = true;
  /** Called before every frame: what stands over the stage moves with it. */
  onFrame: () => void = () => {};
  private readonly feeler: Feeler;
  private readonly band: Band;
  private size: readonly [number, number] = [0, 0];

  constructor(private readonly bench: Bench) {
    this.feeler = new Feeler(bench.studio);
    this.band = new Band(bench.studio, bench.overlay.pen.ratio);
  }

  get drawables(): readonly Drawable[] {
    return this.visible ? this.band.drawables(this.bench.pot, this.bench.cut()) : [];
  }

  prepare(_camera: Camera, width: number, height: number): void {
    this.size = [width, height];
    this.onFrame();
  }

  /** Shows what a pull would move, or nothing. */
  show(touch: Touch | null): void {
    // Every movement of a hand says so again, and mostly nothing of it is new: no frame is drawn for that.
    if (!this.band.show(touch)) return;
    this.bench.changed();
  }

  /** The point of a part that is seen there, in CSS pixels from the upper left of the stage; `pick` says which part is. */
  feel({ x, y }: Spot, pick: (x: number, y: number) => PartId | null): Felt | null {
    const { parts } = this.bench.pot;
    // Of a pot of one part there is nothing to tell apart.
    const id = parts.length > 1 ? pick(x, y) : parts[0]?.id;
    const place = parts.findIndex((part) => part.id === id);
    const part = parts[place];
    const of = part?.drawable.visible ? this.bench.aim() : null;
    if (!part || !of) return null;
    const found = this.feeler.feel(this.bench.device, part, this.bench.cut(), this.bench.camera.view, { x, y, of });
    return found && { place, u: found[0], v: found[1] };
  }

  /** Where a point of the present mesh of a part is, before placement. */
  pointOf({ place, u, v }: Felt): Triple | null {
    const part = this.bench.pot.parts[place];
    if (!part) return null;
    const { columns, uv } = part.lattice;
    const rows = part.vertices / columns;
    const uOf = (row: number) => at(uv.array, 2 * row * columns);
    let [low, high] = [0, rows - 1];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (uOf(middle) <= u) low = middle;
      else high = middle;
    }
    const gap = uOf(high) - uOf(low);
    const down = gap > 0 ? Math.min(Math.max((u - uOf(low)) / gap, 0), 1) : 0;
    const column = Math.min(Math.floor(v * (columns - 1)), columns - 2);
    const right = v * (columns - 1) - column;
    const p = part.positions.array;
    const value = (row: number, axis: number) => {
      const k = 3 * (row * columns + column) + axis;
      return (1 - right) * at(p, k) + right * at(p, k + 3);
    };
    return [0, 1, 2].map((axis) => (1 - down) * value(low, axis) + down * value(high, axis)) as unknown as Triple;
  }

  /** How points of a part are seen from where the camera is now, and stays seen so, whatever becomes of the camera. */
  sight(place: number): See | null {
    const part = this.bench.pot.parts[place];
    const { view } = this.bench.camera;
    const [width, height] = this.size;
    if (!part || width === 0) return null;
    const [cx = 0, cy = 0, cz = 0, scale = 1] = this.bench.studio.frame.value;
    const model = [...part.placing.model.value];
    const [look, lens] = [view.uniforms.viewMatrix.value, view.uniforms.projectionMatrix.value].map((each) => [
      ...each,
    ]);
    const by = (matrix: readonly number[] | undefined, [x, y, z, w]: Quad): Quad =>
      vec4.transformMat4([0, 0, 0, 0], [x, y, z, w], (matrix ?? []) as number[]) as number[] as unknown as Quad;
    const clip = (point: Triple) => {
      const [px, py, pz] = by(model, [...point, 1]);
      return by(lens, by(look, [scale * (px - cx), scale * (py - cy), scale * (pz - cz), 1]));
    };
    // All of it is linear before the division: found once for the corner and for each axis, so that thousands of points cost little.
    const corner = clip([0, 0, 0]);
    const [ax, ay, az] = (
      [
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
      ] as const
    ).map((axis) => clip(axis).map((value, place) => value - at(corner, place))) as unknown as readonly [
      Quad,
      Quad,
      Quad,
    ];
    return ([px, py, pz]) => {
      const w = px * ax[3] + py * ay[3] + pz * az[3] + corner[3];
      if (!(w > 0)) return null;
      const x = px * ax[0] + py * ay[0] + pz * az[0] + corner[0];
      const y = px * ax[1] + py * ay[1] + pz * az[1] + corner[1];
      return { x: width * (0.5 + (0.5 * x) / w), y: height * (0.5 - (0.5 * y) / w), depth: w };
    };
  }

  /** The angle round the axis of the scene, from which the camera looks. */
  get azimuth(): number {
    return this.bench.camera.pose.azimuth;
  }

  /** Where a part stands: from its mesh to the model. */
  matrixOf(place: number): readonly number[] | null {
    return this.bench.pot.parts[place]?.placing.model.value ?? null;
  }

  /** How large everything is, in model units. */
  get radius(): number {
    return this.bench.pot.bounds?.radius ?? 1;
  }

  release(): void {
    this.feeler.release();
  }
}
