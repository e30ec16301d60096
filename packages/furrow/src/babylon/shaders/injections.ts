import type { ValueKind } from '../../runtime/layer-maps.ts'
import { type Dialect, GLSL, WGSL } from './dialect.ts'
import { type MixedLayers, mixing } from './mixing.ts'

/** Materials whose shaders can be patched. */
export type ShaderKind = 'pbr' | 'standard'

/** Code for a Babylon.js shader. A key is an injection point, or `!` and a regular expression whose match the code replaces. */
export type Injections = Record<string, string>

/** Passes the cell of an instance to the fragment shader. */
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
 * Mixes the layers' maps into the material's own where the shader reads them, before lighting. Without a map the material's value is 1.
 */
export function fragmentInjections(kind: ShaderKind, isWgsl: boolean, layers: MixedLayers): Injections {
  const d = isWgsl ? WGSL : GLSL
  const injections = kind === 'pbr' ? pbr(d, layers.values) : standard(d, layers.values)
  injections.CUSTOM_FRAGMENT_DEFINITIONS = mixing(d, layers)
  for (const texel of texels(d, 'bump', 'Bump')) {
    // Includes the next character to make keys unique: Babylon.js 8 replaces only the first of several equal texts.
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
    // The occlusion of a material without a map would also darken direct light; a map's does not.
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

/** Injections for StandardMaterial, which computes in sRGB and has no roughness. */
function standard(d: Dialect, { baseColor, occlusion, blood }: Values): Injections {
  const { vec3, vec4 } = d
  const [toLinear, toGamma] = d.isWgsl
    ? ['toLinearSpaceVec3', 'toGammaSpaceVec3']
    : ['toLinearSpace', 'toGammaSpace']
  const one = `${vec3}(1.0)`
  /** Converts to linear only under wrinkles, so that colours elsewhere stay bit-exact. */
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

/** Expressions by which Babylon.js reads a map: a macro in newer releases, a plain function call in 8 and 9.0. */
function texels({ isWgsl, passed }: Dialect, map: string, name: string): string[] {
  const textures = isWgsl ? `${map}Sampler,${map}SamplerSampler` : `${map}Sampler`
  const functions = ['TEXRD', isWgsl ? 'textureSample' : 'texture2D']
  return functions.map((read) => `${read}(${textures},${passed(`v${name}UV`)}+uvOffset)`)
}

/** Injection key that replaces a text of the shader. */
function replacing(text: string): string {
  return `!${text.replace(/[\\^$.*+?()[\]{}|]/g, '\\$&')}`
}
