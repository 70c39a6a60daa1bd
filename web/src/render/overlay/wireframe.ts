import { Buffer } from "../gl/buffer";
import type { Tenant } from "../gl/device";
import type { Drawable } from "../gl/drawable";
import { Geometry } from "../gl/geometry";
import { Material, type Uniform } from "../gl/material";
import { PLACING_GLSL } from "../placing";
import type { Pot } from "../pot";
import type { Studio } from "../studio";
import type { Triple } from "../triple";
import { edgesOf } from "./segments";
import { NEARER } from "./stroke";

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
${PLACING_GLSL}
uniform float nearer;
void main() {
  vec4 p = viewMatrix * vec4(inFrame(position), 1.0);
  p.xyz *= nearer;
  gl_Position = projectionMatrix * p;
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
uniform vec3 ink;
out vec4 colour;
void main() { colour = vec4(ink, 0.45); }
`;

const DARK_INK: Triple = [0.05, 0.06, 0.09];
const LIGHT_INK: Triple = [0.86, 0.9, 0.94];

/**
 * The triangles of the pot as lines one device pixel wide, which is what a mesh of a hundred thousand edges can bear, read from the parts' own
 * vertices: only the pairs of vertices are added, and those change with the grid alone.
 */
export class Wireframe implements Tenant {
  visible = false;
  private lines: Drawable[] = [];
  /** The edges of triangles, by their indices. */
  private readonly edges = new Map<Uint32Array, Buffer>();
  private readonly ink: Uniform<Triple> = { value: DARK_INK };
  private readonly material: Material;

  constructor(
    studio: Studio,
    private readonly order: number,
  ) {
    this.material = new Material({
      vertex: VERTEX,
      fragment: FRAGMENT,
      uniforms: { frame: studio.frame, nearer: { value: NEARER }, ink: this.ink },
      depthWrite: false,
      blending: "alpha",
    });
  }

  get drawables(): readonly Drawable[] {
    return this.visible ? this.lines : [];
  }

  /** Follows the pot; light lines on a dark glaze. */
  update(pot: Pot): void {
    this.ink.value = pot.dark ? LIGHT_INK : DARK_INK;
    const used = new Set(pot.parts.map(({ lattice }) => lattice.indices));
    for (const [indices, buffer] of this.edges) {
      if (used.has(indices)) continue;
      buffer.release();
      this.edges.delete(indices);
    }
    for (const { geometry } of this.lines) geometry.release();
    const seen = pot.parts.filter(({ drawable }) => drawable.visible);
    this.lines = seen.map(({ positions, lattice, drawable }) => ({
      geometry: new Geometry({ position: positions }, this.edgesOf(lattice.indices)),
      material: this.material,
      uniforms: drawable.uniforms ?? {},
      order: this.order,
      visible: true,
      lines: true,
    }));
  }

  /** Gives up everything on the GPU. */
  release(): void {
    for (const { geometry } of this.lines) geometry.release();
    for (const buffer of this.edges.values()) buffer.release();
  }

  private edgesOf(indices: Uint32Array): Buffer {
    const buffer = this.edges.get(indices) ?? new Buffer(edgesOf(indices), { size: 1 });
    this.edges.set(indices, buffer);
    return buffer;
  }
}
