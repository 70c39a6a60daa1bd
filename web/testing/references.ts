// The surfaces of tests/reference: shapes of every kind and in every regime, with points on them.

import { readFile } from "node:fs/promises";
import init from "pasu/drawing";
import type { TwoSided } from "../src/document/types";

export interface Reference {
  readonly name: string;
  readonly shape: TwoSided;
  readonly points: readonly (readonly [u: number, v: number])[];
}

interface Stored {
  readonly name: string;
  readonly shape: TwoSided;
  readonly family?: TwoSided;
  readonly points: readonly { readonly u: number; readonly v: number }[];
}

async function bytes(path: string): Promise<Buffer> {
  return readFile(new URL(`../../${path}`, import.meta.url));
}

/** The solver's module, ready to be asked. */
export async function library(): Promise<void> {
  await init(await WebAssembly.compile(new Uint8Array(await bytes("crates/pasu-wasm/pkg/pasu_drawing_bg.wasm"))));
}

/** All of a file, with the families that stand beside what they expand to. */
export async function references(file: "surfaces" | "rings" | "ring-regimes"): Promise<Reference[]> {
  const stored = JSON.parse(String(await bytes(`tests/reference/${file}.json`))) as readonly Stored[];
  return stored.flatMap(({ name, shape, family, points }) => {
    const at = points.map(({ u, v }) => [u, v] as const);
    const general = { name, shape, points: at };
    return family ? [general, { ...general, name: `${name} as ${family.kind}`, shape: family }] : [general];
  });
}
