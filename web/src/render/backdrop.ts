import type { Tenant } from "./gl/device";
import type { Drawable } from "./gl/drawable";
import { Material } from "./gl/material";
import { Sheet } from "./gl/sheet";
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
export class Backdrop implements Tenant {
  readonly drawable: Drawable;
  /** The part of the whole picture that is being drawn (a tile): x, y, width, height from the lower left, 0 to 1. */
  readonly window = { value: [0, 0, 1, 1] };
  readonly aspect = { value: 1 };
  private readonly sheet = new Sheet();

  constructor(studio: Studio) {
    const material = new Material({
      vertex: VERTEX,
      fragment: FRAGMENT,
      uniforms: {
        top: studio.top,
        bottom: studio.bottom,
        glow: studio.glow,
        window: this.window,
        aspect: this.aspect,
      },
      depthWrite: false,
    });
    // Drawn last of the opaque things: pixels that the pot covers are then not computed twice.
    this.drawable = { geometry: this.sheet.geometry, material, order: 1, visible: true };
  }

  release(): void {
    this.sheet.release();
  }
}
