// Leaves out of three's renderer what the designer never asks it for, a quarter of its weight: the sources of the
// built-in materials (every material here brings its whole program), headsets, and prefiltered environment maps.

import type { Plugin } from "vite";

const RENDERER = /[\\/]three[\\/]build[\\/]three\.module\.js$/;

/** A piece of shader source at the top level, which only the built-in programs are put together from. */
const SOURCE = /^(var|const) (\w+) = "(?:[^"\\]|\\.)*";$/gm;

/** Three 0.187 has 108 before its table of them; far fewer would mean that this plugin no longer does anything. */
const FEWEST = 80;

/** What stands in for a class: no more than the renderer touches while the feature is off. */
const STAND_INS: Readonly<Record<string, string>> = {
  WebXRManager: `class WebXRManager extends EventDispatcher {
  constructor() { super(); this.enabled = false; this.isPresenting = false; this.cameraAutoUpdate = false; }
  hasDepthSensing() { return false; }
  getEnvironmentBlendMode() {}
  setAnimationLoop() {}
  dispose() {}
}`,
  WebXRDepthSensing: "",
  PMREMGenerator: "class PMREMGenerator { dispose() {} }",
};

/** A material or a map that needs what is left out would fail at once, which the browser tests would see. */
export function leanRenderer(): Plugin {
  return {
    name: "pasu:lean-renderer",
    apply: "build",
    transform(code, id) {
      if (!RENDERER.test(id.split("?")[0] ?? "")) return null;
      let emptied = 0;
      const table = code.indexOf("const ShaderChunk = {");
      const sources = code.slice(0, Math.max(0, table)).replace(SOURCE, (_, keyword: string, name: string) => {
        emptied += 1;
        return `${keyword} ${name} = "";`;
      });
      if (emptied < FEWEST) this.error(`three's shader sources are not where they were: found ${emptied}`);
      let lean = sources + code.slice(table);
      for (const [name, standIn] of Object.entries(STAND_INS)) {
        const whole = lean.match(new RegExp(`^class ${name}\\b[\\s\\S]*?^}`, "m"))?.[0];
        if (whole === undefined) this.error(`three's ${name} is not where it was`);
        lean = lean.replace(whole, () => standIn);
      }
      return { code: lean, map: null };
    },
  };
}
