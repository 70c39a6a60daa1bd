import { Data3DTexture, LinearFilter, LinearMipmapLinearFilter, RepeatWrapping } from "three";

/** Cells along an edge of the block; the block repeats. */
const SIZE = 32;

/**
 * A block of repeating random numbers in four independent channels, from which the shaders make every irregularity of a glaze. One fetch of
 * it costs a fraction of computing noise in the shader, which matters where the GPU is software. The numbers are always the same.
 */
export function noiseTexture(): Data3DTexture {
  const data = new Uint8Array(SIZE ** 3 * 4);
  let state = 0x9e3779b9;
  for (let i = 0; i < data.length; i++) {
    // xorshift32
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    data[i] = state >>> 24;
  }
  const texture = new Data3DTexture(data, SIZE, SIZE, SIZE);
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.wrapR = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.needsUpdate = true;
  return texture;
}
