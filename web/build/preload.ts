// Tells the browser in the page's head what the first picture takes, so that it is fetched at once and side by side: the
// solver's module and the renderer, which the scripts would ask for only when they run.

import type { Plugin } from "vite";

type Bundle = Readonly<Record<string, { readonly type: "asset" | "chunk"; readonly fileName: string }>>;

interface Chunk {
  readonly type: "chunk";
  readonly fileName: string;
  readonly facadeModuleId: string | null;
  readonly isEntry: boolean;
  readonly imports: readonly string[];
}

/** `renderer` is the module that the page imports when it is there. */
export function preload(options: { renderer: string }): Plugin {
  return {
    name: "pasu:preload",
    apply: "build",
    transformIndexHtml: {
      order: "post",
      handler(_, { bundle }) {
        if (!bundle) return [];
        const files: Bundle = bundle;
        const chunks = Object.values(files).filter((file): file is Chunk => file.type === "chunk");
        const renderer = chunks.find((chunk) => chunk.facadeModuleId === options.renderer);
        const solver = Object.values(files).find(({ fileName }) => /pasu_drawing_bg.*\.wasm$/.test(fileName));
        if (!renderer || !solver) throw new Error("the renderer's chunk or the solver's module is not in the bundle");
        // What the entry imports itself has its hints already.
        const known = chunks.filter((chunk) => chunk.isEntry).flatMap((chunk) => [...closure(files, chunk)]);
        const scripts = [...closure(files, renderer)].filter((file) => !known.includes(file));
        const hint = (attrs: Record<string, string | boolean>, file: string) => ({
          tag: "link",
          attrs: { ...attrs, crossorigin: true, href: `./${file}` },
          injectTo: "head" as const,
        });
        return [
          hint({ rel: "preload", as: "fetch", type: "application/wasm" }, solver.fileName),
          ...scripts.map((file) => hint({ rel: "modulepreload" }, file)),
        ];
      },
    },
  };
}

/** A chunk and everything that it imports before it runs. */
function closure(bundle: Bundle, { fileName }: Chunk): ReadonlySet<string> {
  const found = new Set<string>();
  const waiting = [fileName];
  for (let file = waiting.pop(); file !== undefined; file = waiting.pop()) {
    if (found.has(file)) continue;
    found.add(file);
    waiting.push(...((bundle[file] as Chunk | undefined)?.imports ?? []));
  }
  return found;
}
