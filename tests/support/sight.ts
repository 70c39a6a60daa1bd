// What can be seen: pictures of the stage compared with each other, never with stored ones.

import { inflateSync } from "node:zlib";
import type { Visit } from "./visit.ts";

/** A picture's size and how many colours it has. */
export interface Sight {
  readonly width: number;
  readonly height: number;
  readonly tones: number;
}

/** A picture of the 3D view alone, without what floats over it, once nothing moves any more. */
export async function stagePicture(pot: Visit): Promise<Buffer> {
  if (await pot.page.evaluate(() => "pasuUnpainted" in globalThis))
    throw new Error("the stage is not painted on this visit: take CLEAR, SHARP or `painted: true`");
  await atRest(pot);
  const canvas = pot.page.locator("pasu-stage .host canvas");
  const box = await canvas.boundingBox();
  if (!box) throw new Error("the stage cannot be seen");
  // The middle: notes and tools lie at the edges.
  const clip = {
    x: box.x + 0.2 * box.width,
    y: box.y + 0.2 * box.height,
    width: 0.6 * box.width,
    height: 0.5 * box.height,
  };
  return await pot.page.screenshot({ clip });
}

/** Counts what WebGL draws from now on; to be called before the page opens. */
export async function countDraws(pot: Visit): Promise<void> {
  await pot.context.addInitScript(() => {
    const counted = globalThis as unknown as { pasuDraws: number };
    counted.pasuDraws = 0;
    const { prototype } = WebGL2RenderingContext;
    for (const name of ["drawElements", "drawArrays"] as const) {
      const draw = prototype[name] as (...parameters: number[]) => void;
      prototype[name] = function (this: WebGL2RenderingContext, ...parameters: number[]) {
        counted.pasuDraws += 1;
        draw.apply(this, parameters);
      };
    }
  });
}

/** How often WebGL has drawn, once a row of frames has passed without. */
export async function atRest(pot: Visit): Promise<number> {
  const frames = 12;
  return await pot.page.evaluate(async (quiet) => {
    const counted = globalThis as unknown as { pasuDraws?: number };
    let before = counted.pasuDraws ?? 0;
    // The stage draws its best picture a moment after the last movement, and under a hand as late as a slow one takes.
    const wait = (milliseconds: number) => new Promise((resolve) => setTimeout(resolve, milliseconds));
    const view = document.querySelector("pasu-app")?.shadowRoot?.querySelector("pasu-stage");
    const { stage } = (view ?? {}) as { stage?: { whenIdle(): Promise<void> } };
    await wait(150);
    await Promise.race([stage?.whenIdle(), wait(3000)]);
    for (let still = 0; still < quiet; ) {
      await new Promise((resolve) => requestAnimationFrame(resolve));
      const now = counted.pasuDraws ?? 0;
      still = now === before ? still + 1 : 0;
      before = now;
    }
    return before;
  }, frames);
}

/** Where two pictures of the same size differ: by how many of 255 levels in the mean, and in what share of their pixels visibly. */
export function difference(a: Buffer, b: Buffer): { readonly mean: number; readonly share: number } {
  const [one, other] = [pixels(a), pixels(b)];
  if (one.width !== other.width || one.height !== other.height) throw new Error("pictures of different sizes");
  const visible = 12;
  let sum = 0;
  let seen = 0;
  const count = one.width * one.height;
  for (let i = 0; i < 3 * count; i += 3) {
    const apart = Math.max(...[0, 1, 2].map((k) => Math.abs((one.rgb[i + k] ?? 0) - (other.rgb[i + k] ?? 0))));
    sum += apart;
    if (apart > visible) seen += 1;
  }
  return { mean: sum / count, share: seen / count };
}

/** A picture's size and how many colours it has. */
export function sight(png: Buffer): Sight {
  const { width, height, rgb } = pixels(png);
  const tones = new Set<number>();
  for (let i = 0; i < rgb.length; i += 3) tones.add(rgb.readUIntBE(i, 3));
  return { width, height, tones: tones.size };
}

/** How bright a picture is in the mean, 0 to 255. */
export function brightness(png: Buffer): number {
  const { rgb } = pixels(png);
  return rgb.reduce((sum, each) => sum + each, 0) / rgb.length;
}

/** The mean colour of a piece of a picture, whose sides are shares of its width and height. */
export function colour(
  png: Buffer,
  [left, top, right, bottom]: readonly [number, number, number, number],
): readonly [red: number, green: number, blue: number] {
  const { width, height, rgb } = pixels(png);
  const sum: [number, number, number] = [0, 0, 0];
  let count = 0;
  for (let y = Math.floor(top * height); y < bottom * height; y += 1) {
    for (let x = Math.floor(left * width); x < right * width; x += 1) {
      for (const k of [0, 1, 2] as const) sum[k] += rgb[3 * (y * width + x) + k] ?? 0;
      count += 1;
    }
  }
  return [sum[0] / count, sum[1] / count, sum[2] / count];
}

/** Reads a PNG of 8-bit RGB or RGBA, as browsers write them. */
function pixels(png: Buffer): { readonly width: number; readonly height: number; readonly rgb: Buffer } {
  const width = png.readUInt32BE(16);
  const height = png.readUInt32BE(20);
  const bytes = png[25] === 6 ? 4 : 3;
  const parts: Buffer[] = [];
  for (let at = 8; at < png.length; ) {
    const length = png.readUInt32BE(at);
    if (png.toString("latin1", at + 4, at + 8) === "IDAT") parts.push(png.subarray(at + 8, at + 8 + length));
    at += 12 + length;
  }
  const rows = inflateSync(Buffer.concat(parts));
  const stride = width * bytes;
  const rgb = Buffer.alloc(3 * width * height);
  let above = Buffer.alloc(stride);
  for (let y = 0; y < height; y += 1) {
    const filter = rows[y * (stride + 1)] ?? 0;
    const row = Buffer.from(rows.subarray(y * (stride + 1) + 1, (y + 1) * (stride + 1)));
    for (let i = 0; i < stride; i += 1) {
      const left = i >= bytes ? (row[i - bytes] ?? 0) : 0;
      const up = above[i] ?? 0;
      const corner = i >= bytes ? (above[i - bytes] ?? 0) : 0;
      row[i] = ((row[i] ?? 0) + predicted(filter, left, up, corner)) & 255;
    }
    for (let x = 0; x < width; x += 1) row.copy(rgb, 3 * (y * width + x), x * bytes, x * bytes + 3);
    above = row;
  }
  return { width, height, rgb };
}

/** The filters of PNG (RFC 2083, section 6). */
function predicted(filter: number, left: number, up: number, corner: number): number {
  switch (filter) {
    case 1:
      return left;
    case 2:
      return up;
    case 3:
      return (left + up) >> 1;
    case 4: {
      const guess = left + up - corner;
      const [a, b, c] = [Math.abs(guess - left), Math.abs(guess - up), Math.abs(guess - corner)];
      return a <= b && a <= c ? left : b <= c ? up : corner;
    }
    default:
      return 0;
  }
}
