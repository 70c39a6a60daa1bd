import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  DynamicDrawUsage,
  FloatType,
  type IUniform,
  Mesh,
  type RawShaderMaterial,
  RGBAFormat,
  Vector3,
} from "three";
import { ceramic } from "./ceramic";
import { isDark, type StageLook } from "./glaze";
import type { Bounds, StageMesh, StageWare } from "./mesh";
import type { Studio } from "./studio";
import { at } from "./triple";

const DEFAULT_LOOK: StageLook = { glaze: "celadon", clay: "stoneware" };
const EMPTY = new Uint32Array();
const NOWHERE = new Float32Array();

/** What the shader of a pot needs to know of it. */
export interface PotUniforms {
  /** Where it stands in scene space. */
  readonly shift: IUniform<Vector3>;
  /** See {@link StageWare}. */
  readonly ware: IUniform<DataTexture>;
  readonly wareRows: IUniform<number>;
}

/** The material of a part in the place of its glaze. */
export type Coat = (look: StageLook, part: number) => RawShaderMaterial;

/** One design on the GPU: its buffers, kept and overwritten while the grid stays the same, and a material per look. */
export class Pot {
  readonly object: Mesh<BufferGeometry, RawShaderMaterial[]>;
  readonly uniforms: PotUniforms = {
    shift: { value: new Vector3() },
    ware: { value: table({ texels: new Float32Array(4), rows: 1, columns: 1 }) },
    wareRows: { value: 1 },
  };
  /** Whether its first part is dark. */
  dark = false;
  /** What everything fills that belongs to the pot, while that is more than its mesh. */
  extent: Bounds | null = null;
  private mesh: StageMesh | null = null;
  private looks: readonly StageLook[] = [];
  private dressed: Coat | null = null;
  private readonly materials = new Map<string, RawShaderMaterial>();
  private used: RawShaderMaterial[] = [];

  constructor(private readonly studio: Studio) {
    this.object = new Mesh(new BufferGeometry(), []);
    this.object.frustumCulled = false;
    this.object.visible = false;
  }

  get bounds(): Bounds | null {
    return this.extent ?? this.mesh?.bounds ?? null;
  }

  /** Other materials than the glazes of the parts; null for those. */
  set coat(coat: Coat | null) {
    if (coat === this.dressed) return;
    this.dressed = coat;
    if (this.mesh) this.dress(this.mesh.groups);
  }

  /** The corners that the mesh is made of, in model units. */
  get positions(): Float32Array {
    return this.mesh?.positions ?? NOWHERE;
  }

  get indices(): Uint32Array {
    return this.mesh?.indices ?? EMPTY;
  }

  /** Shows another mesh, whose arrays are its own from now on. Gives back the one before. */
  update(mesh: StageMesh, looks: readonly StageLook[]): StageMesh | null {
    const before = this.mesh;
    this.mesh = mesh;
    if (before?.indices === mesh.indices) {
      const { geometry } = this.object;
      refill(geometry.getAttribute("position") as BufferAttribute, mesh.positions);
      refill(geometry.getAttribute("normal") as BufferAttribute, mesh.normals);
    } else {
      this.object.geometry.dispose();
      this.object.geometry = geometryOf(mesh);
    }
    this.glaze(mesh.ware);
    this.dark = isDark(looks[0] ?? DEFAULT_LOOK);
    this.looks = looks;
    this.dress(mesh.groups);
    this.object.visible = mesh.bounds !== null;
    return before;
  }

  /** Gives up everything on the GPU; the arrays stay in memory. */
  release(): void {
    this.object.geometry.dispose();
    this.uniforms.ware.value.dispose();
    for (const material of this.materials.values()) material.dispose();
  }

  private glaze(ware: StageWare): void {
    const { uniforms } = this;
    const before = uniforms.ware.value;
    const { width, height } = before.image;
    const lines = ware.texels.length / (4 * ware.columns);
    if (width === ware.columns && height === lines) {
      before.image.data = ware.texels;
      before.needsUpdate = true;
    } else {
      before.dispose();
      uniforms.ware.value = table(ware);
    }
    uniforms.wareRows.value = ware.rows;
  }

  /** One draw call per run of parts that look the same. */
  private dress(groups: Uint32Array): void {
    const geometry = this.object.geometry;
    geometry.clearGroups();
    this.used = [];
    for (let g = 0; g < groups.length; g += 3) {
      const part = at(groups, g + 2);
      const look = this.looks[part] ?? DEFAULT_LOOK;
      const material = this.dressed?.(look, part) ?? this.material(look);
      const [start, count] = [at(groups, g), at(groups, g + 1)];
      const last = geometry.groups.at(-1);
      if (last && this.used.at(-1) === material && last.start + last.count === start) last.count += count;
      else geometry.addGroup(start, count, this.used.push(material) - 1);
    }
    this.object.material = this.used;
  }

  /** Kept for good once made: there are 32 at most, and a program without a material would be compiled again. */
  private material(look: StageLook): RawShaderMaterial {
    const key = `${look.glaze}/${look.clay}`;
    let material = this.materials.get(key);
    if (!material) {
      material = ceramic(look, this.studio, this.uniforms);
      this.materials.set(key, material);
    }
    return material;
  }
}

function geometryOf(mesh: StageMesh): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(mesh.positions, 3).setUsage(DynamicDrawUsage));
  geometry.setAttribute("normal", new BufferAttribute(mesh.normals, 3).setUsage(DynamicDrawUsage));
  geometry.setAttribute("place", new BufferAttribute(placesOf(mesh), 3));
  geometry.setIndex(new BufferAttribute(mesh.indices, 1));
  return geometry;
}

/** The received array is the attribute's own from now on; it goes into the buffer that is there. */
function refill(attribute: BufferAttribute, values: Float32Array): void {
  attribute.array = values;
  attribute.needsUpdate = true;
}

/** Where each vertex is in the tables of the glaze: u, v / span, part. */
function placesOf({ uvs, indices, groups }: StageMesh): Float32Array {
  const vertices = uvs.length / 2;
  const places = new Float32Array(3 * vertices);
  for (let v = 0; v < vertices; v++) {
    places[3 * v] = at(uvs, 2 * v);
    places[3 * v + 1] = at(uvs, 2 * v + 1);
  }
  for (let g = 0; g < groups.length; g += 3) {
    const end = at(groups, g) + at(groups, g + 1);
    for (let i = at(groups, g); i < end; i++) places[3 * at(indices, i) + 2] = at(groups, g + 2);
  }
  return places;
}

function table({ texels, columns }: StageWare): DataTexture {
  const texture = new DataTexture(texels, columns, texels.length / (4 * columns), RGBAFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
}
