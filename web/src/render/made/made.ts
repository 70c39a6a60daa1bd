import type { Camera } from "../camera";
import { ceramic } from "../ceramic";
import { Buffer } from "../gl/buffer";
import type { Drawable } from "../gl/drawable";
import { Geometry } from "../gl/geometry";
import type { Material, Uniform } from "../gl/material";
import { IDENTITY, type Matrix } from "../gl/view";
import { lookKey, type StageLook } from "../glaze";
import { WHOLE } from "../ground";
import type { Bounds, Span } from "../mesh";
import type { Spot } from "../overlay/label";
import type { Word } from "../overlay/overlays";
import type { Face } from "../picker";
import { newPlacing, type Placing, place } from "../placing";
import type { Coat } from "../pot";
import type { Guest, Place } from "../stage";
import { toScene } from "../studio";
import { at, type Triple } from "../triple";
import { mapCoat, type StageMap } from "./map-coat";
import { type StageWater, Water } from "./water";

/** The faces of a pot that its own mesh does not show. */
export interface StageSolid {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  /** Lining (1) or not (0), distance to rim and to foot, depth in radii of the mouth. */
  readonly wares: Float32Array;
  readonly indices: Uint32Array;
  /** (first index, count of indices, part) triples. */
  readonly groups: Uint32Array;
  readonly bounds: Bounds | null;
  /** Where the clay is on the surface of each part. */
  readonly sides: readonly ("inside" | "outside" | null)[];
  /** From which height to which the outside of each part stands, where its own mesh does not show that. */
  readonly outsides: readonly (Span | null)[];
}

/** Where the hand takes hold of the water, in CSS pixels, and how many of them upwards one model unit is. */
export interface Hold extends Spot {
  readonly perUnit: number;
}

/** No water: everything is above. */
const DRY = -1e9;
/** How far the handle stands off the pot, as a share of its half width. */
const STAND_OFF = 1.12;
/** Seen from above the handle could not be moved up or down: it is not shown when a unit of height is shorter than this share of one seen square. */
const LEAST_RISE = 0.12;

/** Which side of the design's surface is within the clay. */
const CORES = { inside: -1, outside: 1, none: 0 } as const;

/** What is made comes placed. */
const SOLID_PLACING = { ...newPlacing() };
const SOLID = { ...SOLID_PLACING, span: { value: [0, 1] } };

/** Where the faces of a part are that was moved since they were made. */
type Moved = { readonly [name in keyof Placing]: Placing[name] } & { readonly span: Uniform<Span> };

const DEFAULT_LOOK: StageLook = { glaze: "celadon", inside: "celadon", line: 0, clay: "stoneware" };

/** What is made of the design: its wall, the water in it, the colours of a map, and the cut that lets one look inside. */
export class Made implements Guest {
  /** Where the handle of the water is; null where it cannot be held. */
  onHold: (hold: Hold | null) => void = () => {};
  readonly cutPlane: Uniform<readonly number[]> = { value: WHOLE };
  private readonly positions = newBuffer(3);
  private readonly normals = newBuffer(3);
  private readonly wares = newBuffer(4);
  private readonly indices = new Buffer(new Uint32Array(), { size: 1, dynamic: true });
  private geometry: Geometry;
  private lining: Buffer | null = null;
  private readonly water: Water;
  private readonly level: Uniform<number> = { value: DRY };
  private readonly materials = new Map<string, Material>();
  /** One for every run of faces with the same material. */
  private solids: Drawable[] = [];
  private made: StageSolid | null = null;
  /** By which each part was moved since; null where its faces are none of it any more. */
  private motions: readonly (Matrix | null)[] = [];
  private readonly moved = new Map<number, Moved>();
  private looks: readonly StageLook[] = [];
  /** Of what the draw calls were made: which looks there are, and what was moved. */
  private looked = "";
  private went = "";
  private surface: StageWater | null = null;
  private filled: number | null = null;
  private map: StageMap | null = null;
  private mapped = false;
  private open = false;

  constructor(private readonly place: Place) {
    this.geometry = this.newGeometry();
    this.water = new Water(place.studio, this.cutPlane);
  }

  get drawables(): readonly Drawable[] {
    return [...this.solids, this.water.drawable];
  }

  /** The faces by their parts, for whoever asks what is seen at a point. */
  get faces(): readonly Face[] {
    const { made, geometry } = this;
    const faces: Face[] = [];
    for (let g = 0; made && g < made.groups.length; g += 3) {
      const part = at(made.groups, g + 2);
      if (!this.shows(part)) continue;
      const range = [at(made.groups, g), at(made.groups, g + 1)] as const;
      faces.push({ geometry, uniforms: this.moved.get(part) ?? SOLID_PLACING, range, part });
    }
    return faces;
  }

  coreOf(place: number): number {
    return this.open ? CORES[this.sideOf(place) ?? "none"] : 0;
  }

  /**
   * Shows the faces of a pot, whose arrays are the stage's from now on, or none. Gives back those that were shown before. Faces of parts that were moved since they were made go along by their `motions`; those of a part that has none are
   * not shown. `extent` is what everything fills then.
   */
  show(
    made: StageSolid | null,
    looks: readonly StageLook[],
    motions: readonly (Matrix | null)[] = [],
    extent: Bounds | null = made?.bounds ?? null,
  ): StageSolid | null {
    const before = this.made;
    const [looked, went] = [looks.map(lookKey).join(), motions.map(kindOf).join()];
    const alike = made === before && looked === this.looked && went === this.went;
    [this.looked, this.went] = [looked, went];
    this.looks = looks;
    this.motions = motions;
    if (made !== before) {
      this.made = made;
      this.line(null);
      if (made) {
        this.positions.array = made.positions;
        this.normals.array = made.normals;
        this.wares.array = made.wares;
        this.indices.array = made.indices;
      } else this.drop();
    }
    this.place.pot.extent = made && extent;
    this.move();
    // Who moves a part has the others as they were.
    if (alike) this.place.changed();
    else this.dress();
    return made === before ? null : before;
  }

  /** Pours water in up to a level, or out at null. Its surface may be that of another level, until it is known. */
  pour(water: StageWater | null, level: number | null): void {
    const surface = level === null ? null : water;
    if (surface !== this.surface) {
      this.surface = surface;
      this.water.surface = surface;
    }
    this.filled = level;
    this.place.changed();
  }

  /** Colours the pot by values of its vertices; grey at undefined, which stands for values that are still to come; its glaze at null. */
  paint(map: StageMap | undefined | null): void {
    this.mapped = map !== null;
    if (map && map !== this.map) {
      this.forgetMaterials("map");
      this.place.pot.values = map.values;
    }
    this.map = map ?? null;
    const lining = this.map?.lining ?? null;
    this.line(lining && lining.length === this.positions.count ? lining : null);
    this.dress();
  }

  /** What a map shows inside. */
  private line(values: Float32Array | null): void {
    if ((this.lining?.array ?? null) === values) return;
    this.geometry.release();
    this.lining?.release();
    this.lining = values && new Buffer(values, { size: 1 });
    this.geometry = this.newGeometry();
  }

  private newGeometry(): Geometry {
    const { positions, normals, wares, indices, lining } = this;
    return new Geometry({ position: positions, normal: normals, wares, ...(lining && { value: lining }) }, indices);
  }

  /** Takes the half before the eye away, or puts it back. */
  cut(open: boolean): void {
    this.open = open;
    this.dress();
  }

  /** What is said beside the dimensions, where these are seen. */
  say(words: readonly Word[]): void {
    this.place.overlay.words = words;
    this.place.changed();
  }

  forget(): void {
    // Colours belong to vertices, and those are others now; which parts are hidden may be different too.
    if (this.map) this.paint(undefined);
    else this.clothe();
  }

  prepare(camera: Camera, width: number, height: number): void {
    const { studio, pot } = this.place;
    const { azimuth } = camera.pose;
    const { bounds } = pot;
    if (this.open && bounds) {
      const [x, y] = [Math.cos(azimuth), Math.sin(azimuth)];
      const centre = toScene(studio, bounds.centre);
      this.cutPlane.value = [x, y, 0, x * centre[0] + y * centre[1]];
    } else this.cutPlane.value = WHOLE;
    const level = this.filled;
    this.level.value = level === null ? DRY : toScene(studio, [0, 0, level])[2];
    this.onHold(bounds && level !== null ? this.holdOf(level, camera, bounds, width, height) : null);
  }

  release(): void {
    this.drop();
    this.water.release();
  }

  dispose(): void {
    this.release();
  }

  private drop(): void {
    this.geometry.release();
    for (const buffer of [this.positions, this.normals, this.wares, this.indices, this.lining]) buffer?.release();
  }

  /** Where the motions have taken what was moved, with the heights between which its glaze runs. */
  private move(): void {
    for (const part of [...this.moved.keys()]) if (!isMoved(this.motions[part])) this.moved.delete(part);
    for (const [part, motion] of this.motions.entries()) {
      if (!isMoved(motion)) continue;
      const moved = this.moved.get(part) ?? { ...newPlacing(), span: { value: [0, 1] } };
      this.moved.set(part, moved);
      place(moved, motion);
      moved.span.value = this.spanOf(part);
    }
  }

  /** Whether the faces of a part are seen, by its place in the document. */
  private shows(part: number): boolean {
    return this.motions[part] !== null && !this.place.pot.hides(part);
  }

  private sideOf(part: number): "inside" | "outside" | null {
    return this.motions[part] === null ? null : (this.made?.sides[part] ?? null);
  }

  private dress(): void {
    const { pot } = this.place;
    const coreOf = (part: number) => CORES[this.sideOf(part) ?? "none"];
    const coat: Coat | null = this.mapped
      ? (_, part) => this.mapMaterial(this.map, this.made ? coreOf(part) : 0)
      : this.open
        ? (look, part) => this.glazed(look, coreOf(part), false)
        : null;
    pot.coat = coat;
    this.clothe();
    this.place.changed();
  }

  /** One draw call for each run of faces that look the same. */
  private clothe(): void {
    const { made, geometry } = this;
    this.solids = [];
    for (let g = 0; made && g < made.groups.length; g += 3) {
      const part = at(made.groups, g + 2);
      if (!this.shows(part)) continue;
      const look = this.looks[part] ?? DEFAULT_LOOK;
      const material = this.mapped
        ? this.mapMaterial(this.map?.lean || this.lining ? this.map : null, -1)
        : this.glazed(look, -1, true);
      const [start, count] = [at(made.groups, g), at(made.groups, g + 1)];
      const last = this.solids.at(-1);
      // Parts that are glazed to the foot need not be told apart.
      const moved = this.moved.get(part);
      const own = moved !== undefined || (look.line > 0 && !this.mapped);
      const uniforms = moved ?? (own ? { ...SOLID_PLACING, span: { value: this.spanOf(part) } } : SOLID);
      const on = last?.material === material && last.uniforms === uniforms;
      if (on && last.range && last.range[0] + last.range[1] === start) {
        last.range = [last.range[0], last.range[1] + count];
      } else {
        const range: [number, number] = [start, count];
        this.solids.push({ geometry, material, uniforms, order: 0, visible: true, range });
      }
    }
  }

  private spanOf(part: number): Span {
    const outside = this.made?.outsides[part];
    const lifted = this.motions[part]?.[14] ?? 0;
    if (outside) return [outside[0] + lifted, outside[1] + lifted];
    return this.place.pot.parts[part]?.span.value ?? [0, 1];
  }

  private glazed(look: StageLook, core: number, solid: boolean): Material {
    const { open } = this;
    return this.kept(`glaze ${lookKey(look)} ${core} ${solid} ${open}`, () =>
      ceramic(look, this.place.studio, {
        defines: [...(solid ? (["SOLID"] as const) : []), ...(open ? (["CUT"] as const) : [])],
        uniforms: { cut: this.cutPlane, core: { value: core }, level: this.level },
      }),
    );
  }

  private mapMaterial(map: StageMap | null, core: number): Material {
    return this.kept(map ? `map ${core}` : `grey ${core}`, () => mapCoat(this.place.studio, map, this.cutPlane, core));
  }

  private kept(key: string, make: () => Material): Material {
    const found = this.materials.get(key) ?? make();
    this.materials.set(key, found);
    return found;
  }

  private forgetMaterials(prefix: string): void {
    for (const key of [...this.materials.keys()]) if (key.startsWith(prefix)) this.materials.delete(key);
  }

  /** At the right of the pot, at the height of the water. */
  private holdOf(level: number, camera: Camera, bounds: Bounds, width: number, height: number): Hold | null {
    const { min, max, centre } = bounds;
    const { azimuth } = camera.pose;
    const reach = (STAND_OFF * Math.max(max[0] - min[0], max[1] - min[1])) / 2;
    const [x, y] = [centre[0] - Math.sin(azimuth) * reach, centre[1] + Math.cos(azimuth) * reach];
    const unit = reach > 0 ? reach : 1;
    const seen = (point: Triple): Spot | null => {
      const at = camera.view.see(toScene(this.place.studio, point));
      return at.before ? { x: at.x * width, y: at.y * height } : null;
    };
    const here = seen([x, y, level]);
    const above = seen([x, y, level + unit]);
    const beside = seen([centre[0], centre[1], level]);
    if (!here || !above || !beside) return null;
    const perUnit = (here.y - above.y) / unit;
    const square = Math.hypot(here.x - beside.x, here.y - beside.y) / unit;
    return perUnit > LEAST_RISE * square ? { ...here, perUnit } : null;
  }
}

/** What becomes of the faces of a part, where they are not where they were made. */
function kindOf(motion: Matrix | null): string {
  return motion === null ? "absent" : isMoved(motion) ? "moved" : "";
}

function isMoved(motion: Matrix | null | undefined): motion is Matrix {
  return motion ? motion.some((value, i) => value !== IDENTITY[i]) : false;
}

function newBuffer(size: number): Buffer {
  return new Buffer(new Float32Array(), { size, dynamic: true });
}
