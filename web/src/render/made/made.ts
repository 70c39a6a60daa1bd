import type { Camera } from "../camera";
import { ceramic } from "../ceramic";
import type { Drawable } from "../gl/drawable";
import type { Material, Uniform } from "../gl/material";
import { lookKey, type StageLook } from "../glaze";
import { WHOLE } from "../ground";
import type { Bounds } from "../mesh";
import type { Spot } from "../overlay/label";
import type { Word } from "../overlay/overlays";
import type { Face } from "../picker";
import type { Coat } from "../pot";
import type { Guest, Place } from "../stage";
import { toScene } from "../studio";
import type { Triple } from "../triple";
import { Faces, type Motions, type StageSolid } from "./faces";
import { mapCoat, type StageMap } from "./map-coat";
import { type StageWater, Water } from "./water";

/** Where the hand takes hold of the water, in CSS pixels, and how many of them upwards one model unit is. */
export interface Hold extends Spot {
  readonly perUnit: number;
}

/** No water: everything is above. */
const DRY = -1e9;
/** How far the handle stands off the pot, as a share of its half width. */
const STAND_OFF = 1.12;
/** So many CSS pixels are left for it and for what is said beside it at the right edge of the stage. */
const HOLD_ROOM = 104;
/** Seen from above the handle could not be moved up or down: it is not shown when a unit of height is shorter than this share of one seen square. */
const LEAST_RISE = 0.12;

/** Which side of the design's surface is within the clay. */
const CORES = { inside: -1, outside: 1, none: 0 } as const;

/** What is made of the design: its wall, the water in it, the colours of a map, and the cut that lets one look inside. */
export class Made implements Guest {
  /** Where the handle of the water is; null where it cannot be held. */
  onHold: (hold: Hold | null) => void = () => {};
  readonly cutPlane: Uniform<readonly number[]> = { value: WHOLE };
  private readonly walls: Faces;
  /** Those of parts that a hand changed since, in place of their walls as they were. */
  private readonly changed: Faces;
  private readonly water: Water;
  private readonly level: Uniform<number> = { value: DRY };
  private readonly materials = new Map<string, Material>();
  /** One for every run of faces with the same material. */
  private solids: Drawable[] = [];
  private looks: readonly StageLook[] = [];
  /** Of which looks the draw calls were made. */
  private looked = "";
  private surface: StageWater | null = null;
  private filled: number | null = null;
  private map: StageMap | null = null;
  private mapped = false;
  private open = false;

  constructor(private readonly place: Place) {
    this.walls = new Faces(place.pot);
    this.changed = new Faces(place.pot);
    this.water = new Water(place.studio, this.cutPlane);
  }

  get drawables(): readonly Drawable[] {
    return [...this.solids, ...this.water.drawables];
  }

  /** The faces by their parts, for whoever asks what is seen at a point. */
  get faces(): readonly Face[] {
    return [...this.walls.seen, ...this.changed.seen];
  }

  coreOf(place: number): number {
    return this.open ? CORES[this.sideOf(place) ?? "none"] : 0;
  }

  /**
   * Shows the faces of a pot, whose arrays are the stage's from now on, or none. Gives back those that were shown before. Faces of parts that were moved since they were made go along by their `motions`; those of a part that has none are
   * not shown. `extent` is what everything fills then. In place of parts that a hand `changed` their faces by now are shown.
   */
  show(
    made: StageSolid | null,
    looks: readonly StageLook[],
    motions: Motions = [],
    extent: Bounds | null = made?.bounds ?? null,
    changed: { readonly made: StageSolid; readonly motions: Motions } | null = null,
  ): { readonly walls: StageSolid | null; readonly changed: StageSolid | null } {
    const before = [this.walls.made, this.changed.made] as const;
    const looked = looks.map(lookKey).join();
    const others = [this.walls.take(made, motions), this.changed.take(changed?.made ?? null, changed?.motions ?? [])];
    const alike = looked === this.looked && !others.includes(true);
    this.looked = looked;
    this.looks = looks;
    this.place.pot.extent = made && extent;
    // Who moves a part has the others as they were.
    if (alike) this.place.changed();
    else this.dress();
    const left = <T>(was: T, is: T) => (was === is ? null : was);
    return { walls: left(before[0], this.walls.made), changed: left(before[1], this.changed.made) };
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
    this.walls.line(lining && lining.length === this.walls.count ? lining : null);
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
    // Colours belong to vertices, and those are others now; which parts are hidden may be different too.
    if (this.map) this.paint(undefined);
    else this.clothe();
  }

  prepare(camera: Camera, width: number, height: number): void {
    const { studio, pot } = this.place;
    const { azimuth } = camera.pose;
    const { bounds } = pot;
    const [x, y] = [Math.cos(azimuth), Math.sin(azimuth)];
    const through = (middle: Triple): readonly number[] => {
      const centre = toScene(studio, middle);
      return [x, y, 0, x * centre[0] + y * centre[1]];
    };
    const isCut = this.open && bounds !== null;
    this.cutPlane.value = isCut ? through(bounds.centre) : WHOLE;
    // Of several objects each shows its inside, and none is taken away because it stands before the others.
    for (const part of pot.parts) part.cut.value = isCut && part.middle ? through(part.middle) : this.cutPlane.value;
    if (isCut) this.water.part(pot.parts.flatMap(({ middle, cut }) => (middle ? [{ middle, cut }] : [])));
    const level = this.filled;
    this.level.value = level === null ? DRY : toScene(studio, [0, 0, level])[2];
    this.onHold(bounds && level !== null ? this.holdOf(level, camera, bounds, width, height) : null);
  }

  release(): void {
    this.walls.drop();
    this.changed.drop();
    this.water.release();
  }

  dispose(): void {
    this.release();
  }

  private sideOf(part: number): "inside" | "outside" | null {
    return this.changed.sideOf(part) ?? this.walls.sideOf(part);
  }

  private dress(): void {
    const { pot } = this.place;
    const coreOf = (part: number) => CORES[this.sideOf(part) ?? "none"];
    const coat: Coat | null = this.mapped
      ? (_, part) => this.mapMaterial(this.map, this.walls.made ? coreOf(part) : 0)
      : this.open
        ? (look, part) => this.glazed(look, coreOf(part), false)
        : null;
    pot.coat = coat;
    this.clothe();
    this.place.changed();
  }

  private clothe(): void {
    const { looks, mapped, map } = this;
    const materialOf = (faces: Faces) => (look: StageLook) =>
      mapped ? this.mapMaterial(map?.lean || faces.isLined ? map : null, -1) : this.glazed(look, -1, true);
    this.solids = [this.walls, this.changed].flatMap((faces) =>
      faces.clothed(looks, mapped, this.open, materialOf(faces)),
    );
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

  /** At the right of the pot, at the height of the water, and on the stage. */
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
    const inside = Math.min(here.x, Math.max(width / 2, width - HOLD_ROOM));
    return perUnit > LEAST_RISE * square ? { x: inside, y: here.y, perUnit } : null;
  }
}
