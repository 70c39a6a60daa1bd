import { Buffer } from "./buffer";
import { Geometry } from "./geometry";

/** One triangle that covers a picture. */
export class Sheet {
  private readonly corners = new Buffer(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), { size: 3 });
  readonly geometry = new Geometry({ position: this.corners });

  release(): void {
    this.geometry.release();
    this.corners.release();
  }
}
