// Leaves out of three's renderer what the designer never asks it for, half of its weight: built-in materials with their lights, shadows
// and sources (every material here brings its whole program), headsets, environment maps, and every function that nobody calls.

import { readdirSync, readFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { type Plugin, parseAst } from "vite";
import { withoutUnmentioned } from "./unmentioned.ts";

const THREE = /[\\/]three[\\/]build[\\/]three\.(?:core|module)\.js$/;
const FILES = ["three.core.js", "three.module.js"];

/** What stands in for a class or a function: no more than the renderer touches while the feature is off. */
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
  WebGLBackground: `function WebGLBackground( renderer, environments, state, objects, alpha, premultipliedAlpha ) {
  const clearColor = new Color( 0x000000 );
  let clearAlpha = alpha === true ? 0 : 1;
  function setClear() {
    clearColor.getRGB( _rgb, getUnlitUniformColorSpace( renderer ) );
    state.buffers.color.setClear( _rgb.r, _rgb.g, _rgb.b, clearAlpha, premultipliedAlpha );
  }
  return {
    getClearColor() { return clearColor; },
    setClearColor( color, alpha = 1 ) { clearColor.set( color ); clearAlpha = alpha; setClear(); },
    getClearAlpha() { return clearAlpha; },
    setClearAlpha( alpha ) { clearAlpha = alpha; setClear(); },
    render() { setClear(); },
    addToRenderList() {},
    dispose() {},
  };
}`,
  WebGLClipping: `function WebGLClipping() {
  return { numPlanes: 0, numIntersection: 0, uniform: { value: null }, init() { return false; }, setState() {}, setGlobalState() {}, beginShadows() {}, endShadows() {} };
}`,
  WebGLEnvironments: "function WebGLEnvironments() { return { get() { return null; }, dispose() {} }; }",
  WebGLLights: "function WebGLLights() { return { state: { version: 0 }, setup() {}, setupView() {} }; }",
  WebGLMaterials: `function WebGLMaterials() {
  return { refreshFogUniforms() {}, refreshMaterialUniforms( uniforms, material ) { material.uniformsNeedUpdate = false; } };
}`,
  WebGLMorphtargets: "function WebGLMorphtargets() { return { update() {} }; }",
  getDFGLUT: "function getDFGLUT() {}",
  WebGLOutput: "class WebGLOutput {}",
  WebGLShadowMap: "function WebGLShadowMap() { return { enabled: false, render() {} }; }",
  WebGLUniformsGroups: "function WebGLUniformsGroups() { return { bind() {}, update() {}, dispose() {} }; }",
  // A material whose programs are put together here cannot be told from one that brings its own but by this.
  WebGLPrograms: `function WebGLPrograms( renderer, environments, extensions, capabilities, bindingStates ) {
  const programs = [];
  const programsMap = new Map();
  return {
    programs,
    getParameters( material, lights, shadows, scene, object ) {
      if ( ! material.isRawShaderMaterial ) throw new Error( 'The designer leaves out ' + material.type );
      const { type, name, vertexShader, fragmentShader, defines, glslVersion, index0AttributeName } = material;
      return {
        shaderType: type, shaderName: name, vertexShader, fragmentShader, defines, glslVersion, index0AttributeName,
        hasPositionAttribute: object.geometry.attributes.position !== undefined,
        outputColorSpace: renderer.getRenderTarget() === null ? renderer.outputColorSpace : ColorManagement.workingColorSpace,
        toneMapping: NoToneMapping, vertexAlphas: false, vertexTangents: false,
        morphTargets: false, morphNormals: false, morphColors: false, morphTargetsCount: 0,
        isRawShaderMaterial: true, rendererExtensionParallelShaderCompile: false,
      };
    },
    getProgramCacheKey( { vertexShader, fragmentShader, defines, index0AttributeName, hasPositionAttribute } ) {
      return JSON.stringify( [ vertexShader, fragmentShader, defines, index0AttributeName, hasPositionAttribute ] );
    },
    getUniforms( material ) { return material.uniforms; },
    acquireProgram( parameters, cacheKey ) {
      let program = programsMap.get( cacheKey );
      if ( program !== undefined ) {
        program.usedTimes += 1;
      } else {
        program = new WebGLProgram( renderer, cacheKey, parameters, bindingStates );
        programs.push( program );
        programsMap.set( cacheKey, program );
      }
      return program;
    },
    releaseProgram( program ) {
      program.usedTimes -= 1;
      if ( program.usedTimes > 0 ) return;
      programs.splice( programs.indexOf( program ), 1 );
      programsMap.delete( program.cacheKey );
      program.destroy();
    },
    releaseShaderCache() {},
    dispose() {},
  };
}`,
};

/** Kinds of things that the designer never makes: what asks for them is told no, and the bundler drops what follows from yes. */
const NEVER = [
  ...["isBatchedMesh", "isInstancedMesh", "isLOD", "isLightProbeGrid", "isLineLoop"],
  ...["isSkinnedMesh", "isSprite", "isArrayCamera"],
  ...["isMeshLambertMaterial", "isMeshPhongMaterial", "isMeshStandardMaterial", "isMeshToonMaterial", "isNodeMaterial"],
  ...["isShadowMaterial", "isSpriteMaterial"],
  ...["isCompressedArrayTexture", "isCompressedTexture", "isExternalTexture", "isFramebufferTexture", "isHTMLTexture"],
  ...[
    "isVideoTexture",
    "isWebGL3DRenderTarget",
    "isWebGLArrayRenderTarget",
    "isWebGLCubeRenderTarget",
    "isXRRenderTarget",
  ],
  ...["isFloat16BufferAttribute", "isInstancedInterleavedBuffer", "isInterleavedBuffer"],
  ...["isInterleavedBufferAttribute"],
];

/** What is left out within functions: from one text up to another, and what stands there instead. */
const CUTS: readonly (readonly [from: string, to: string, instead: string])[] = [
  // Colours are numbers here, not names.
  ["\tsetStyle( style, colorSpace", "\t/**\n\t * Returns a new color with copied values from", ""],
  ["Color.NAMES = _colorKeywords;", "\n", ""],
  // Of a program, all but what a material brings.
  ["const shadowMapTypeDefine = generateShadowMapTypeDefine(", "const customDefines = ", ""],
  [
    "} else {\n\n\t\tprefixVertex = [\n\n\t\t\tgeneratePrecision(",
    "vertexShader = resolveIncludes( vertexShader );",
    "}\n",
  ],
  ["vertexShader = resolveIncludes( vertexShader );", "const vertexGlsl = ", ""],
  // The stage asks for these while developing only, and a build is not developing.
  ["if ( renderer.debug.checkShaderErrors ) {", "// Clean up", ""],
  ["function renderTransmissionPass(", "function renderObjects(", "function renderTransmissionPass() {}\n"],
];

/** A material or a map that needs what is left out would fail at once, which the browser tests would see. */
export function leanRenderer({ sources }: { sources: string }): Plugin {
  let lean: Map<string, string> | undefined;
  return {
    name: "pasu:lean-renderer",
    apply: "build",
    transform(code, id) {
      const path = id.split("?")[0] ?? "";
      if (!THREE.test(path)) return null;
      lean ??= leaned(dirname(path), sources);
      return { code: lean.get(basename(path)) ?? code, map: null };
    },
  };
}

/** The texts of three by file name, without what the designer cannot reach. */
function leaned(folder: string, sources: string): Map<string, string> {
  const texts = withStandIns(FILES.map((name) => readFileSync(join(folder, name), "utf8"))).map((text) => {
    const code = withoutKinds(text);
    return { code, tree: parseAst(code) };
  });
  const shaken = withoutUnmentioned(texts, wordsOf(sources));
  const made = NEVER.filter((kind) => shaken.some((text) => text.includes(`this.${kind} = `)));
  if (made.length > 0) throw new Error(`the designer makes what it was said never to make: ${made}`);
  return new Map(FILES.map((name, index) => [name, shaken[index] ?? ""]));
}

/** Every word of our own sources. */
function wordsOf(sources: string): Set<string> {
  const files = readdirSync(sources, { recursive: true, encoding: "utf8" });
  const texts = files.filter((name) => name.endsWith(".ts") && !name.endsWith(".test.ts"));
  return new Set(texts.flatMap((name) => readFileSync(join(sources, name), "utf8").match(/[\w$]+/g) ?? []));
}

function withoutKinds(code: string): string {
  return code.replace(new RegExp(`\\b[\\w$]+(?:\\.[\\w$]+)*\\.(?:${NEVER.join("|")})\\b(?! =[^=])`, "g"), "false");
}

/** The texts with what stands in for features, each of which is in one of them. */
function withStandIns(texts: readonly string[]): string[] {
  const lean = [...texts];
  const replace = (name: string, span: (text: string) => readonly [number, number] | undefined, instead: string) => {
    const index = lean.findIndex((text) => span(text) !== undefined);
    const text = lean[index];
    const found = text === undefined ? undefined : span(text);
    if (text === undefined || found === undefined) throw new Error(`three's ${name} is not where it was`);
    lean[index] = text.slice(0, found[0]) + instead + text.slice(found[1]);
  };
  for (const [name, standIn] of Object.entries(STAND_INS)) {
    const whole = new RegExp(`^(?:class|function) ${name}\\b[\\s\\S]*?^}`, "m");
    const span = (text: string) => {
      const match = whole.exec(text);
      return match ? ([match.index, match.index + match[0].length] as const) : undefined;
    };
    replace(name, span, standIn);
  }
  for (const [from, to, instead] of CUTS) {
    const span = (text: string) => {
      const start = text.indexOf(from);
      const end = start < 0 ? -1 : text.indexOf(to, start);
      return end < 0 ? undefined : ([start, end] as const);
    };
    replace(from, span, instead);
  }
  return lean;
}
