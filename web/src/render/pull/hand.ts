import type { Camera } from "../camera";
import type { Drawable } from "../gl/drawable";
import type { PartId } from "../mesh";
import type { Bench, Tool } from "../stage";
import { at, type Triple } from "../triple";
import { Band, type Touch } from "./band";
import { Feeler } from "./feeler";
import type { See, Spot } from "./reach";
import { sightOf } from "./sight";

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
    return part ? sightOf(this.bench, this.size, part.placing.model.value) : null;
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
