import { Buffer } from "../gl/buffer";
import type { Drawable } from "../gl/drawable";
import { Geometry } from "../gl/geometry";
import type { Material, Uniform, Uniforms } from "../gl/material";
import { IDENTITY, type Matrix } from "../gl/view";
import type { StageLook } from "../glaze";
import type { Bounds, Span } from "../mesh";
import type { Face } from "../picker";
import { newPlacing, type Placing, place } from "../placing";
import type { Pot } from "../pot";
import { at } from "../triple";

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

/** By which each part was moved since its faces were made; null where they are none of it any more. */
export type Motions = readonly (Matrix | null)[];

/** What is made comes placed. */
const SOLID_PLACING = { ...newPlacing() };
const SOLID = { ...SOLID_PLACING, span: { value: [0, 1] } };

/** Where the faces of a part are that was moved since they were made. */
type Moved = { readonly [name in keyof Placing]: Placing[name] } & { readonly span: Uniform<Span> };

/** Faces of walls on the graphics card, which go along with the parts that they are of. */
export class Faces {
  made: StageSolid | null = null;
  private readonly positions = newBuffer(3);
  private readonly normals = newBuffer(3);
  private readonly wares = newBuffer(4);
  private readonly indices = new Buffer(new Uint32Array(), { size: 1, dynamic: true });
  private values: Buffer | null = null;
  private geometry = this.newGeometry();
  private motions: Motions = [];
  private readonly moved = new Map<number, Moved>();
  /** What was moved. */
  private went = "";

  constructor(private readonly pot: Pot) {}

  get count(): number {
    return this.positions.count;
  }

  /** Whether a map says what is seen of these. */
  get isLined(): boolean {
    return this.values !== null;
  }

  /** The faces by their parts, for whoever asks what is seen at a point. */
  get seen(): readonly Face[] {
    const { geometry } = this;
    return this.shown.map(({ part, range }) => ({
      geometry,
      uniforms: { ...(this.moved.get(part) ?? SOLID_PLACING), ...this.cutOf(part) },
      range,
      part,
    }));
  }

  /** Takes faces, whose arrays are these from now on, or none; says whether other draw calls are needed for them. */
  take(made: StageSolid | null, motions: Motions): boolean {
    const went = motions.map(kindOf).join();
    const another = made !== this.made || went !== this.went;
    this.went = went;
    this.motions = motions;
    if (made !== this.made) {
      this.made = made;
      this.line(null);
      if (made) {
        this.positions.array = made.positions;
        this.normals.array = made.normals;
        this.wares.array = made.wares;
        this.indices.array = made.indices;
      } else this.drop();
    }
    this.move();
    return another;
  }

  /** What a map shows inside. */
  line(values: Float32Array | null): void {
    if ((this.values?.array ?? null) === values) return;
    this.geometry.release();
    this.values?.release();
    this.values = values && new Buffer(values, { size: 1 });
    this.geometry = this.newGeometry();
  }

  /** One draw call for each run of faces that look the same, and are cut before one plane where the pot is open. */
  clothed(
    looks: readonly StageLook[],
    mapped: boolean,
    open: boolean,
    materialOf: (look: StageLook) => Material,
  ): Drawable[] {
    const { geometry } = this;
    const drawn: Drawable[] = [];
    const cut = new Map<number, Uniforms>();
    const cutOpen = (part: number, uniforms: Uniforms): Uniforms => {
      const known = cut.get(part) ?? { ...uniforms, ...this.cutOf(part) };
      cut.set(part, known);
      return known;
    };
    for (const { part, range } of this.shown) {
      const look = looks[part] ?? DEFAULT_LOOK;
      const material = materialOf(look);
      const [start, count] = range;
      const last = drawn.at(-1);
      // Parts that are glazed to the foot need not be told apart.
      const moved = this.moved.get(part);
      const own = moved !== undefined || (look.line > 0 && !mapped);
      const whole = moved ?? (own ? { ...SOLID_PLACING, span: { value: this.spanOf(part) } } : SOLID);
      const uniforms = open && this.pot.parts[part] ? cutOpen(part, whole) : whole;
      const on = last?.material === material && last.uniforms === uniforms;
      if (on && last.range && last.range[0] + last.range[1] === start) {
        last.range = [last.range[0], last.range[1] + count];
      } else drawn.push({ geometry, material, uniforms, order: 0, visible: true, range: [start, count] });
    }
    return drawn;
  }

  sideOf(part: number): "inside" | "outside" | null {
    return this.motions[part] === null ? null : (this.made?.sides[part] ?? null);
  }

  drop(): void {
    this.geometry.release();
    for (const buffer of [this.positions, this.normals, this.wares, this.indices, this.values]) buffer?.release();
  }

  /** The ranges of indices that are seen, by their parts' places in the document. */
  private get shown(): readonly { readonly part: number; readonly range: readonly [number, number] }[] {
    const groups = this.made?.groups ?? new Uint32Array();
    const ranges = Array.from({ length: groups.length / 3 }, (_, g) => ({
      part: at(groups, 3 * g + 2),
      range: [at(groups, 3 * g), at(groups, 3 * g + 1)] as const,
    }));
    return ranges.filter(({ part }) => this.motions[part] !== null && !this.pot.hides(part));
  }

  private newGeometry(): Geometry {
    const { positions, normals, wares, indices, values } = this;
    return new Geometry({ position: positions, normal: normals, wares, ...(values && { value: values }) }, indices);
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

  private cutOf(part: number): Uniforms {
    const cut = this.pot.parts[part]?.cut;
    return cut ? { cut } : {};
  }

  private spanOf(part: number): Span {
    const outside = this.made?.outsides[part];
    const lifted = this.motions[part]?.[14] ?? 0;
    if (outside) return [outside[0] + lifted, outside[1] + lifted];
    return this.pot.parts[part]?.span.value ?? [0, 1];
  }
}

const DEFAULT_LOOK: StageLook = { glaze: "celadon", inside: "celadon", line: 0, clay: "stoneware" };

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
