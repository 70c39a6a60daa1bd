import type { Camera } from "../camera";
import type { Drawable } from "../gl/drawable";
import { IDENTITY } from "../gl/view";
import type { See } from "../pull/reach";
import { sightOf } from "../pull/sight";
import type { Bench, Tool } from "../stage";

/** Knows where points of the scene are seen, and tells before every frame: what stands over the stage moves with it. It draws nothing itself. */
export class Watch implements Tool {
  visible = true;
  onFrame: () => void = () => {};
  readonly drawables: readonly Drawable[] = [];
  private size: readonly [number, number] = [0, 0];

  constructor(private readonly bench: Bench) {}

  prepare(_camera: Camera, width: number, height: number): void {
    this.size = [width, height];
    this.onFrame();
  }

  /** How large the stage is, in CSS pixels. */
  get screen(): readonly [width: number, height: number] {
    return this.size;
  }

  /** How points of the scene are seen now. */
  sight(): See | null {
    return sightOf(this.bench, this.size, IDENTITY);
  }

  release(): void {}
}
