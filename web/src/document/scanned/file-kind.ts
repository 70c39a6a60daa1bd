/** Files that a scan may come in, by their names. */

export type ScanKind = "stl" | "obj" | "ply";

/** Null for any other file. */
export function scanKind(name: string): ScanKind | null {
  return (/\.(stl|obj|ply)$/i.exec(name)?.[1]?.toLowerCase() as ScanKind | undefined) ?? null;
}
