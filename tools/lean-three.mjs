// three without what no picture of ours uses: a third of what WebGLRenderer imports is for headsets, reflections and materials
// that are not here. A Vite plugin; it takes three's own source modules, puts stubs in the place of whole modules, and
// leaves shader code out. The tests of the picture hold that nothing is missed.

import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, relative } from "node:path";

/** The folder of three. Asked for only when it is needed: the tools are read before the packages are there. */
function folderOfThree() {
  return dirname(dirname(createRequire(import.meta.url).resolve("three")));
}

/** Whole modules of three/src, and what stands in for them. */
const stubs = {
  // Headsets.
  "renderers/webxr/WebXRManager.js": `export class WebXRManager {
    enabled = false;
    isPresenting = false;
    addEventListener() {}
    removeEventListener() {}
    getEnvironmentBlendMode() {}
    setAnimationLoop() {}
    dispose() {}
  }`,
  // Reflections of an environment.
  "renderers/webgl/WebGLEnvironments.js": `export class WebGLEnvironments {
    get() { return null; }
    dispose() {}
  }`,
  // Uniform buffers that materials of one's own may share.
  "renderers/webgl/WebGLUniformsGroups.js": `export function WebGLUniformsGroups() {
    return { bind() {}, update() {}, dispose() {} };
  }`,
  // Shapes that pass into others on the graphics card; ours do so before.
  "renderers/webgl/WebGLMorphtargets.js": `export function WebGLMorphtargets() {
    return { update() {} };
  }`,
  // A way of tone mapping that must be asked for.
  "renderers/webgl/WebGLOutput.js": "export class WebGLOutput {}",
};

/** Shaders of materials and effects that are not here, and parts that an #ifdef switches on for them. */
const unused = [
  ..."background backgroundCube cube distance equirect linedashed meshlambert meshmatcap".split(" "),
  ..."meshnormal meshphong meshtoon points sprite vsm".split(" "),
  ..."transmission_.* iridescence_.* clearcoat_.* cube_uv_.* envmap_.* lightmap_.* aomap_.*".split(" "),
  ..."skin.* morph.* batching_.* fog_.* bumpmap_.* displacementmap_.* emissivemap_.* gradientmap_.*".split(
    " ",
  ),
];
const unusedShader = new RegExp(`/(${unused.join("|")})\\.glsl\\.js$`);

/** Methods that nothing here calls: objects as JSON and back, and what a ray meets (ours is asked of the plant, not of its mesh). */
const unusedMethods = /\n\t(?:toJSON|fromJSON|raycast)\([\s\S]*?\n\t}\n/g;

/** @returns {import("vite").Plugin} */
export function leanThree() {
  const source = join(folderOfThree(), "src");
  return {
    name: "bough-lean-three",
    enforce: "pre",
    apply: "build",
    buildStart() {
      const gone = Object.keys(stubs).filter((path) => !existsSync(join(source, path)));
      if (gone.length > 0) this.error(`three has no ${gone.join(", ")} any more: look what replaces it.`);
    },
    resolveId: (id) => (id === "three" ? join(source, "Three.js") : null),
    load(file) {
      const path = relative(source, file);
      if (Object.hasOwn(stubs, path)) return stubs[/** @type {keyof typeof stubs} */ (path)];
      if (path.startsWith("..") || !file.endsWith(".js")) return null;
      if (!file.endsWith(".glsl.js")) return readFileSync(file, "utf8").replace(unusedMethods, "\n");
      const shader = unusedShader.test(file) ? () => "" : shortened;
      return readFileSync(file, "utf8").replace(/`([^`]*)`/g, (_, text) => `\`${shader(text)}\``);
    },
  };
}

/**
 * Without comments and indentation. Lines stay as they are: our own materials look for some of them.
 * @param {string} shader
 */
function shortened(shader) {
  const bare = shader.replace(/\/\*[\s\S]*?\*\/|\/\/.*/g, "");
  return `${bare
    .split("\n")
    .map((line) => line.trim())
    .filter(Boolean)
    .join("\n")}\n`;
}
