import type { Drawable } from "../gl/drawable";
import { Material, type Uniform } from "../gl/material";
import { PLACING_GLSL } from "../placing";
import type { Pot } from "../pot";
import type { Studio } from "../studio";
import { NEARER } from "./stroke";

/** Over the glaze and below all lines. */
const ORDER = 8;

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
in vec3 normal;
in vec2 uv;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
${PLACING_GLSL}
uniform float nearer;
out vec3 vScene;
out vec3 vNormal;
out float vAlong;
void main() {
  vScene = inFrame(position) + shift;
  vNormal = turned * normal;
  vAlong = uv.x;
  vec4 p = viewMatrix * vec4(vScene, 1.0);
  p.xyz *= nearer;
  gl_Position = projectionMatrix * p;
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
in vec3 vScene;
in vec3 vNormal;
in float vAlong;
uniform vec3 eye;
uniform vec4 cut;
uniform float ratio;
out vec4 colour;
void main() {
  if (dot(vScene, cut.xyz) > cut.w) discard;
  // How many CSS pixels it is to where the surface turns away from the eye, and to its ends.
  float facing = abs(dot(normalize(vNormal + vec3(0.0, 0.0, 1e-12)), normalize(eye - vScene)));
  float turns = 0.5 * facing / max(fwidth(facing), 1e-6);
  float ends = min(vAlong, 1.0 - vAlong) / max(fwidth(vAlong), 1e-6);
  // Where the surface is seen at a grazing angle all over there is no edge.
  float off = min(facing < 0.7 ? turns : 1e6, ends) / ratio;
  float core = 1.0 - smoothstep(2.0, 3.0, off);
  float all = 1.0 - smoothstep(3.6, 4.6, off);
  if (all < 0.004) discard;
  colour = vec4(mix(vec3(1.0), vec3(0.0, 0.42, 0.55), core) * all, all);
}
`;

/** A dark outline with a light border round the parts that are selected of several: seen on every glaze. */
export class Mark {
  /** Whether it is drawn; pictures have none. */
  visible = true;
  private marked: readonly Drawable[] = [];
  private readonly material: Material;

  constructor(studio: Studio, cut: Uniform<readonly number[]>, ratio: Uniform<number>) {
    this.material = new Material({
      vertex: VERTEX,
      fragment: FRAGMENT,
      uniforms: { frame: studio.frame, eye: studio.eye, nearer: { value: NEARER }, cut, ratio },
      bothSides: true,
      depthWrite: false,
      blending: "premultiplied",
    });
  }

  get drawables(): readonly Drawable[] {
    return this.visible ? this.marked.filter((each) => each.visible) : [];
  }

  /** Follows parts, by their places. It draws their own triangles once more, and holds nothing on the GPU. */
  update(pot: Pot, places: readonly number[]): void {
    this.marked = places.flatMap((place) => {
      const drawable = pot.parts[place]?.drawable;
      return drawable ? [{ ...drawable, material: this.material, order: ORDER }] : [];
    });
  }
}
