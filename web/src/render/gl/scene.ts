import type { Drawable } from "./drawable";

/** Something that brings draw calls, which may be others from frame to frame. */
export interface Source {
  readonly drawables: readonly Drawable[];
}

/** What is drawn, in the order in which it is. */
export class Scene {
  private readonly sources = new Set<Source>();
  private readonly sorted: Drawable[] = [];

  add(...sources: readonly Source[]): void {
    for (const source of sources) this.sources.add(source);
  }

  remove(source: Source): void {
    this.sources.delete(source);
  }

  /** Everything there is, by order, and as it was added where that is the same. The list is the scene's, and good until it is asked again. */
  get drawables(): readonly Drawable[] {
    const { sorted } = this;
    sorted.length = 0;
    for (const { drawables } of this.sources) for (const each of drawables) sorted.push(each);
    return sorted.sort((a, b) => a.order - b.order);
  }
}
