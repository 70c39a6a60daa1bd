import { Texture } from "./gl/texture";

/** Cells along an edge of the block; the block repeats. */
const SIZE = 32;

/**
 * A block of repeating random numbers in four independent channels, from which the shaders make every irregularity of a glaze. One fetch of
 * it costs a fraction of computing noise in the shader, which matters where the GPU is software. The numbers are always the same, and so
 * there is one block for whatever is drawn.
 */
export const NOISE = new Texture({
  target: "TEXTURE_3D",
  allocate(gl) {
    const levels = Math.log2(SIZE) + 1;
    gl.texStorage3D(gl.TEXTURE_3D, levels, gl.RGBA8, SIZE, SIZE, SIZE);
    gl.texParameteri(gl.TEXTURE_3D, gl.TEXTURE_WRAP_S, gl.REPEAT);
    gl.texParameteri(gl.TEXTURE_3D, gl.TEXTURE_WRAP_T, gl.REPEAT);
    gl.texParameteri(gl.TEXTURE_3D, gl.TEXTURE_WRAP_R, gl.REPEAT);
    gl.texParameteri(gl.TEXTURE_3D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_3D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
  },
  fill(gl) {
    gl.texSubImage3D(gl.TEXTURE_3D, 0, 0, 0, 0, SIZE, SIZE, SIZE, gl.RGBA, gl.UNSIGNED_BYTE, numbers());
    gl.generateMipmap(gl.TEXTURE_3D);
  },
});

function numbers(): Uint8Array {
  const data = new Uint8Array(SIZE ** 3 * 4);
  let state = 0x9e3779b9;
  for (let i = 0; i < data.length; i++) {
    // xorshift32
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    data[i] = state >>> 24;
  }
  return data;
}
