import { BufferAttribute, BufferGeometry, GLSL3, LineSegments, RawShaderMaterial } from "three";
import type { Pot } from "../pot";
import type { Studio } from "../studio";
import { edgesOf } from "./segments";
import { NEARER } from "./stroke";

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform vec4 frame;
uniform float nearer;
void main() {
  vec4 p = viewMatrix * vec4((position - frame.xyz) * frame.w, 1.0);
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

const DARK_INK = [0.05, 0.06, 0.09];
const LIGHT_INK = [0.86, 0.9, 0.94];

/**
 * The triangles of the pot as lines one device pixel wide, which is what a mesh of a hundred thousand edges can bear, read from the pot's own
 * vertices: only the pairs of vertices are added, and those change with the grid alone.
 */
export class Wireframe {
  readonly object: LineSegments<BufferGeometry, RawShaderMaterial>;
  private of: Uint32Array | null = null;
  private readonly ink = { value: DARK_INK };

  constructor(studio: Studio, order: number) {
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { frame: studio.frame, nearer: { value: NEARER }, ink: this.ink },
      depthWrite: false,
      transparent: true,
    });
    this.object = new LineSegments(new BufferGeometry(), material);
    this.object.frustumCulled = false;
    this.object.renderOrder = order;
    this.object.visible = false;
  }

  /** Follows the pot; light lines on a dark glaze. */
  update(pot: Pot): void {
    const { geometry } = this.object;
    const { indices } = pot;
    if (this.of !== indices) {
      this.of = indices;
      this.drop(geometry);
      this.object.geometry = new BufferGeometry();
      this.object.geometry.setIndex(new BufferAttribute(edgesOf(indices), 1));
    }
    const position = pot.object.geometry.getAttribute("position");
    if (position) this.object.geometry.setAttribute("position", position);
    this.ink.value = pot.dark ? LIGHT_INK : DARK_INK;
  }

  /** Gives up everything on the GPU. */
  release(): void {
    this.drop(this.object.geometry);
    this.object.material.dispose();
    this.of = null;
  }

  /** The positions belong to the pot: disposing of a geometry that still has them would delete its buffer. */
  private drop(geometry: BufferGeometry): void {
    geometry.deleteAttribute("position");
    geometry.dispose();
  }
}
