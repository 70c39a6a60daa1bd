import type { Device } from "./gl/device";
import { type Drawable, draw } from "./gl/drawable";
import { Target } from "./gl/target";
import type { View } from "./gl/view";

/** Pictures are drawn in tiles of at most this many pixels a side, whatever their size, to bound the memory on the GPU. */
const TILE = 1024;

/** The largest side that every browser's 2D canvas can hold. */
const LARGEST_PICTURE = 8192;

const SAMPLES = 4;

/** Called before each tile with the part of the picture it covers (x, y, width, height from the lower left, 0 to 1). */
export type BeforeTile = (window: readonly [number, number, number, number]) => void;

/**
 * Draws things into a 2D canvas of its own, not into the screen. The view's aspect must be that of the picture.
 *
 * @throws {RangeError} for a size that is not whole numbers from 1 to `LARGEST_PICTURE`
 */
export function drawPicture(
  device: Device,
  drawables: readonly Drawable[],
  view: View,
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
  const target = new Target(...tile, { samples: SAMPLES, depth: true });
  const pixels = new Uint8Array(4 * tile[0] * tile[1]);
  try {
    for (let y = 0; y < height; y += tile[1]) {
      for (let x = 0; x < width; x += tile[0]) {
        view.tile({ x, y, width: tile[0], height: tile[1], of: [width, height] });
        before([x / width, 1 - (y + tile[1]) / height, tile[0] / width, tile[1] / height]);
        target.begin(device);
        draw(device, drawables, view);
        target.end(device);
        target.readPixels(device, pixels);
        context.putImageData(upright(pixels, ...tile), x, y);
      }
    }
  } finally {
    view.tile(null);
    target.release();
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
