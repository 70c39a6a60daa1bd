import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh, type RawShaderMaterial, Vector3 } from "three";
import { ceramic } from "./ceramic";
import { isDark, type StageLook } from "./glaze";
import { type Bounds, boundsOf, checkMesh, type StageMesh } from "./mesh";
import type { Studio } from "./studio";
import { at } from "./triple";
import { WARE_SIZE, ware } from "./ware";

const DEFAULT_LOOK: StageLook = { glaze: "celadon", clay: "stoneware" };

/** One design on the GPU: its buffers, kept and overwritten while sizes stay the same, and a material per look. */
export class Pot {
  readonly object: Mesh<BufferGeometry, RawShaderMaterial[]>;
  /** Where it stands in scene space. */
  readonly shift = { value: new Vector3() };
  bounds: Bounds | null = null;
  /** Whether its first part is dark. */
  dark = false;
  private readonly materials = new Map<string, RawShaderMaterial>();
  private used: RawShaderMaterial[] = [];

  constructor(private readonly studio: Studio) {
    this.object = new Mesh(new BufferGeometry(), []);
    this.object.frustumCulled = false;
    this.object.visible = false;
  }

  /** The corners that the mesh is made of, in model units. */
  get positions(): Float32Array {
    return (this.object.geometry.getAttribute("position")?.array as Float32Array | undefined) ?? new Float32Array(0);
  }

  get indices(): Uint32Array {
    return (this.object.geometry.getIndex()?.array as Uint32Array | undefined) ?? new Uint32Array(0);
  }

  /**
   * Shows another mesh. Its arrays are copied.
   *
   * @throws {MeshError} when it cannot be drawn; what was shown stays
   */
  update(mesh: StageMesh, looks: readonly StageLook[]): void {
    checkMesh(mesh);
    let geometry = this.object.geometry;
    // Indices depend on the grid alone, so equal sizes nearly always mean equal indices; the arrays are only ever replaced as a whole.
    const fits =
      geometry.getAttribute("position")?.array.length === mesh.positions.length && equal(this.indices, mesh.indices);
    if (!fits) {
      geometry.dispose();
      geometry = new BufferGeometry();
      const attribute = (size: number, length: number) =>
        new BufferAttribute(new Float32Array(length), size).setUsage(DynamicDrawUsage);
      geometry.setAttribute("position", attribute(3, mesh.positions.length));
      geometry.setAttribute("normal", attribute(3, mesh.normals.length));
      geometry.setAttribute("ware", attribute(WARE_SIZE, (mesh.positions.length / 3) * WARE_SIZE));
      geometry.setIndex(new BufferAttribute(mesh.indices.slice(), 1));
      this.object.geometry = geometry;
    }
    write(geometry.getAttribute("position") as BufferAttribute, mesh.positions);
    write(geometry.getAttribute("normal") as BufferAttribute, mesh.normals);
    const wares = geometry.getAttribute("ware") as BufferAttribute;
    ware(mesh, wares.array as Float32Array);
    wares.needsUpdate = true;
    this.dark = isDark(looks[0] ?? DEFAULT_LOOK);
    this.dress(mesh.groups, looks);
    this.bounds = mesh.indices.length > 0 ? boundsOf(mesh.positions) : null;
    this.object.visible = this.bounds !== null;
  }

  /** Gives up everything on the GPU; the arrays stay in memory. */
  release(): void {
    this.object.geometry.dispose();
    for (const material of this.materials.values()) material.dispose();
  }

  /** One draw call per run of parts that look the same. */
  private dress(groups: Uint32Array, looks: readonly StageLook[]): void {
    const geometry = this.object.geometry;
    geometry.clearGroups();
    this.used = [];
    let previous = { key: "", end: -1 };
    for (let g = 0; g < groups.length; g += 3) {
      const look = looks[at(groups, g + 2)] ?? DEFAULT_LOOK;
      const key = `${look.glaze}/${look.clay}`;
      const start = at(groups, g);
      const count = at(groups, g + 1);
      const last = geometry.groups.at(-1);
      if (last && previous.key === key && previous.end === start) {
        last.count += count;
      } else {
        geometry.addGroup(start, count, this.used.push(this.material(key, look)) - 1);
      }
      previous = { key, end: start + count };
    }
    this.object.material = this.used;
  }

  /** Kept for good once made: there are 32 at most, and a program without a material would be compiled again. */
  private material(key: string, look: StageLook): RawShaderMaterial {
    let material = this.materials.get(key);
    if (!material) {
      material = ceramic(look, this.studio, this.shift);
      this.materials.set(key, material);
    }
    return material;
  }
}

function write(attribute: BufferAttribute, values: Float32Array): void {
  attribute.array.set(values);
  attribute.needsUpdate = true;
}

function equal(a: Uint32Array, b: Uint32Array): boolean {
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; i++) if (a[i] !== b[i]) return false;
  return true;
}
