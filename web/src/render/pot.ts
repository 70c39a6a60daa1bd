import { ceramic } from "./ceramic";
import type { Tenant } from "./gl/device";
import type { Drawable } from "./gl/drawable";
import type { Material, Uniform } from "./gl/material";
import { isDark, lookKey, type StageLook } from "./glaze";
import { Lattices } from "./lattice";
import type { Bounds, PartId, StageModel, StagePart } from "./mesh";
import { PotPart } from "./pot-part";
import type { Studio } from "./studio";
import type { Triple } from "./triple";

/** The material of a part, by its place in the document, where it is not its glaze. */
export type Coat = (look: StageLook, part: number) => Material;

/** One design on the GPU: an object for every part, kept by identity, and a material per look. */
export class Pot implements Tenant {
  /** How far it stands from where its model is, in scene space. */
  readonly shift: Uniform<Triple> = { value: [0, 0, 0] };
  /** Whether its first part is dark. */
  dark = false;
  /** What everything fills that belongs to the pot, while that is more than its mesh. */
  extent: Bounds | null = null;
  /** Its parts in the order of the document. */
  parts: readonly PotPart[] = [];
  drawables: readonly Drawable[] = [];
  private shown: StageModel = { parts: [], bounds: null };
  private dressed: Coat | null = null;
  private readonly byId = new Map<PartId, PotPart>();
  private readonly lattices = new Lattices();
  private readonly materials = new Map<string, Material>();

  constructor(private readonly studio: Studio) {}

  get bounds(): Bounds | null {
    return this.extent ?? this.shown.bounds;
  }

  /** Other materials than the glazes of the parts; null for those. */
  set coat(coat: Coat | null) {
    if (coat === this.dressed) return;
    this.dressed = coat;
    this.dress();
  }

  /** Values of the vertices, those of a part after those of the one before it; they hold until a part is another one. */
  set values(values: Float32Array) {
    let first = 0;
    for (const part of this.parts) {
      part.values = values.subarray(first, first + part.vertices);
      first += part.vertices;
    }
  }

  /** The parts that are seen, or whose inside is. */
  get seen(): readonly PotPart[] {
    return this.parts.filter(({ drawable }, place) => drawable.visible || this.shown.parts[place]?.inside);
  }

  /** Whether a part is hidden, by its place in the document. */
  hides(part: number): boolean {
    return this.shown.parts[part]?.hidden ?? false;
  }

  /** Shows other parts, or the same ones elsewhere. Of parts that are there already nothing is touched but what is different. */
  update(model: StageModel): void {
    this.shown = model;
    this.parts = model.parts.map((part) => this.updated(part));
    this.drawables = this.parts.map(({ drawable }) => drawable);
    const here = new Set(model.parts.map(({ id }) => id));
    for (const [id, part] of this.byId) {
      if (here.has(id)) continue;
      part.release();
      this.byId.delete(id);
    }
    this.lattices.keep(this.parts.map(({ lattice }) => lattice));
    const [first] = model.parts;
    this.dark = first !== undefined && isDark(first.look);
    this.dress();
    for (const [index, { drawable }] of this.parts.entries()) {
      drawable.visible = model.bounds !== null && !model.parts[index]?.hidden;
    }
  }

  /** Gives up everything on the GPU; the arrays stay in memory. */
  release(): void {
    for (const part of this.parts) part.release();
    this.lattices.release();
  }

  private updated(next: StagePart): PotPart {
    const found = this.byId.get(next.id);
    const lattice = this.lattices.of(next.mesh);
    if (found) {
      found.update(next, lattice);
      return found;
    }
    const made = new PotPart(next, lattice, this.shift, this.material(next.look));
    this.byId.set(next.id, made);
    return made;
  }

  private dress(): void {
    for (const [index, { look }] of this.shown.parts.entries()) {
      const part = this.parts[index];
      if (part) part.drawable.material = this.dressed?.(look, index) ?? this.material(look);
    }
  }

  private material(look: StageLook): Material {
    const key = lookKey(look);
    let material = this.materials.get(key);
    if (!material) {
      material = ceramic(look, this.studio);
      this.materials.set(key, material);
    }
    return material;
  }
}
