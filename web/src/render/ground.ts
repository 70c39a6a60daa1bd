import { Buffer } from "./gl/buffer";
import type { Device, Tenant } from "./gl/device";
import { type Drawable, draw } from "./gl/drawable";
import { Geometry } from "./gl/geometry";
import { Material, type Uniform } from "./gl/material";
import { Target } from "./gl/target";
import type { Texture } from "./gl/texture";
import { PLACING_GLSL } from "./placing";
import type { Pot } from "./pot";
import type { Studio } from "./studio";

/** Texels along an edge of the shadow texture: shadows are soft, more would not be seen. */
export const TEXELS = 96;

/** Half the side of the table's shadowed square, in units of what stands on it. */
const REACH = 2.4;

/** Where the shadow begins to fade and where it ends, as shares of the half side: on a backdrop, and on a picture that is cut out. */
const WIDE = [0.55, 1];
const NARROW = [0.14, 0.43];

/** Footprint pass: how strongly each place of the table is covered, near (red) and far (green), seen from below. */
const COVER_VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
${PLACING_GLSL}
uniform vec4 area;
uniform float table;
out float vHeight;
out vec3 vScene;
void main() {
  vec3 p = inFrame(position) + shift;
  vScene = p;
  vHeight = (p.z - table) / area.z;
  gl_Position = vec4((p.xy - area.xy) / area.w, 0.0, 1.0);
}
`;

const COVER_FRAGMENT = /* glsl */ `
precision highp float;
in float vHeight;
in vec3 vScene;
uniform vec4 cut;
out vec4 colour;
void main() {
  if (dot(vScene, cut.xyz) > cut.w) discard;
  float h = max(0.0, vHeight);
  colour = vec4(exp(-h / 0.05), exp(-h / 0.7), 0.0, 1.0);
}
`;

const SCREEN_VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
out vec2 vUv;
void main() {
  vUv = position.xy * 0.5 + 0.5;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`;

/** One direction of a separable blur, narrow for the near shadow and wide for the far one. */
const BLUR_FRAGMENT = /* glsl */ `
precision highp float;
in vec2 vUv;
uniform sampler2D image;
uniform vec2 direction;
out vec4 colour;
void main() {
  vec2 sum = vec2(0.0);
  float weights = 0.0;
  for (int i = -4; i <= 4; i++) {
    float x = float(i);
    float weight = 1.0 - x * x / 25.0;
    weight *= weight;
    sum.x += weight * texture(image, vUv + direction * x * 0.5).x;
    sum.y += weight * texture(image, vUv + direction * x * 3.0).y;
    weights += weight;
  }
  colour = vec4(sum / weights, 0.0, 1.0);
}
`;

const TABLE_VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform vec4 area;
uniform float table;
out vec2 vUv;
void main() {
  vUv = position.xy * 0.5 + 0.5;
  // A hair lower than what stands on it, whose underside is seen where it is cut open.
  gl_Position = projectionMatrix * viewMatrix * vec4(area.xy + position.xy * area.w, table - 0.003, 1.0);
}
`;

const TABLE_FRAGMENT = /* glsl */ `
precision highp float;
in vec2 vUv;
uniform sampler2D image;
uniform vec2 turn;
uniform float shadow;
uniform vec2 extent;
out vec4 colour;
void main() {
  vec2 near = texture(image, vUv).xy;
  // The large lamp stands at the left: the far shadow falls to the right, softly.
  vec2 away = vec2(turn.x * 0.81 + turn.y * 0.59, -turn.y * 0.81 + turn.x * 0.59);
  float thrown = texture(image, vUv - away * 0.07).y;
  float dark = 1.0 - (1.0 - 0.85 * near.x) * (1.0 - 0.34 * near.y) * (1.0 - 0.4 * thrown);
  vec2 edge = abs(vUv * 2.0 - 1.0);
  float fade = 1.0 - smoothstep(extent.x, extent.y, length(edge));
  colour = vec4(0.0, 0.0, 0.0, shadow * dark * fade);
}
`;

/** The plane before which nothing is taken away. */
export const WHOLE = [0, 0, 0, 1] as const;

/**
 * The table that the pot stands on, seen only by the shadow on it. The shadow is computed when the mesh or the cut changes, not per frame: the
 * pot is drawn once from below into a small texture, where each place keeps how close the clay comes to it, and blurred.
 */
export class Ground implements Tenant {
  readonly drawable: Drawable;
  /** Centre x, y; size of what stands there; half side of the shadowed square; in scene space. */
  private readonly area = { value: [0, 0, 1, 1] };
  private readonly extent = { value: WIDE };
  private readonly targets = [newTarget(), newTarget()] as const;
  private readonly corners = new Buffer(
    new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, 1, 1, 0, -1, 1, 0]),
    { size: 3 },
  );
  private readonly square = new Geometry({ position: this.corners });
  private readonly cover: Material;
  private readonly blur: Material;
  private readonly image: Uniform<Texture> = { value: this.targets[0].texture };
  private readonly direction = { value: [0, 0] };

  constructor(studio: Studio) {
    this.cover = new Material({
      vertex: COVER_VERTEX,
      fragment: COVER_FRAGMENT,
      uniforms: { frame: studio.frame, table: studio.table, area: this.area },
      bothSides: true,
      depthTest: false,
      depthWrite: false,
      blending: "largest",
    });
    this.blur = new Material({
      vertex: SCREEN_VERTEX,
      fragment: BLUR_FRAGMENT,
      uniforms: { image: this.image, direction: this.direction },
      depthTest: false,
      depthWrite: false,
    });
    const table = new Material({
      vertex: TABLE_VERTEX,
      fragment: TABLE_FRAGMENT,
      uniforms: {
        image: { value: this.targets[0].texture },
        area: this.area,
        table: studio.table,
        turn: studio.turn,
        shadow: studio.shadow,
        extent: this.extent,
      },
      // From below there is no table: the foot is then in view.
      bothSides: false,
      depthWrite: false,
      blending: "premultiplied",
    });
    this.drawable = { geometry: this.square, material: table, order: 2, visible: false };
  }

  /** Whether the shadow keeps within a fitted picture, for pictures without a backdrop, whose edges would show in it. */
  set narrow(narrow: boolean) {
    this.extent.value = narrow ? NARROW : WIDE;
  }

  /** Takes the shadow of what stands on the table; `centre` and `size` are what it fills, in scene space. What is cut away throws none. */
  bake(device: Device, pots: readonly Pot[], centre: readonly [number, number], size: number): void {
    this.drawable.visible = pots.length > 0;
    if (pots.length === 0) return;
    this.area.value = [centre[0], centre[1], size, size * REACH];
    const [first, second] = this.targets;
    first.begin(device);
    const footprints = pots.flatMap((pot) => pot.drawables.map((each) => ({ ...each, material: this.cover })));
    draw(device, footprints);
    const sheet: Drawable = { geometry: this.square, material: this.blur, order: 0, visible: true };
    const pass = (from: Target, to: Target, direction: number[]) => {
      this.image.value = from.texture;
      this.direction.value = direction;
      to.begin(device);
      draw(device, [sheet]);
    };
    for (const round of [1, 0.55]) {
      pass(first, second, [round / TEXELS, 0]);
      pass(second, first, [0, round / TEXELS]);
    }
  }

  /** Gives up everything on the GPU; the shadow has to be baked again. */
  release(): void {
    for (const target of this.targets) target.release();
    this.square.release();
    this.corners.release();
  }
}

function newTarget(): Target {
  return new Target(TEXELS, TEXELS, { linear: true });
}
