import { ShaderChunk } from 'three'
import { FurrowError } from '../../core/error.ts'
import type { LayerKind } from '../../core/types.ts'
import type { Instances } from '../instances.ts'
import type { ValueKind } from '../material/wrinkle-textures.ts'
import { influenceFromAreas, influenceFromMap } from './influence-glsl.ts'

/** What a program depends on: never the number of areas. */
export interface ShaderShape {
  kinds: readonly LayerKind[]
  /** Slice of each layer's normals. */
  normals: readonly (number | null)[]
  /** Slice and channel of each layer's other maps; null for a layer without. */
  values: Readonly<Partial<Record<ValueKind, { slices: readonly (number | null)[]; channel: number }>>>
  instances: Instances
  /** Whether the layers' maps are sampled with anisotropy. */
  anisotropic: boolean
}

/** What of it the mixing of normals depends on. */
type NormalShape = Pick<ShaderShape, 'kinds' | 'normals'>

/**
 * Makes a built-in material's fragment shader mix the layers' maps into its own before it lights them: `mixNormals`
 * and `mixValues` of the reference, except that the last normalisation is left to the material.
 */
export function defaultFragment(fragment: string, shape: ShaderShape): string {
  const declared =
    influenceFromMap(shape.kinds.length, shape.instances !== null, shape.anisotropic) + normalMixing(shape)
  const maps = edit(
    ShaderChunk.normal_fragment_maps,
    'mapN.xy *= normalScale;',
    'mapN = furrowMixNormals(mapN);\n\tmapN.xy *= normalScale;',
  )
  const edits: [find: string, put: string][] = [[NORMAL_MAPS, maps], ...valueEdits(shape, fragment)]
  const mixing = Object.keys(shape.values).map((kind) => valueMixing(shape, kind as ValueKind))
  const started = edit(
    fragment,
    'void main() {',
    `${declared}${mixing.join('')}\nvoid main() {\n\tfurrowBegin(vNormalMapUv);`,
  )
  return edits.reduce((text, [find, put]) => edit(text, find, put), started)
}

/** Writes the normals that `defaultFragment` would give a material, as its map would store them; `place` is where. */
export function composedFragment(shape: NormalShape): string {
  return /* glsl */ `${influenceFromMap(shape.kinds.length, false, false)}${normalMixing(shape)}
uniform sampler2D furrowBase;
in vec2 place;
out vec4 composed;

void main() {
  furrowBegin(place);
  vec3 base = textureLod(furrowBase, place, 0.0).xyz * 2.0 - 1.0;
  composed = vec4(furrowMixNormals(base) * 0.5 + 0.5, 1.0);
}
`
}

/** Tells the fragments of a mesh with instances which one they belong to. */
export function instancedVertex(vertex: string, instances: 'instanced' | 'batched'): string {
  // A batch draws what it shows in an order of its own.
  const index = instances === 'instanced' ? 'float(gl_InstanceID)' : 'getIndirectIndex(gl_DrawID)'
  return edit(
    vertex,
    'void main() {',
    `flat out float vFurrowInstance;\nvoid main() {\n\tvFurrowInstance = ${index};`,
  )
}

function normalMixing({ kinds, normals }: NormalShape): string {
  const share = (layer: number) => `furrowShares[${layer}]`
  const sampled = kinds.map(
    (kind, layer) => /* glsl */ `
  vec3 n${layer} = ${kind === 'replace' ? 'base' : 'vec3(0.0, 0.0, 1.0)'};
  if (${share(layer)} > 0.0) {
    n${layer} = furrowMap(furrowNormals, ${normals[layer]}.0).xyz * 2.0 - 1.0;
    n${layer}.xy *= furrowNormalScale[${layer}];
  }`,
  )
  const replacing = indicesOf(kinds, 'replace')
  const details = indicesOf(kinds, 'detail')
  const replaced = replacing.map((layer) => ` + (n${layer} - base) * ${share(layer)} / total`)
  const slope = details.map((layer) => `n${layer}.xy / n${layer}.z * ${share(layer)}`).join(' + ')
  const reoriented = `
  normal = furrowReorient(normalize(normal), normalize(vec3(${slope}, 1.0)));`
  return /* glsl */ `
uniform highp sampler2DArray furrowNormals;
uniform vec4 furrowNormalScale;
${details.length > 0 ? REORIENT : ''}
vec3 furrowMixNormals(vec3 base) {
  if (!furrowShows) return base;${sampled.join('')}
  float total = max(1.0, ${[...replacing.map(share), '0.0'].join(' + ')});
  vec3 normal = base${replaced.join('')};${details.length > 0 ? reoriented : ''}
  return normal;
}
`
}

/** Reoriented normal mapping, see \`reorientNormal\` in the reference. */
const REORIENT = /* glsl */ `
vec3 furrowReorient(vec3 base, vec3 detail) {
  vec3 t = base + vec3(0.0, 0.0, 1.0);
  vec3 r = detail * vec3(-1.0, -1.0, 1.0);
  return t * (dot(t, r) / t.z) - r;
}
`

/** The type of a kind's values, what of a texel they are, and what is done to them. */
const VALUES: Record<ValueKind, { type: string; swizzle: (channel: number) => string; uniform?: string }> = {
  baseColor: { type: 'vec3', swizzle: () => '.rgb' },
  roughness: { type: 'float', swizzle: (channel) => `[${channel}]` },
  occlusion: { type: 'float', swizzle: (channel) => `[${channel}]`, uniform: 'furrowOcclusionStrength' },
}

/** Declares `TYPE furrowMix_KIND(TYPE base)`: `mixValues` of the reference. */
function valueMixing({ values }: ShaderShape, kind: ValueKind): string {
  const { slices, channel } = values[kind]!
  const { type, swizzle, uniform } = VALUES[kind]
  const layers = slices.flatMap((slice, layer) => (slice === null ? [] : [{ slice, layer }]))
  const total = layers.map(({ layer }) => `furrowShares[${layer}]`).join(' + ')
  const mixed = layers.map(({ slice, layer }) => {
    const stored = `furrowMap(furrow_${kind}, ${slice}.0)${swizzle(channel)}`
    const value = uniform ? `mix(1.0, ${stored}, ${uniform}[${layer}])` : stored
    return /* glsl */ `
  if (furrowShares[${layer}] > 0.0) value += (${value} - base) * furrowShares[${layer}] / total;`
  })
  return /* glsl */ `
uniform highp sampler2DArray furrow_${kind};
${uniform ? `uniform vec4 ${uniform};` : ''}
${type} furrowMix_${kind}(${type} base) {
  ${type} value = base;
  if (!furrowShows) return value;
  float total = max(1.0, ${total});${mixed.join('')}
  return value;
}
`
}

/** Where the material reads its own maps, with the mixed value put in; without a map its own value is 1. */
function valueEdits({ values }: ShaderShape, fragment: string): [find: string, put: string][] {
  const edits: [find: string, put: string][] = []
  if (values.baseColor) {
    const chunk = edit(
      ShaderChunk.map_fragment,
      'diffuseColor *= sampledDiffuseColor;',
      'sampledDiffuseColor.rgb = furrowMix_baseColor( sampledDiffuseColor.rgb );\n\tdiffuseColor *= sampledDiffuseColor;',
    )
    const otherwise = 'diffuseColor.rgb *= furrowMix_baseColor( vec3( 1.0 ) );'
    edits.push(['#include <map_fragment>', `${chunk}\n#ifndef USE_MAP\n\t${otherwise}\n#endif\n`])
  }
  // Only standard and physical materials have a roughness.
  if (values.roughness && fragment.includes('#include <roughnessmap_fragment>')) {
    const chunk = edit(
      ShaderChunk.roughnessmap_fragment,
      'roughnessFactor *= texelRoughness.g;',
      'roughnessFactor *= furrowMix_roughness( texelRoughness.g );',
    )
    const otherwise = 'roughnessFactor *= furrowMix_roughness( 1.0 );'
    edits.push([
      '#include <roughnessmap_fragment>',
      `${chunk}\n#ifndef USE_ROUGHNESSMAP\n\t${otherwise}\n#endif\n`,
    ])
  }
  if (values.occlusion && fragment.includes('#include <aomap_fragment>')) {
    const [open, own] = ['#ifdef USE_AOMAP', 'texture2D( aoMap, vAoMapUv ).r']
    const mixed = edit(ShaderChunk.aomap_fragment, own, `furrowMix_occlusion( ${own} )`)
    const bare = edit(
      ShaderChunk.aomap_fragment,
      `( ${own} - 1.0 ) * aoMapIntensity + 1.0`,
      'furrowMix_occlusion( 1.0 )',
    )
    edits.push(['#include <aomap_fragment>', `${mixed}\n${edit(bare, open, '#ifndef USE_AOMAP')}`])
  }
  return edits
}

/**
 * The paper's shader on a built-in material: light with smooth normals, light again with wrinkled ones, mix
 * the two colours by the influence. The material's own text between its first lighting chunk and its output
 * is run twice, so any of three.js's lit materials will do.
 *
 * @param channels of the areas' array.
 * @param diffuseIsSrgb whether the diffuse layer of the array, sampled as stored, is still to be decoded.
 */
export function paperFragment(fragment: string, channels: 1 | 4, diffuseIsSrgb: boolean): string {
  const lighting = lightingOf(fragment)
  const maps = edit(
    ShaderChunk.normal_fragment_maps,
    'vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;',
    /* glsl */ `
  vec3 furrowWrinkled = texture(furrowColours, vec3(furrowRepeat(vNormalMapUv), 2.0)).xyz * 2.0 - 1.0;
  furrowWrinkled.xy *= normalScale;
  furrowWrinkled = normalize(tbn * furrowWrinkled);
  vec3 mapN = texture(furrowColours, vec3(furrowRepeat(vNormalMapUv), 1.0)).xyz * 2.0 - 1.0;`,
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
    furrowLit = mix(furrowLit, outgoingLight, furrowSum(vNormalMapUv).x);
  }
  outgoingLight = furrowLit;
`
  const stored = 'texture(furrowColours, vec3(furrowRepeat(vNormalMapUv), 0.0))'
  const diffuse = `diffuseColor *= ${diffuseIsSrgb ? `sRGBTransferEOTF(${stored})` : stored};`
  const declarations = `${influenceFromAreas(channels)}\nuniform highp sampler2DArray furrowColours;\n`
  return [
    ['void main() {', `${declarations}\nvoid main() {`],
    ['#include <map_fragment>', diffuse],
    [NORMAL_MAPS, maps],
    [lighting, twice],
  ].reduce((text, [find, put]) => edit(text, find, put), fragment)
}

const LARGEST = 'diffuseColor.rgb = vec3(max(max(shares.x, shares.y), max(shares.z, shares.w)));'

/** Makes an unlit material show the largest influence of any layer as gray, from the map. */
export function mapFragment(fragment: string, layers: number, isInstanced: boolean): string {
  const declared = edit(
    fragment,
    'void main() {',
    `${influenceFromMap(layers, isInstanced, false)}\nvoid main() {\n\tfurrowBegin(vMapUv);`,
  )
  return edit(declared, '#include <map_fragment>', `vec4 shares = furrowShares;\n\t${LARGEST}`)
}

/** The same, from the areas themselves. */
export function areasFragment(fragment: string, channels: 1 | 4): string {
  const declared = edit(fragment, 'void main() {', `${influenceFromAreas(channels)}\nvoid main() {`)
  return edit(declared, '#include <map_fragment>', `vec4 shares = furrowSum(vMapUv);\n\t${LARGEST}`)
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
  return kinds.flatMap((own, layer) => (own === kind ? [layer] : []))
}

function edit(text: string, find: string, put: string): string {
  if (!text.includes(find)) throw unpatchable(find)
  return text.replace(find, () => put)
}

function unpatchable(find: string): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who: 'Wrinkles',
    what: 'material whose shader cannot be patched, it lacks',
    value: find,
    limit: "three.js's built-in lit materials, r180 or later",
    remedy: 'use one of them, or set the mode to "off"',
  })
}
