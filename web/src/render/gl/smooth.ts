import type { Device, Tenant } from "./device";
import { type Drawable, draw } from "./drawable";
import { Material } from "./material";
import { Sheet } from "./sheet";
import { Target } from "./target";

const VERTEX = /* glsl */ `
precision highp float;
in vec3 position;
void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }
`;

const FRAGMENT = /* glsl */ `
precision highp float;
uniform sampler2D image;
out vec4 colour;
void main() { colour = texelFetch(image, ivec2(gl_FragCoord.xy), 0); }
`;

/**
 * Frames with smooth edges. These are a matter of the frame, not of the context: with several samples it is drawn into a target of its own and copied, with
 * none straight to the screen, which is more than twice as fast where the GPU is software.
 */
export class Smooth implements Tenant {
  private target: Target | null = null;
  private samples = 0;
  private readonly sheet = new Sheet();
  private copy: Drawable | null = null;

  constructor(private readonly device: Device) {}

  /** Everything is drawn with so many samples from now on. */
  begin(width: number, height: number, samples: number): void {
    if (this.target?.width !== width || this.target.height !== height || this.samples !== samples) {
      this.target?.release();
      this.samples = samples;
      this.target = new Target(width, height, { samples, depth: true });
      const image = { value: this.target.texture };
      const material = new Material({
        vertex: VERTEX,
        fragment: FRAGMENT,
        uniforms: { image },
        depthTest: false,
        depthWrite: false,
      });
      this.copy = { geometry: this.sheet.geometry, material, order: 0, visible: true };
    }
    this.target.begin(this.device);
  }

  /** Copies what was drawn to the lower left of the canvas. */
  end(): void {
    const { device, target, copy } = this;
    if (!target || !copy) return;
    target.end(device);
    device.gl.bindFramebuffer(device.gl.FRAMEBUFFER, null);
    draw(device, [copy]);
  }

  release(): void {
    this.target?.release();
    this.target = null;
    this.sheet.release();
  }
}
