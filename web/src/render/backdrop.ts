import { BufferAttribute, BufferGeometry, GLSL3, Mesh, RawShaderMaterial } from "three";
import { GRAIN_GLSL, type Studio } from "./studio";

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
out vec2 vScreen;
uniform vec4 window;
void main() {
  vScreen = window.xy + (position.xy * 0.5 + 0.5) * window.zw;
  gl_Position = vec4(position.xy, 1.0, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
in vec2 vScreen;
uniform vec3 top;
uniform vec3 bottom;
uniform vec3 glow;
uniform float aspect;
out vec4 colour;
${GRAIN_GLSL}
void main() {
  vec2 p = (vScreen - vec2(0.5, 0.47)) * vec2(min(aspect, 1.6), 1.0);
  float near = 1.0 / (1.0 + 2.1 * dot(p, p));
  near *= near;
  colour = vec4(mix(mix(bottom, top, vScreen.y), glow, near) + grain(), 1.0);
}
`;

/** The paper behind the pot: one large triangle at the far end of the depth range, with a glow behind the middle. */
export class Backdrop {
  readonly object: Mesh;
  /** The part of the whole picture that is being drawn (a tile): x, y, width, height from the lower left, 0 to 1. */
  readonly window = { value: [0, 0, 1, 1] };
  readonly aspect = { value: 1 };

  constructor(studio: Studio) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: {
        top: studio.top,
        bottom: studio.bottom,
        glow: studio.glow,
        window: this.window,
        aspect: this.aspect,
      },
      depthWrite: false,
    });
    this.object = new Mesh(geometry, material);
    this.object.frustumCulled = false;
    // Drawn last of the opaque things: pixels that the pot covers are then not computed twice.
    this.object.renderOrder = 1;
  }

  /** Gives up everything on the GPU. */
  release(): void {
    this.object.geometry.dispose();
    (this.object.material as RawShaderMaterial).dispose();
  }
}
