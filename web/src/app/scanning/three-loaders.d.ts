/** What is used of the loaders of three.js, which come without types. */

interface Attribute {
  readonly count: number;
  getX(index: number): number;
  getY(index: number): number;
  getZ(index: number): number;
}

interface Geometry {
  readonly index: { readonly count: number; getX(at: number): number } | null;
  getAttribute(name: "position"): Attribute | undefined;
}

declare module "three/examples/jsm/loaders/STLLoader.js" {
  export class STLLoader {
    parse(data: ArrayBuffer): Geometry;
  }
}

declare module "three/examples/jsm/loaders/PLYLoader.js" {
  export class PLYLoader {
    parse(data: ArrayBuffer): Geometry;
  }
}

declare module "three/examples/jsm/loaders/OBJLoader.js" {
  export class OBJLoader {
    parse(text: string): {
      traverse(visit: (each: { readonly geometry?: Geometry; readonly isMesh?: boolean }) => void): void;
    };
  }
}
