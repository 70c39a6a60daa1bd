import { type PerspectiveCamera, type Scene, type WebGLRenderer, WebGLRenderTarget } from "three";

/** Pictures are drawn in tiles of at most this many pixels a side, whatever their size, to bound the memory on the GPU. */
const TILE = 1024;

/** The largest side that every browser's 2D canvas can hold. */
export const LARGEST_PICTURE = 8192;

const SAMPLES = 4;

/** Called before each tile with the part of the picture it covers (x, y, width, height from the lower left, 0 to 1). */
export type BeforeTile = (window: readonly [number, number, number, number]) => void;

/**
 * Draws a scene into a 2D canvas of its own, not into the screen. The camera's aspect must be that of the picture.
 *
 * @throws {RangeError} for a size that is not whole numbers from 1 to `LARGEST_PICTURE`
 */
export function drawPicture(
  renderer: WebGLRenderer,
  scene: Scene,
  camera: PerspectiveCamera,
  width: number,
  height: number,
  before: BeforeTile,
): HTMLCanvasElement {
  for (const side of [width, height]) {
    if (!Number.isInteger(side) || side < 1 || side > LARGEST_PICTURE) {
      throw new RangeError(`a picture is 1 to ${LARGEST_PICTURE} pixels wide and high, not ${width} x ${height}`);
    }
  }
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d");
  if (!context) throw new Error("the browser has no memory for a picture of this size");
  const tile: [number, number] = [Math.min(width, TILE), Math.min(height, TILE)];
  const target = new WebGLRenderTarget(...tile, { samples: SAMPLES, generateMipmaps: false });
  const pixels = new Uint8Array(4 * tile[0] * tile[1]);
  try {
    for (let y = 0; y < height; y += tile[1]) {
      for (let x = 0; x < width; x += tile[0]) {
        camera.setViewOffset(width, height, x, y, ...tile);
        before([x / width, 1 - (y + tile[1]) / height, tile[0] / width, tile[1] / height]);
        renderer.setRenderTarget(target);
        renderer.setClearColor(0x000000, 0);
        renderer.clear();
        renderer.render(scene, camera);
        renderer.readRenderTargetPixels(target, 0, 0, ...tile, pixels);
        context.putImageData(upright(pixels, ...tile), x, y);
      }
    }
  } finally {
    camera.clearViewOffset();
    renderer.setRenderTarget(null);
    target.dispose();
  }
  return canvas;
}

/** From WebGL's rows (upwards, colours multiplied by alpha) to those of a 2D canvas. */
function upright(pixels: Uint8Array, width: number, height: number): ImageData {
  const image = new ImageData(width, height);
  const out = image.data;
  const row = 4 * width;
  for (let y = 0; y < height; y++) out.set(pixels.subarray((height - 1 - y) * row, (height - y) * row), y * row);
  for (let i = 3; i < out.length; i += 4) {
    const alpha = out[i] as number;
    if (alpha === 255 || alpha === 0) continue;
    for (let k = i - 3; k < i; k++) out[k] = ((out[k] as number) * 255) / alpha;
  }
  return image;
}

export function toPng(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new Error("the browser could not write the picture"))),
      "image/png",
    );
  });
}
