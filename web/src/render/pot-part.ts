import { Buffer } from "./gl/buffer";
import type { Drawable } from "./gl/drawable";
import { Geometry } from "./gl/geometry";
import type { Material, Uniform } from "./gl/material";
import { Texture } from "./gl/texture";
import type { Lattice } from "./lattice";
import type { PartId, Span, StagePart, StageWare } from "./mesh";
import { newPlacing, type Placing, place, placed } from "./placing";
import { at, type Triple } from "./triple";

/** One part on the GPU: its buffers, which are written over while its grid stays the same, and where it stands. */
export class PotPart {
  readonly id: PartId;
  readonly drawable: Drawable;
  readonly placing: Placing;
  readonly positions: Buffer;
  readonly span: Uniform<Span>;
  /** The plane before which it is cut away, in scene space. */
  readonly cut: Uniform<readonly number[]> = { value: [0, 0, 0, 1] };
  /** The middle of the object that it belongs to, where there are several. */
  middle: Triple | null;
  lattice: Lattice;
  private readonly normals: Buffer;
  private readonly table: Uniform<Texture>;
  private painted: Buffer | null = null;
  private ware: StageWare;
  private revision: number;

  constructor(
    { id, revision, mesh, matrix, span, middle }: StagePart,
    lattice: Lattice,
    shift: Uniform<Triple>,
    material: Material,
  ) {
    this.id = id;
    this.revision = revision;
    this.lattice = lattice;
    this.ware = mesh.ware;
    this.positions = new Buffer(mesh.positions, { size: 3, dynamic: true });
    this.normals = new Buffer(mesh.normals, { size: 3, dynamic: true });
    this.table = { value: this.newTable() };
    this.placing = newPlacing(shift);
    this.span = { value: span };
    this.middle = middle ?? null;
    this.drawable = {
      geometry: this.newGeometry(),
      material,
      uniforms: { ...this.placing, ware: this.table, span: this.span, cut: this.cut },
      order: 0,
      visible: true,
      mirrored: place(this.placing, matrix),
    };
  }

  get vertices(): number {
    return this.positions.count;
  }

  /** Where a vertex stands, in model units. */
  at(vertex: number): Triple {
    const p = this.positions.array;
    const k = 3 * vertex;
    return placed(this.placing.model.value, [at(p, k), at(p, k + 1), at(p, k + 2)]);
  }

  /** A value for every vertex, for materials that colour by them. */
  set values(values: Float32Array) {
    this.painted?.release();
    this.painted = new Buffer(values, { size: 1 });
    this.reassemble();
  }

  /** The same part at another time. */
  update({ revision, mesh, matrix, span, middle }: StagePart, lattice: Lattice): void {
    this.span.value = span;
    this.middle = middle ?? null;
    // Of hundreds of parts that stand where they stood nothing is worked out again.
    if (matrix !== this.placing.model.value) this.drawable.mirrored = place(this.placing, matrix);
    if (revision === this.revision) return;
    const writes = mesh.positions === this.positions.array ? (mesh.writes?.since(this.revision) ?? null) : null;
    this.revision = revision;
    if (writes) {
      for (const ranges of writes) for (const buffer of [this.positions, this.normals]) buffer.wrote(ranges);
      return;
    }
    this.positions.array = mesh.positions;
    this.normals.array = mesh.normals;
    if (lattice !== this.lattice) {
      this.lattice = lattice;
      this.painted?.release();
      this.painted = null;
      this.reassemble();
    }
    const { rows, columns } = this.ware;
    this.ware = mesh.ware;
    if (mesh.ware.rows === rows && mesh.ware.columns === columns) this.table.value.changed();
    else {
      this.table.value.release();
      this.table.value = this.newTable();
    }
  }

  /** Gives up everything on the GPU but the lattice, which may be others' too. */
  release(): void {
    this.drawable.geometry.release();
    for (const buffer of [this.positions, this.normals, this.painted]) buffer?.release();
    this.table.value.release();
  }

  private reassemble(): void {
    this.drawable.geometry.release();
    this.drawable.geometry = this.newGeometry();
  }

  private newGeometry(): Geometry {
    const { positions, normals, lattice, painted } = this;
    const attributes = { position: positions, normal: normals, uv: lattice.uv, ...(painted && { value: painted }) };
    return new Geometry(attributes, lattice.index);
  }

  private newTable(): Texture {
    const { rows, columns } = this.ware;
    return new Texture({
      target: "TEXTURE_2D",
      allocate(gl) {
        gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, columns, rows);
        // Not every GPU filters textures of floats: the shader does.
        for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
          gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
        for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T])
          gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
      },
      fill: (gl) => gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, columns, rows, gl.RGBA, gl.FLOAT, this.ware.texels),
    });
  }
}
