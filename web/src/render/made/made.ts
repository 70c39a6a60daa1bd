import {
  BufferAttribute,
  BufferGeometry,
  type IUniform,
  Mesh,
  type PerspectiveCamera,
  type RawShaderMaterial,
  Vector3,
  Vector4,
} from "three";
import type { Camera } from "../camera";
import { ceramic } from "../ceramic";
import type { StageLook } from "../glaze";
import type { Bounds } from "../mesh";
import type { Spot } from "../overlay/label";
import type { Word } from "../overlay/overlays";
import type { Coat } from "../pot";
import type { Guest, Place } from "../stage";
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
}

/** Where the hand takes hold of the water, in CSS pixels, and how many of them upwards one model unit is. */
export interface Hold extends Spot {
  readonly perUnit: number;
}

/** Nothing is cut away: no point is that far before the plane. */
const WHOLE = new Vector4(0, 0, 0, 1);
/** No water: everything is above. */
const DRY = -1e9;
/** How far the handle stands off the pot, as a share of its half width. */
const STAND_OFF = 1.12;
/** Seen from above the handle could not be moved up or down: it is not shown when a unit of height is shorter than this share of one seen square. */
const LEAST_RISE = 0.12;

/** Which side of the design's surface is within the clay. */
const CORES = { inside: -1, outside: 1, none: 0 } as const;

const DEFAULT_LOOK: StageLook = { glaze: "celadon", clay: "stoneware" };

/** What is made of the design: its wall, the water in it, the colours of a map, and the cut that lets one look inside. */
export class Made implements Guest {
  readonly objects: readonly Mesh[];
  /** Where the handle of the water is; null where it cannot be held. */
  onHold: (hold: Hold | null) => void = () => {};
  private readonly solid: Mesh<BufferGeometry, RawShaderMaterial[]>;
  private readonly water: Water;
  private readonly cutPlane: IUniform<Vector4> = { value: WHOLE.clone() };
  private readonly level: IUniform<number> = { value: DRY };
  private readonly materials = new Map<string, RawShaderMaterial>();
  private made: StageSolid | null = null;
  private looks: readonly StageLook[] = [];
  private surface: StageWater | null = null;
  private filled: number | null = null;
  private map: StageMap | null = null;
  private mapped = false;
  private open = false;
  private readonly spot = new Vector3();

  constructor(private readonly place: Place) {
    this.solid = new Mesh(new BufferGeometry(), []);
    this.solid.frustumCulled = false;
    this.solid.visible = false;
    this.water = new Water(place.studio, this.cutPlane);
    this.objects = [this.solid, this.water.object];
  }

  /** Shows the faces of a pot, whose arrays are the stage's from now on, or none. Gives back those that were shown before. */
  show(made: StageSolid | null, looks: readonly StageLook[]): StageSolid | null {
    const before = this.made;
    this.looks = looks;
    if (made !== before) {
      this.made = made;
      if (!made || !refilled(this.solid.geometry, made)) {
        this.solid.geometry.dispose();
        if (made) this.solid.geometry = geometryOf(made);
      }
    }
    this.place.pot.extent = made?.bounds ?? null;
    this.solid.visible = made !== null;
    this.dress();
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
      this.drop("map");
      const { geometry } = this.place.pot.object;
      geometry.setAttribute("value", new BufferAttribute(map.values, 1));
    }
    this.map = map ?? null;
    this.dress();
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
    // Colours belong to vertices, and those are others now.
    if (this.map) this.paint(undefined);
  }

  prepare(camera: Camera, width: number, height: number): void {
    const { frame } = this.place.studio;
    const { azimuth } = camera.pose;
    const bounds = this.place.pot.bounds;
    if (this.open && bounds) {
      const [x, y] = [Math.cos(azimuth), Math.sin(azimuth)];
      const centre = this.scene(bounds.centre);
      this.cutPlane.value.set(x, y, 0, x * centre.x + y * centre.y);
    } else this.cutPlane.value.copy(WHOLE);
    this.level.value = this.filled === null ? DRY : (this.filled - frame.value.z) * frame.value.w;
    const level = this.filled;
    this.onHold(bounds && level !== null ? this.holdOf(level, camera.view, bounds, azimuth, width, height) : null);
  }

  release(): void {
    this.solid.geometry.dispose();
    this.water.release();
    for (const material of this.materials.values()) material.dispose();
  }

  dispose(): void {
    this.release();
  }

  private dress(): void {
    const { pot } = this.place;
    const sides = this.made?.sides ?? [];
    const coreOf = (part: number) => CORES[sides[part] ?? "none"];
    const coat: Coat | null = this.mapped
      ? (_, part) => this.mapMaterial(this.map, this.made ? coreOf(part) : 0)
      : this.open
        ? (look, part) => this.glazed(look, coreOf(part), false)
        : null;
    pot.coat = coat;
    this.clothe();
    this.place.changed();
  }

  /** One draw call for each face, with the material of its part. */
  private clothe(): void {
    const { made, solid } = this;
    if (!made) return;
    const { geometry } = solid;
    geometry.clearGroups();
    const used: RawShaderMaterial[] = [];
    for (let g = 0; g < made.groups.length; g += 3) {
      const look = this.looks[at(made.groups, g + 2)] ?? DEFAULT_LOOK;
      const material = this.mapped
        ? this.mapMaterial(this.map?.lean ? this.map : null, -1)
        : this.glazed(look, -1, true);
      const [start, count] = [at(made.groups, g), at(made.groups, g + 1)];
      const last = geometry.groups.at(-1);
      if (last && used.at(-1) === material && last.start + last.count === start) last.count += count;
      else geometry.addGroup(start, count, used.push(material) - 1);
    }
    solid.material = used;
  }

  private glazed(look: StageLook, core: number, solid: boolean): RawShaderMaterial {
    const { studio, pot } = this.place;
    return this.kept(`glaze ${look.glaze} ${look.clay} ${core} ${solid} ${this.open}`, () =>
      ceramic(look, studio, solid ? { shift: pot.uniforms.shift } : pot.uniforms, {
        defines: { ...(solid && { SOLID: "" }), ...(this.open && { CUT: "" }) },
        uniforms: { cut: this.cutPlane, core: { value: core }, level: this.level },
      }),
    );
  }

  private mapMaterial(map: StageMap | null, core: number): RawShaderMaterial {
    return this.kept(map ? `map ${core}` : `grey ${core}`, () => mapCoat(this.place.studio, map, this.cutPlane, core));
  }

  private kept(key: string, make: () => RawShaderMaterial): RawShaderMaterial {
    const found = this.materials.get(key) ?? make();
    this.materials.set(key, found);
    return found;
  }

  private drop(prefix: string): void {
    for (const [key, material] of [...this.materials]) {
      if (!key.startsWith(prefix)) continue;
      material.dispose();
      this.materials.delete(key);
    }
  }

  /** At the right of the pot, at the height of the water. */
  private holdOf(
    level: number,
    camera: PerspectiveCamera,
    { min, max, centre }: Bounds,
    azimuth: number,
    width: number,
    height: number,
  ): Hold | null {
    const reach = (STAND_OFF * Math.max(max[0] - min[0], max[1] - min[1])) / 2;
    const [x, y] = [centre[0] - Math.sin(azimuth) * reach, centre[1] + Math.cos(azimuth) * reach];
    const unit = reach > 0 ? reach : 1;
    const here = this.seen([x, y, level], camera, width, height);
    const above = this.seen([x, y, level + unit], camera, width, height);
    const beside = this.seen([centre[0], centre[1], level], camera, width, height);
    if (!here || !above || !beside) return null;
    const perUnit = (here.y - above.y) / unit;
    const square = Math.hypot(here.x - beside.x, here.y - beside.y) / unit;
    return perUnit > LEAST_RISE * square ? { ...here, perUnit } : null;
  }

  /** Where a point of the model is on the screen. */
  private seen(point: Triple, camera: PerspectiveCamera, width: number, height: number): Spot | null {
    const p = this.scene(point).applyMatrix4(camera.matrixWorldInverse);
    if (p.z >= 0) return null;
    p.applyMatrix4(camera.projectionMatrix);
    return { x: (p.x * 0.5 + 0.5) * width, y: (0.5 - p.y * 0.5) * height };
  }

  private scene(point: Triple): Vector3 {
    const { x, y, z, w } = this.place.studio.frame.value;
    return this.spot.set((point[0] - x) * w, (point[1] - y) * w, (point[2] - z) * w);
  }
}

/** Writes over what is on the graphics card, if all of it is as long as before. */
function refilled(geometry: BufferGeometry, made: StageSolid): boolean {
  const { position, normal, wares } = geometry.attributes;
  const pairs = [
    [position, made.positions],
    [normal, made.normals],
    [wares, made.wares],
    [geometry.index, made.indices],
  ] as const;
  const fits = pairs.every(
    ([attribute, values]) => attribute && attribute.count * attribute.itemSize === values.length,
  );
  if (!fits) return false;
  for (const [attribute, values] of pairs) {
    (attribute as BufferAttribute).array = values;
    (attribute as BufferAttribute).needsUpdate = true;
  }
  return true;
}

function geometryOf(made: StageSolid): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(made.positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(made.normals, 3));
  geometry.setAttribute("wares", new BufferAttribute(made.wares, 4));
  geometry.setIndex(new BufferAttribute(made.indices, 1));
  return geometry;
}
