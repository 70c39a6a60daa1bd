/** The triangles of an STL, OBJ or PLY file. Fetched, with what reads them, when a scan is first opened; files that are named in them are not. */

import { type ScanKind, scanKind } from "../../document/scanned/file-kind";

export type MeshRefusal = "too-large" | "no-mesh" | "other";

/** A scan of some million triangles. */
const MOST_BYTES = 150_000_000;
const MOST_TRIANGLES = 3_000_000;

/** Nine numbers for each triangle. */
export async function trianglesOf(file: File): Promise<Float32Array | MeshRefusal> {
  if (file.size > MOST_BYTES) return "too-large";
  const kind = scanKind(file.name);
  if (!kind) return "other";
  try {
    const geometries = await READERS[kind](file);
    const count = geometries.reduce(
      (sum, { index, position }) => sum + Math.floor((index?.count ?? position.count) / 3),
      0,
    );
    if (count > MOST_TRIANGLES) return "too-large";
    if (count === 0) return "no-mesh";
    const all = new Float32Array(9 * count);
    let at = 0;
    for (const { index, position } of geometries) {
      const corners = 3 * Math.floor((index?.count ?? position.count) / 3);
      for (let i = 0; i < corners; i += 1) {
        const corner = index ? index.getX(i) : i;
        all[at] = position.getX(corner);
        all[at + 1] = position.getY(corner);
        all[at + 2] = position.getZ(corner);
        at += 3;
      }
    }
    const finite = withFinite(all);
    return finite.length > 0 ? finite : "no-mesh";
  } catch {
    // Whatever a reader stumbles over: it is no such file.
    return "no-mesh";
  }
}

/** The triangles of which every coordinate is a number; the others are holes, which are bridged. */
function withFinite(all: Float32Array): Float32Array {
  const isWhole = (at: number) => all.subarray(at, at + 9).every(Number.isFinite);
  let kept = 0;
  for (let at = 0; at < all.length; at += 9) {
    if (!isWhole(at)) continue;
    if (kept < at) all.copyWithin(kept, at, at + 9);
    kept += 9;
  }
  return all.subarray(0, kept);
}

interface Read {
  readonly index: { readonly count: number; getX(at: number): number } | null;
  readonly position: {
    readonly count: number;
    getX(i: number): number;
    getY(i: number): number;
    getZ(i: number): number;
  };
}

const READERS: Readonly<Record<ScanKind, (file: File) => Promise<readonly Read[]>>> = {
  stl: async (file) => {
    const { STLLoader } = await import("three/examples/jsm/loaders/STLLoader.js");
    return readOf(new STLLoader().parse(await file.arrayBuffer()));
  },
  ply: async (file) => {
    const { PLYLoader } = await import("three/examples/jsm/loaders/PLYLoader.js");
    const geometry = new PLYLoader().parse(await file.arrayBuffer());
    // Points without faces are no surface.
    return geometry.index ? readOf(geometry) : [];
  },
  obj: async (file) => {
    const { OBJLoader } = await import("three/examples/jsm/loaders/OBJLoader.js");
    const all: Read[] = [];
    new OBJLoader().parse(await file.text()).traverse(({ geometry, isMesh }) => {
      if (isMesh && geometry) all.push(...readOf(geometry));
    });
    return all;
  },
};

function readOf(geometry: {
  readonly index: Read["index"];
  getAttribute(name: "position"): Read["position"] | undefined;
}): readonly Read[] {
  const position = geometry.getAttribute("position");
  return position ? [{ index: geometry.index, position }] : [];
}
