import type { ValueKind } from '../../runtime/maps/layer-maps.ts'
import { type Dialect, GLSL, WGSL } from './dialect.ts'
import { type MixedLayers, mixing } from './mixing.ts'

/** Material types whose shaders can be patched. */
export type ShaderKind = 'pbr' | 'standard'

/**
 * Code that a material plugin of Babylon.js adds to a shader. A key names an injection point of the shader. If the key begins with `!`,
 * the rest of the key is a regular expression, and the code replaces its match.
 */
export type Injections = Record<string, string>

/** Returns code that passes the index of an instance's atlas cell to the fragment shader. */
export function vertexInjections(isWgsl: boolean): Injections {
  const declared = isWgsl
    ? 'attribute furrowCell: f32;\nvarying vFurrowCell: f32;'
    : 'attribute float furrowCell;\nvarying float vFurrowCell;'
  const passed = isWgsl ? 'vertexOutputs.vFurrowCell = vertexInputs.furrowCell;' : 'vFurrowCell = furrowCell;'
  return {
    CUSTOM_VERTEX_DEFINITIONS: `#ifdef FURROW_CELLS\n${declared}\n#endif`,
    CUSTOM_VERTEX_MAIN_BEGIN: `#ifdef FURROW_CELLS\n${passed}\n#endif`,
  }
}

/**
 * Returns code that mixes the layers' maps into the material's maps before lighting. If the material has no map of a kind, layers are mixed
 * into the value 1.
 */
export function fragmentInjections(kind: ShaderKind, isWgsl: boolean, layers: MixedLayers): Injections {
  const d = isWgsl ? WGSL : GLSL
  const injections = kind === 'pbr' ? pbr(d, layers.values) : standard(d, layers.values)
  injections.CUSTOM_FRAGMENT_DEFINITIONS = mixing(d, layers)
  for (const texel of texels(d, 'bump', 'Bump')) {
    // The shader may read the normal map several times. Babylon.js 8 replaces only the first match of each key, so keys include the next
    // character to tell these reads apart.
    for (const next of [',', '*']) {
      injections[replacing(`${texel}.xyz${next}`)] =
        `furrowMixNormals(${texel}.xyz,${d.passed('vBumpUV')}+uvOffset)${next}`
    }
  }
  return injections
}

type Values = Readonly<Partial<Record<ValueKind, unknown>>>

function pbr(d: Dialect, { baseColor, roughness, occlusion, blood }: Values): Injections {
  const { vec3 } = d
  const toLinear = d.isWgsl ? 'toLinearSpaceVec3' : 'toLinearSpace'
  const one = `${vec3}(1.0)`
  const injections: Injections = {}
  if (baseColor) {
    for (const texel of [`${toLinear}(albedoTexture.rgb)`, 'albedoTexture.rgb']) {
      injections[replacing(`surfaceAlbedo*=${texel};`)] = `surfaceAlbedo*=furrowMix_baseColor(${texel});`
    }
  }
  injections.CUSTOM_FRAGMENT_UPDATE_ALBEDO = [
    baseColor ? `#ifndef ALBEDO\nsurfaceAlbedo*=furrowMix_baseColor(${one});\n#endif` : '',
    blood ? 'surfaceAlbedo=furrowBloodColour(surfaceAlbedo);' : '',
  ].join('\n')
  if (roughness) {
    const map = 'surfaceMetallicOrReflectivityColorMap'
    for (const channel of ['a', 'g']) {
      injections[replacing(`metallicRoughness.g*=${map}.${channel};`)] =
        `metallicRoughness.g*=furrowMix_roughness(${vec3}(${map}.${channel})).x;`
    }
    injections.CUSTOM_FRAGMENT_UPDATE_METALLICROUGHNESS = `
#if !defined(REFLECTIVITY) || !defined(ROUGHNESSSTOREINMETALMAPALPHA) && !defined(ROUGHNESSSTOREINMETALMAPGREEN)
metallicRoughness.g*=furrowMix_roughness(${one}).x;
#endif`
  }
  if (occlusion) {
    injections.CUSTOM_FRAGMENT_BEFORE_LIGHTS = `furrowVisibility = furrowMix_occlusion(${one}).x;`
    for (const texel of texels(d, 'ambient', 'Ambient')) {
      injections[replacing(`${texel}.rgb;`)] = `furrowMix_occlusion(${texel}.rgb);`
    }
    const unoccluded = d.isWgsl
      ? 'var ambientOcclusionColor: vec3f= vec3f(1.,1.,1.);'
      : 'vec3 ambientOcclusionColor=vec3(1.,1.,1.);'
    injections[replacing(unoccluded)] =
      `${unoccluded}\n#ifndef AMBIENT\nambientOcclusionColor=${vec3}(furrowVisibility);\n#endif`
    // Without an occlusion map, Babylon.js would apply the mixed occlusion to direct light too. It must darken only ambient light, as with a map.
    const direct = d.isWgsl
      ? 'var ambientOcclusionForDirectDiffuse: vec3f='
      : 'vec3 ambientOcclusionForDirectDiffuse='
    const original = `${direct}aoOut.ambientOcclusionColor;`
    injections[replacing(original)] = `
#ifdef AOSTOREINMETALMAPRED
${original}
#else
${direct}${one};
#endif`
    for (const factors of ['shadow', 'shadow*lightmapColor.rgb']) {
      injections[replacing(`specularBase+=info.specular*${factors};`)] =
        `specularBase+=info.specular*furrowMicroShadow(preInfo.NdotL)*${factors};`
    }
  }
  return injections
}

/** Returns code for `StandardMaterial`, which computes in sRGB and has no roughness. */
function standard(d: Dialect, { baseColor, occlusion, blood }: Values): Injections {
  const { vec3, vec4 } = d
  const [toLinear, toGamma] = d.isWgsl
    ? ['toLinearSpaceVec3', 'toGammaSpaceVec3']
    : ['toLinearSpace', 'toGammaSpace']
  const one = `${vec3}(1.0)`
  /** Applies a change in linear RGB. Where no wrinkle is visible, the colour is not converted, so that rounding does not change it. */
  const inLinear = (change: string) =>
    `if (dot(furrowInfluence, ${vec4}(1.0)) > 0.0) { baseColor=${vec4}(${toGamma}(${change}(${toLinear}(baseColor.rgb))),baseColor.a); }`
  const injections: Injections = {}
  if (baseColor) {
    for (const texel of texels(d, 'diffuse', 'Diffuse')) {
      injections[replacing(`baseColor=${texel};`)] = `baseColor=${texel};\n${inLinear('furrowMix_baseColor')}`
    }
  }
  injections.CUSTOM_FRAGMENT_UPDATE_DIFFUSE = [
    baseColor
      ? `#ifndef DIFFUSE\nbaseColor=${vec4}(baseColor.rgb*${toGamma}(furrowMix_baseColor(${one})),baseColor.a);\n#endif`
      : '',
    blood ? inLinear('furrowBloodColour') : '',
  ].join('\n')
  if (occlusion) {
    for (const texel of texels(d, 'ambient', 'Ambient')) {
      injections[replacing(`${texel}.rgb*`)] = `furrowMix_occlusion(${texel}.rgb)*`
    }
    injections.CUSTOM_FRAGMENT_BEFORE_LIGHTS = `#ifndef AMBIENT\nbaseAmbientColor=furrowMix_occlusion(${one});\n#endif`
  }
  return injections
}

/** Returns the expressions by which Babylon.js may read a map. Newer releases use the macro `TEXRD`; releases 8 and 9.0 call a function. */
function texels({ isWgsl, passed }: Dialect, map: string, name: string): string[] {
  const textures = isWgsl ? `${map}Sampler,${map}SamplerSampler` : `${map}Sampler`
  const functions = ['TEXRD', isWgsl ? 'textureSample' : 'texture2D']
  return functions.map((read) => `${read}(${textures},${passed(`v${name}UV`)}+uvOffset)`)
}

/** Returns an injection key that replaces a text of the shader. */
function replacing(text: string): string {
  return `!${text.replace(/[\\^$.*+?()[\]{}|]/g, '\\$&')}`
}
