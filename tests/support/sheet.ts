// A large network of patches: a sheet with waves.

/** A design of so many patches one way and the other. */
export function sheet(rows: number, columns: number): object {
  const [vertices, patches]: [number[][], object[]] = [[], []];
  const wide = 2 * columns + 1;
  const places = new Map<number, number>();
  const vertex = (row: number, column: number) => {
    const key = row * wide + column;
    const known = places.get(key);
    if (known !== undefined) return known;
    const point = [(column - columns) / 4, (row - rows) / 4, Math.sin(column / 9) * Math.cos(row / 7)];
    places.set(key, vertices.push(point) - 1);
    return vertices.length - 1;
  };
  for (let row = 0; row < rows; row += 1) {
    for (let column = 0; column < columns; column += 1) {
      const at = (right: number, up: number) => vertex(2 * row + up, 2 * column + right);
      patches.push({ frame: [at(0, 0), at(1, 0), at(2, 0), at(2, 1), at(2, 2), at(1, 2), at(0, 2), at(0, 1)] });
    }
  }
  return { pasu: 1, parts: [{ shape: { kind: "vertex-frame", vertices, patches } }] };
}
