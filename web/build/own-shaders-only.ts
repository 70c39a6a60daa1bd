// Leaves three's own shader programs out of the build. Every material of the designer brings its whole program
// (RawShaderMaterial), but the renderer keeps the sources of all built-in ones, a sixth of its weight.

import type { Plugin } from "vite";

const RENDERER = /[\\/]three[\\/]build[\\/]three\.module\.js$/;

/** A piece of shader source at the top level, which only the built-in programs are put together from. */
const SOURCE = /^(var|const) (\w+) = "(?:[^"\\]|\\.)*";$/gm;

/** Three 0.187 has 108 or so; far fewer would mean that this plugin no longer does anything. */
const FEWEST = 80;

/** Empties the built-in shader sources; a material that needs one would not compile, which the browser tests would see. */
export function ownShadersOnly(): Plugin {
  return {
    name: "pasu:own-shaders-only",
    apply: "build",
    transform(code, id) {
      if (!RENDERER.test(id.split("?")[0] ?? "")) return null;
      let emptied = 0;
      const start = code.indexOf("const ShaderChunk = {");
      const lighter = code.slice(0, start).replace(SOURCE, (_, keyword: string, name: string) => {
        emptied += 1;
        return `${keyword} ${name} = "";`;
      });
      if (start < 0 || emptied < FEWEST) this.error(`three's shader sources are not where they were: found ${emptied}`);
      return { code: lighter + code.slice(start), map: null };
    },
  };
}
