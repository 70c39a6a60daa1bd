/** What is made of the design, on the stage: fetched with the first thing to show, and kept in step with that. */

import { changedBetween, motionsBetween } from "../document/carried";
import { looksOf, unitOf } from "../document/look";
import { mapOf, scaleOf } from "../document/maps";
import type { Design, MapName, Triple } from "../document/types";
import { sameSurface } from "../document/wall";
import type { Solid } from "../maker/messages";
import { Made as Drawing, type Hold } from "../render/made/made";
import type { StageMap } from "../render/made/map-coat";
import type { Word } from "../render/overlay/overlays";
import type { Stage } from "../render/stage";
import { around, type Bounds } from "../solver/bounds";
import { boundsWith, type Solved, verticesOf } from "../solver/solved";
import type { Designer } from "../work/designer";
import type { Made } from "../work/made";
import type { Piece } from "../work/piece";
import type { Shown } from "../work/surface";
import "./water-handle";
import { localVolumeWords } from "../words/customary";
import { page } from "../words/english/page";
import { lengthWords } from "../words/quantities";
import type { PasuWaterHandle } from "./water-handle";

export class StageMade {
  readonly #designer: Designer;
  readonly #host: HTMLElement;
  readonly #drawing: Drawing;
  readonly #handle: PasuWaterHandle;
  /** The meshes that colours are of. */
  #meshes: readonly unknown[] = [];
  #last: readonly unknown[] = [];
  /** What a wall was made on, and what that filled. */
  #beneath: { readonly value: Solid | null; readonly bounds: Bounds | null; readonly all: Bounds | null } = {
    value: null,
    bounds: null,
    all: null,
  };

  /** The handle of the water is put into the shadow of `host`. */
  constructor(designer: Designer, stage: Stage, host: HTMLElement) {
    this.#designer = designer;
    this.#host = host;
    this.#drawing = stage.invite((place) => new Drawing(place));
    this.#handle = document.createElement("pasu-water-handle");
    this.#handle.designer = designer;
    (host.shadowRoot ?? host).append(this.#handle);
    this.#drawing.onHold = (hold: Hold | null) => this.#handle.hold(hold);
  }

  /** Takes the handle away; the rest goes with the stage. */
  dispose(): void {
    this.#handle.remove();
    delete this.#host.dataset.wall;
  }

  /** Brings the stage up to date with the designer; cheap when nothing changed. */
  update(): void {
    const { made, store, surface } = this.#designer;
    const { shown } = surface;
    if (!made || !shown) return;
    const { map, overlays, fill, hidden, inside } = store.session;
    const { solid, changed, water, painted, lining, measures } = made;
    const now = [shown, solid, changed, water, painted, lining, measures, map, overlays, fill, hidden, inside];
    if (now.every((each, i) => each === this.#last[i])) return;
    this.#last = now;
    const fits = ({ of }: Piece<unknown>) => of !== null && sameSurface(of.parts, shown.design.parts);
    this.#show(made, shown);
    this.#drawing.cut(overlays.cut);
    this.#drawing.pour(fits(water) ? water.value : null, fill === null ? null : made.level);
    this.#paint(made, shown, map);
    this.#drawing.say(measures.of === shown.design ? wordsOf(made, shown) : []);
  }

  /** What was shown before is written over by what is made under the hand. Walls go along with parts that are only moved; those of others stand in their place where they are made. */
  #show({ inStep, solid, changed }: Made, { design, solved }: Shown): void {
    const { value, of } = solid;
    const goingAlong = value && of ? motionsBetween(of.parts, design.parts) : [];
    // What was taken back stands there as it was.
    const needed = value && of && changed.of ? changedBetween(of.parts, design.parts) : [];
    const after = needed.length > 0 && changed.of ? motionsBetween(changed.of.parts, design.parts) : [];
    const own = after.map((motion, part) => (changed.parts.includes(part) && needed.includes(part) ? motion : null));
    const motions = goingAlong.map((motion, part) => (own[part] ? null : motion));
    const wall = motions.some((motion) => motion !== null) ? solid : null;
    const along = changed.value && own.some((motion) => motion !== null) ? { made: changed.value, motions: own } : null;
    const extent = this.#extent(solid, design, solved);
    const before = this.#drawing.show(
      wall?.value ?? null,
      looksOf(design),
      motions,
      along?.made.bounds && extent ? around(extent, along.made.bounds) : extent,
      along,
    );
    if (before.walls && before.walls !== solid.value) inStep.recycle(before.walls);
    if (before.changed && before.changed !== changed.value) inStep.recycle(before.changed, true);
    // For whoever watches from outside.
    if (wall?.value) this.#host.dataset.wall = wall.key;
    else delete this.#host.dataset.wall;
  }

  /** What the pot fills with its wall: of one that was moved what its surface fills, and beyond that what it filled before. */
  #extent({ value, of }: Piece<Solid>, design: Design, { bounds, parts }: Solved): Bounds | null {
    if (!value) return null;
    if (of === design) this.#beneath = { value, bounds, all: boundsWith(value.bounds, design, parts) };
    const { value: known, bounds: then, all } = this.#beneath;
    return known === value ? grownAlike(bounds, then, all) : around(value.bounds, bounds);
  }

  #paint({ painted, lining, solid }: Made, shown: Shown, map: MapName | null): void {
    const { parts } = shown.solved;
    const meshes = parts.map(({ mesh }) => mesh);
    const another = meshes.length !== this.#meshes.length || meshes.some((mesh, i) => mesh !== this.#meshes[i]);
    this.#meshes = meshes;
    if (map === null) this.#drawing.paint(null);
    else if (painted.value && painted.of === shown.design && shown.settled && painted.key.startsWith(`${map} `)) {
      const { ramp, low, high } = scaleOf(mapOf(map), painted.value.low, painted.value.high);
      const fits = painted.value.values.length === verticesOf(parts);
      // Of the faces that are on the stage, or of none.
      const lined = lining.of === solid.of && lining.key.startsWith(`${solid.key} ${map} `) ? lining.value : null;
      const next: StageMap = {
        values: painted.value.values,
        lining: lined?.values ?? null,
        low,
        high,
        ramp,
        lean: map === "overhang",
      };
      this.#drawing.paint(fits ? next : undefined);
    } else if (another || painted.of !== shown.design) this.#drawing.paint(undefined);
  }
}

/** What goes beyond `now` as `all` did beyond `then`, on each side by itself. */
function grownAlike(now: Bounds | null, then: Bounds | null, all: Bounds | null): Bounds | null {
  if (!now || !then || !all) return all ?? now;
  const each = (of: (axis: 0 | 1 | 2) => number): Triple => [of(0), of(1), of(2)];
  const min = each((axis) => now.min[axis] + (all.min[axis] - then.min[axis]));
  const max = each((axis) => now.max[axis] + (all.max[axis] - then.max[axis]));
  return {
    min,
    max,
    centre: each((axis) => (min[axis] + max[axis]) / 2),
    radius: now.radius + (all.radius - then.radius),
  };
}

/** The thickness at the rim and how much the pot holds, where each can be seen. */
function wordsOf({ measures, solid }: Made, { design }: Shown): readonly Word[] {
  const unit = unitOf(design);
  const words: Word[] = [];
  const { value } = measures;
  const wall = design.parts[0]?.wall;
  if (value?.capacity && measures.of === design) {
    const { brim, spill } = value.capacity;
    words.push({ text: localVolumeWords(brim.value, unit, 3), at: middleOf(solid.value?.bounds, spill.level.value) });
    if (wall) words.push({ text: page.wallOnStage(lengthWords(wall.thickness, unit, 3)), at: spill.at });
  }
  return words;
}

function middleOf(
  bounds: { readonly centre: readonly [number, number, number] } | null | undefined,
  z: number,
): readonly [number, number, number] {
  return [bounds?.centre[0] ?? 0, bounds?.centre[1] ?? 0, z];
}
