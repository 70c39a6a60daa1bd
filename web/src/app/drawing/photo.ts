/** A photograph as it lies behind what is drawn: in the middle of a square sheet, as large as there is room. It never leaves the page. */

import type { Picture } from "../../document/drawn/silhouette";

export interface Photo {
  /** Twice as fine as the sheet. */
  readonly canvas: HTMLCanvasElement;
  /** What is looked for a pot in: as fine as the sheet. */
  readonly picture: Picture;
  /** Where the picture begins on the sheet. */
  readonly x: number;
  readonly y: number;
}

/** As cameras write them, and more. */
const MOST_BYTES = 60_000_000;
const FINE = 2;

/** Null for a file that is no picture, or a picture too large to be shown. */
export async function photoOf(file: Blob, size: number): Promise<Photo | null> {
  if (file.size > MOST_BYTES) return null;
  const bitmap = await createImageBitmap(file).catch(() => null);
  if (!bitmap) return null;
  const scale = size / Math.max(bitmap.width, bitmap.height);
  const [width, height] = [bitmap.width, bitmap.height].map((each) => Math.max(1, Math.round(scale * each)));
  const [x, y] = [Math.floor((size - (width ?? 1)) / 2), Math.floor((size - (height ?? 1)) / 2)];
  const canvas = document.createElement("canvas");
  canvas.width = FINE * size;
  canvas.height = FINE * size;
  const fine = canvas.getContext("2d");
  const small = document.createElement("canvas");
  small.width = width ?? 1;
  small.height = height ?? 1;
  const coarse = small.getContext("2d", { willReadFrequently: true });
  if (!fine || !coarse) return null;
  fine.imageSmoothingQuality = "high";
  fine.drawImage(bitmap, FINE * x, FINE * y, FINE * small.width, FINE * small.height);
  // What can be looked through stands before white.
  coarse.fillStyle = "#fff";
  coarse.fillRect(0, 0, small.width, small.height);
  coarse.imageSmoothingQuality = "high";
  coarse.drawImage(bitmap, 0, 0, small.width, small.height);
  bitmap.close();
  const picture = coarse.getImageData(0, 0, small.width, small.height);
  return { canvas, picture, x, y };
}
