/** Triangles of which y is up, turned about x so that z is. */
export function upright(triangles: Float32Array): Float32Array {
  const turned = new Float32Array(triangles.length);
  for (let i = 0; i + 2 < triangles.length; i += 3) {
    turned[i] = triangles[i] as number;
    turned[i + 1] = -(triangles[i + 2] as number);
    turned[i + 2] = triangles[i + 1] as number;
  }
  return turned;
}
