import { Buffer } from "../gl/buffer";
import type { Tenant } from "../gl/device";
import type { Drawable } from "../gl/drawable";
import { Geometry } from "../gl/geometry";
import { Material, type Uniform } from "../gl/material";
import type { Studio } from "../studio";
import type { Triple } from "../triple";

type Colour = readonly [number, number, number];

/** How a line looks; widths in CSS pixels, colours in sRGB, 0 to 1. */
export interface StrokeStyle {
  width: number;
  colour: Colour;
  /** The thin border that keeps the line apart from a ground of its own colour. */
  border: Colour;
  borderWidth: number;
  opacity: number;
  /** Opacity where the pot hides the line. */
  hidden: number;
}

/** What all lines of a picture share: size of the picture in device pixels, and device pixels per CSS pixel. */
export interface Pen {
  viewport: Uniform<number[]>;
  ratio: Uniform<number>;
}

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
in vec3 start;
in vec3 end;
in vec3 middle;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform vec4 frame;
uniform vec2 viewport;
uniform float ratio;
uniform float halfWidth;
uniform float nearer;
uniform float caps;
uniform vec4 cut;
flat out float vUpTo;
out vec2 vAt;
out vec3 vScene;
flat out float vLength;
void main() {
  vec4 a = viewMatrix * vec4((start - frame.xyz) * frame.w, 1.0);
  vec4 b = viewMatrix * vec4((end - frame.xyz) * frame.w, 1.0);
  // A line that begins behind the eye is cut just before it: there is no direction on the screen behind it.
  float near = -1e-3;
  if (a.z > near && b.z > near) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  if (a.z > near) a.xyz = mix(b.xyz, a.xyz, (near - b.z) / (a.z - b.z));
  if (b.z > near) b.xyz = mix(a.xyz, b.xyz, (near - a.z) / (b.z - a.z));
  // Towards the eye: the place on the screen stays, and the line comes before the surface that it lies on.
  a.xyz *= nearer;
  b.xyz *= nearer;
  vec4 ca = projectionMatrix * a;
  vec4 cb = projectionMatrix * b;
  vec2 pa = ca.xy / ca.w * viewport * 0.5;
  vec2 pb = cb.xy / cb.w * viewport * 0.5;
  vec2 way = pb - pa;
  float size = length(way);
  way = size > 1e-4 ? way / size : vec2(1.0, 0.0);
  // One pixel more all round for the soft edge; the ends are round, which joins the segments of a polyline.
  float reach = halfWidth * ratio + 1.0;
  float cap = caps * reach;
  vec2 at = vec2(position.x > 0.0 ? size + cap : -cap, position.y * reach);
  vec2 p = pa + way * at.x + vec2(-way.y, way.x) * at.y;
  vec4 c = position.x > 0.0 ? cb : ca;
  vAt = at;
  vScene = (mix(start, end, position.x) - frame.xyz) * frame.w;
  vLength = size;
  vUpTo = middle.z > 0.5 ? dot((middle.xy - frame.xy) * frame.w, cut.xy) : cut.w;
  gl_Position = vec4(p / (viewport * 0.5) * c.w, c.z, c.w);
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
in vec2 vAt;
in vec3 vScene;
uniform vec4 cut;
flat in float vLength;
flat in float vUpTo;
uniform float ratio;
uniform float halfWidth;
uniform vec3 lineColour;
uniform float opacity;
out vec4 colour;
void main() {
  if (dot(vScene, cut.xyz) > vUpTo) discard;
  float past = vAt.x < 0.0 ? -vAt.x : max(0.0, vAt.x - vLength);
  float off = length(vec2(past, vAt.y));
  float all = clamp(halfWidth * ratio + 0.5 - off, 0.0, 1.0) * opacity;
  if (all < 0.004) discard;
  colour = vec4(lineColour * all, all);
}
`;

/** A line on a surface is drawn at this share of its distance from the eye. */
export const NEARER = 0.9975;

const CORNERS = new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, -1, 0, 1, 1, 0, 0, 1, 0]);

/** Lines of one object: start and end of each piece, six numbers, in model units, and the middle that the object is cut open through where that is not the middle of all. */
export interface Pieces {
  readonly segments: Float32Array;
  readonly middle: Triple | null;
}

/**
 * Lines of a width in CSS pixels: a rectangle per segment, widened on the screen. WebGL's own lines are one device pixel wide, whatever is
 * asked. Where `hidden` is not 0 the lines are drawn a second time, faintly, without regard to what is before them.
 */
export class Stroke implements Tenant {
  readonly drawables: Drawable[] = [];
  private readonly inks: { readonly core: boolean; readonly colour: Uniform<Colour> }[] = [];
  private readonly corners = new Buffer(CORNERS, { size: 3 });
  private readonly starts = new Buffer(new Float32Array(), { size: 3, instanced: true });
  private readonly ends = new Buffer(new Float32Array(), { size: 3, instanced: true });
  /** The middle of the object that a line is of, from above, and whether it is cut open through its own. */
  private readonly middles = new Buffer(new Float32Array(), { size: 3, instanced: true });
  private readonly geometry = new Geometry({
    position: this.corners,
    start: this.starts,
    end: this.ends,
    middle: this.middles,
  });

  constructor(
    private readonly studio: Studio,
    private readonly pen: Pen,
    style: StrokeStyle,
    order: number,
    private readonly cut: Uniform<readonly number[]>,
  ) {
    const { width, colour, border, borderWidth, opacity, hidden } = style;
    if (hidden > 0) this.add(width / 2, colour, order, false, hidden, true);
    // All of the border before any of the line: at a joint the one would cover the other.
    if (borderWidth > 0) this.add(width / 2 + borderWidth, border, order + 1, true, opacity, false);
    this.add(width / 2, colour, order + 2, true, opacity, true);
  }

  set pieces(all: readonly Pieces[]) {
    const count = all.reduce((sum, { segments }) => sum + segments.length / 6, 0);
    const [starts, ends, middles] = [0, 1, 2].map(() => new Float32Array(3 * count)) as [
      Float32Array,
      Float32Array,
      Float32Array,
    ];
    let k = 0;
    for (const { segments, middle } of all) {
      const own = middle && [middle[0], middle[1], 1];
      for (let i = 0; i < segments.length; i += 6, k += 3) {
        starts.set(segments.subarray(i, i + 3), k);
        ends.set(segments.subarray(i + 3, i + 6), k);
        if (own) middles.set(own, k);
      }
    }
    this.starts.array = starts;
    this.ends.array = ends;
    this.middles.array = middles;
    for (const drawable of this.drawables) drawable.instances = count;
  }

  /** Exchanges line and border colours for others. */
  recolour(colour: Colour, border: Colour): void {
    for (const ink of this.inks) ink.colour.value = ink.core ? colour : border;
  }

  set visible(visible: boolean) {
    for (const drawable of this.drawables) drawable.visible = visible;
  }

  /** Gives up everything on the GPU. */
  release(): void {
    this.geometry.release();
    for (const buffer of [this.corners, this.starts, this.ends, this.middles]) buffer.release();
  }

  private add(half: number, colour: Colour, order: number, depthTest: boolean, opacity: number, core: boolean): void {
    const lineColour: Uniform<Colour> = { value: colour };
    const material = new Material({
      vertex: VERTEX,
      fragment: FRAGMENT,
      uniforms: {
        frame: this.studio.frame,
        viewport: this.pen.viewport,
        ratio: this.pen.ratio,
        halfWidth: { value: half },
        nearer: { value: NEARER },
        // Round ends join the segments of a line; where the line is seen through they would show as beads.
        caps: { value: opacity === 1 ? 1 : 0 },
        lineColour,
        opacity: { value: opacity },
        cut: this.cut,
      },
      depthTest,
      depthWrite: false,
      blending: "premultiplied",
    });
    this.inks.push({ core, colour: lineColour });
    this.drawables.push({ geometry: this.geometry, material, order, visible: false, instances: 0 });
  }
}
