import {
  BufferAttribute,
  BufferGeometry,
  type Camera,
  GLSL3,
  Mesh,
  NearestFilter,
  NoBlending,
  OrthographicCamera,
  RawShaderMaterial,
  Scene,
  type Texture,
  type WebGLRenderer,
  WebGLRenderTarget,
} from "three";
import type { Tenant } from "./context";
import type { Fineness } from "./resolution";

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
 * The way of a scene to the screen. Smooth edges are a matter of the frame, not of the context: with several samples it is drawn into a
 * target of its own and copied, with none straight to the screen, which is more than twice as fast where the GPU is software.
 */
export class Screen implements Tenant {
  private target: WebGLRenderTarget | null = null;
  private size = { width: 0, height: 0, ratio: 0 };
  private readonly sheet: Mesh<BufferGeometry, RawShaderMaterial>;
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly image: { value: Texture | null } = { value: null };

  constructor(private readonly renderer: WebGLRenderer) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3));
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { image: this.image },
      depthTest: false,
      depthWrite: false,
      blending: NoBlending,
    });
    this.sheet = new Mesh(geometry, material);
    this.sheet.frustumCulled = false;
    this.scene.add(this.sheet);
  }

  /** Draws a frame; sizes in CSS pixels. */
  draw(scene: Scene, camera: Camera, width: number, height: number, { ratio, samples }: Fineness): void {
    const { renderer, size } = this;
    if (size.width !== width || size.height !== height || size.ratio !== ratio) {
      this.size = { width, height, ratio };
      renderer.setPixelRatio(ratio);
      renderer.setSize(width, height, false);
    }
    const { width: columns, height: rows } = renderer.domElement;
    if (samples === 0) {
      renderer.setRenderTarget(null);
      renderer.clear();
      renderer.render(scene, camera);
      return;
    }
    if (this.target?.width !== columns || this.target.height !== rows) {
      this.target?.dispose();
      this.target = new WebGLRenderTarget(columns, rows, {
        samples,
        generateMipmaps: false,
        minFilter: NearestFilter,
        magFilter: NearestFilter,
      });
    }
    renderer.setRenderTarget(this.target);
    renderer.clear();
    renderer.render(scene, camera);
    renderer.setRenderTarget(null);
    this.image.value = this.target.texture;
    renderer.render(this.scene, this.camera);
  }

  /** Gives up everything on the GPU. */
  release(): void {
    this.target?.dispose();
    this.target = null;
    this.sheet.geometry.dispose();
    this.sheet.material.dispose();
  }
}
