import { ShaderChunk } from 'three'
import { FurrowError } from '../core/error.ts'
import { MAX_LAYERS } from '../core/limits.ts'
import type { LayerKind } from '../core/types.ts'

/** Declares what the wrinkles read, and sums the areas: the paper's step 3, for every layer at once. */
const INFLUENCE = /* glsl */ `
uniform highp sampler2DArray furrowAreas;
uniform highp sampler2D furrowActivations;
uniform int furrowAreaCount;

vec4 furrowInfluence(vec2 uv) {
  vec4 added = vec4(0.0);
  vec4 largest = vec4(0.0);
  for (int i = 0; i < furrowAreaCount; i++) {
    float weight = textureLod(furrowAreas, vec3(uv, float(i)), 0.0).r;
    added += weight * texelFetch(furrowActivations, ivec2(i, 0), 0);
    largest = max(largest, weight * texelFetch(furrowActivations, ivec2(i, 1), 0));
  }
  return max(min(added, 1.0), largest);
}
`

/** Reoriented normal mapping, see \`reorientNormal\` in the reference. */
const REORIENT = /* glsl */ `
vec3 furrowReorient(vec3 base, vec3 detail) {
  vec3 t = base + vec3(0.0, 0.0, 1.0);
  vec3 r = detail * vec3(-1.0, -1.0, 1.0);
  return t * (dot(t, r) / t.z) - r;
}
`

/**
 * Makes a built-in material's fragment shader mix the layers' normals into its own before it lights them.
 * What \`mixNormals\` in the reference does, except that the last normalisation is left to the material.
 */
export function defaultFragment(fragment: string, kinds: readonly LayerKind[]): string {
  const share = (layer: number) => `influence[${layer}]`
  const sample = (layer: number) => `(texture(furrowNormals, vec3(uv, ${layer}.0)).xyz * 2.0 - 1.0)`
  const replacing = indicesOf(kinds, 'replace')
  const details = indicesOf(kinds, 'detail')
  const declared = kinds.map((_, layer) => `vec3 n${layer} = ${sample(layer)};`)
  const replaced = replacing.map((layer) => ` + (n${layer} - base) * ${share(layer)} / total`)
  const slope = details.map((layer) => `n${layer}.xy / n${layer}.z * ${share(layer)}`).join(' + ')
  const reoriented = `
  float showing = ${details.map(share).join(' + ')};
  if (showing > 0.0) normal = furrowReorient(normalize(normal), normalize(vec3(${slope}, 1.0)));`
  const mixNormals = /* glsl */ `
uniform highp sampler2DArray furrowNormals;

vec3 furrowMixNormals(vec3 base, vec2 uv) {
  vec4 influence = furrowInfluence(uv);
  ${declared.join('\n  ')}
  float total = max(1.0, ${[...replacing.map(share), '0.0'].join(' + ')});
  vec3 normal = base${replaced.join('')};${details.length > 0 ? reoriented : ''}
  return normal;
}
`
  const maps = edit(
    ShaderChunk.normal_fragment_maps,
    'mapN.xy *= normalScale;',
    'mapN = furrowMixNormals(mapN, vNormalMapUv);\n\tmapN.xy *= normalScale;',
  )
  const declarations = INFLUENCE + (details.length > 0 ? REORIENT : '') + mixNormals
  return edit(edit(fragment, 'void main() {', `${declarations}\nvoid main() {`), NORMAL_MAPS, maps)
}

/**
 * The paper's shader on a built-in material: light with smooth normals, light again with wrinkled ones, mix
 * the two colours by the influence. The material's own text between its first lighting chunk and its output
 * is run twice, so any of three.js's lit materials will do.
 *
 * @param diffuseIsSrgb whether the diffuse layer of the array, sampled as stored, is still to be decoded.
 */
export function paperFragment(fragment: string, diffuseIsSrgb: boolean): string {
  const lighting = lightingOf(fragment)
  const maps = edit(
    ShaderChunk.normal_fragment_maps,
    'vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;',
    /* glsl */ `
  vec3 furrowWrinkled = texture(furrowColours, vec3(vNormalMapUv, 2.0)).xyz * 2.0 - 1.0;
  furrowWrinkled.xy *= normalScale;
  furrowWrinkled = normalize(tbn * furrowWrinkled);
  vec3 mapN = texture(furrowColours, vec3(vNormalMapUv, 1.0)).xyz * 2.0 - 1.0;`,
  )
  const twice = /* glsl */ `${lighting}
  vec3 furrowLit = outgoingLight;
  {
    normal = furrowWrinkled;
    reflectedLight = ReflectedLight(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    #ifdef USE_CLEARCOAT
      clearcoatSpecularDirect = vec3(0.0);
      clearcoatSpecularIndirect = vec3(0.0);
    #endif
    #ifdef USE_SHEEN
      sheenSpecularDirect = vec3(0.0);
      sheenSpecularIndirect = vec3(0.0);
    #endif
    ${lighting}
    furrowLit = mix(furrowLit, outgoingLight, furrowInfluence(vNormalMapUv).x);
  }
  outgoingLight = furrowLit;
`
  const stored = 'texture(furrowColours, vec3(vNormalMapUv, 0.0))'
  const diffuse = `diffuseColor *= ${diffuseIsSrgb ? `sRGBTransferEOTF(${stored})` : stored};`
  const declarations = `${INFLUENCE}\nuniform highp sampler2DArray furrowColours;\n`
  return [
    ['void main() {', `${declarations}\nvoid main() {`],
    ['#include <map_fragment>', diffuse],
    [NORMAL_MAPS, maps],
    [lighting, twice],
  ].reduce((text, [find, put]) => edit(text, find, put), fragment)
}

/** Makes an unlit material show the largest influence of any layer as gray. */
export function influenceFragment(fragment: string): string {
  const shown = /* glsl */ `
  vec4 furrowShares = furrowInfluence(vUv);
  diffuseColor.rgb = vec3(max(max(furrowShares.x, furrowShares.y), max(furrowShares.z, furrowShares.w)));`
  const declared = edit(fragment, 'void main() {', `${INFLUENCE}\nvoid main() {`)
  return edit(declared, '#include <map_fragment>', shown)
}

const NORMAL_MAPS = '#include <normal_fragment_maps>'
const OUTPUT = '#include <opaque_fragment>'

function lightingOf(fragment: string): string {
  const body = fragment.indexOf('void main() {')
  const start = body + fragment.slice(body).search(/#include <lights_\w+_fragment>/)
  const end = fragment.indexOf(OUTPUT)
  if (start < body || end < 0) throw unpatchable('#include <lights_..._fragment>')
  return fragment.slice(start, end)
}

function indicesOf(kinds: readonly LayerKind[], kind: LayerKind): number[] {
  return kinds.slice(0, MAX_LAYERS).flatMap((own, layer) => (own === kind ? [layer] : []))
}

function edit(text: string, find: string, put: string): string {
  if (!text.includes(find)) throw unpatchable(find)
  return text.replace(find, () => put)
}

function unpatchable(find: string): FurrowError {
  return new FurrowError({
    who: 'Wrinkles',
    what: 'material whose shader cannot be patched, it lacks',
    value: find,
    limit: "three.js's built-in lit materials, r180 or later",
    remedy: 'use one of them, or set the mode to "off"',
  })
}
