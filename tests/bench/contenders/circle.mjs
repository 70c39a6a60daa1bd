// Cosine and sine of `n v` for every `n` of a surface, computed once a vertex for all three components.

export class Circle {
  constructor(components) {
    this.harmonics = [...new Set(components.flat().map(({ n }) => n))];
    this.cos = new Float64Array(Math.max(...this.harmonics) + 1);
    this.sin = new Float64Array(this.cos.length);
  }

  at(v) {
    const { harmonics, cos, sin } = this;
    for (let h = 0; h < harmonics.length; h++) {
      const n = harmonics[h];
      cos[n] = Math.cos(n * v);
      sin[n] = Math.sin(n * v);
    }
  }
}
