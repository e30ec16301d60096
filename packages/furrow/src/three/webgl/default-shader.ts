import { ShaderChunk } from 'three'
import type { Instances } from '../instances.ts'
import type { ValueKind } from '../material/wrinkle-textures.ts'
import { requireInternal } from '../three-version.ts'
import { CORNER_OF_INSTANCE, influenceFromMap } from './influence-glsl.ts'
import {
  BLOOD_COLOUR,
  MICRO_SHADOW,
  type NormalLayers,
  normalMixing,
  TOON_COLOUR,
  type ValueLayers,
  valueMixing,
  valueReading,
} from './mixing-glsl.ts'
import { includeOf, MAIN, replace, replaceChunk, unpatchable } from './shader-text.ts'

/** What a program depends on: never the number of areas. */
export interface ShaderVariant extends NormalLayers {
  /** The layers' other maps, by kind. */
  values: Readonly<Partial<Record<ValueKind, ValueLayers>>>
  instances: Instances
  /** Whether the layers' maps are sampled with anisotropy. */
  anisotropic: boolean
  /** Whether the material lights in steps, and so shows wrinkles as lines too. */
  isToon: boolean
}

/**
 * Makes a material's fragment shader mix the layers' maps into its own before it lights them: `mixNormals` and `mixValues` of the
 * reference, except that the last normalisation is left to the material. The shader is one of three.js's, as the user may have edited
 * it, or another that reads its normal map as these do, such as MToon's. Such a one shows the layers' normals only: it need not
 * have the texture coordinates before its other maps are read.
 *
 * @throws FurrowError when it reads its normal map in another way, or not at all.
 */
export function defaultFragment(fragment: string, variant: ShaderVariant): string {
  const shader = replaceChunk(fragment, 'normal_fragment_maps')
  const [, uv] = shader.match(MAP_READ) ?? []
  const [scaled, normal] = shader.match(NORMAL_SCALED) ?? []
  if (!uv || !scaled) throw unpatchable(uv ? NORMAL_SCALED.source : MAP_READ.source)
  const { kinds, instances, anisotropic, isToon } = variant
  const isBuiltIn = uv === BUILT_IN_UV
  const values = isBuiltIn ? variant.values : {}
  const hasValues = Object.keys(values).length > 0
  const declarations = [
    influenceFromMap(kinds.length, instances !== null, anisotropic),
    normalMixing(variant),
    isToon ? TOON_COLOUR : '',
    hasValues ? valueReading(values) : '',
    ...Object.entries(values).map(([kind, layers]) => valueMixing(kind as ValueKind, layers)),
    values.occlusion ? MICRO_SHADOW : '',
    values.blood ? BLOOD_COLOUR : '',
  ].join('')
  const sample = `furrowSampleInfluence(${uv});`
  const mixed = [
    isBuiltIn ? '' : sample,
    `vec3 furrowOwn = ${normal};`,
    `${normal} = furrowMixNormals(furrowOwn);`,
    isToon ? `diffuseColor.rgb = furrowToonColour(diffuseColor.rgb, furrowOwn, ${normal});` : '',
    scaled,
  ].join('\n\t')
  const started = [
    declarations,
    MAIN,
    isBuiltIn ? `\t${sample}` : '',
    hasValues ? '\tfurrowReadValues();' : '',
    values.occlusion ? '\tfurrowVisibility = furrowMix_occlusion( 1.0 );' : '',
  ].join('\n')
  return mixOthers(replace(replace(shader, scaled, mixed), MAIN, started), values)
}

/** Whether `defaultFragment` can edit a shader. */
export function isPatchable(fragment: string): boolean {
  const shader = replaceChunk(fragment, 'normal_fragment_maps')
  return MAP_READ.test(shader) && NORMAL_SCALED.test(shader) && shader.includes(MAIN)
}

/** How three.js's `normal_fragment_maps`, and the shaders made after it, read the normal map: the texture coordinates ... */
const MAP_READ = /texture2D\( *normalMap, *(\w+) *\)/

/** ... and the normal in tangent space. */
const NORMAL_SCALED = /\b(\w+)\.xy \*= normalScale;/

/** Texture coordinates that three.js passes from the vertex shader. */
const BUILT_IN_UV = 'vNormalMapUv'

/** Passes the corner of the instance's cell from the vertex shader to the fragment shader. */
export function instancedVertex(vertex: string, instances: 'instanced' | 'batched'): string {
  const declarations = `${CORNER_OF_INSTANCE}flat out highp vec2 vFurrowCorner;`
  const corner = `vFurrowCorner = furrowCornerOf(${instanceIndex(instances)});`
  return replace(vertex, MAIN, `${declarations}\n${MAIN}\n\t${corner}`)
}

function instanceIndex(instances: 'instanced' | 'batched'): string {
  if (instances === 'instanced') return 'float(gl_InstanceID)'
  // A batch draws its visible instances in an order of its own.
  const [call] = ShaderChunk.batching_pars_vertex.match(/getIndirectIndex(?=\()/) ?? []
  return `${requireInternal(call, 'Wrinkles', 'getIndirectIndex in batching_pars_vertex')}(gl_DrawID)`
}

/** Mixes into the material's own maps where it reads them; without a map its own value is 1. */
function mixOthers(
  fragment: string,
  { baseColor, roughness, occlusion, blood }: ShaderVariant['values'],
): string {
  let shader = fragment
  // Before the edit below, which replaces the include.
  if (blood) {
    shader = shader.replace(
      includeOf('map_fragment'),
      (include) => `${include}\n\tdiffuseColor.rgb = furrowBloodColour( diffuseColor.rgb );`,
    )
  }
  if (baseColor) {
    shader = replaceChunk(shader, 'map_fragment', (chunk) => {
      const withMap = replace(
        chunk,
        'diffuseColor *= sampledDiffuseColor;',
        'sampledDiffuseColor.rgb = furrowMix_baseColor( sampledDiffuseColor.rgb );\n\tdiffuseColor *= sampledDiffuseColor;',
      )
      return `${withMap}\n#ifndef USE_MAP\n\tdiffuseColor.rgb *= furrowMix_baseColor( vec3( 1.0 ) );\n#endif\n`
    })
  }
  if (roughness) {
    shader = replaceChunk(shader, 'roughnessmap_fragment', (chunk) => {
      const withMap = replace(
        chunk,
        'roughnessFactor *= texelRoughness.g;',
        'roughnessFactor *= furrowMix_roughness( texelRoughness.g );',
      )
      return `${withMap}\n#ifndef USE_ROUGHNESSMAP\n\troughnessFactor *= furrowMix_roughness( 1.0 );\n#endif\n`
    })
  }
  if (occlusion) {
    shader = replaceChunk(shader, 'aomap_fragment', (chunk) => {
      const sample = 'texture2D( aoMap, vAoMapUv ).r'
      const withMap = replace(chunk, sample, `furrowMix_occlusion( ${sample} )`)
      const scaled = `( ${sample} - 1.0 ) * aoMapIntensity + 1.0`
      const withoutMap = replace(chunk, scaled, 'furrowVisibility')
      return `${withMap}\n${replace(withoutMap, '#ifdef USE_AOMAP', '#ifndef USE_AOMAP')}`
    })
    for (const name of ['lights_physical_pars_fragment', 'lights_phong_pars_fragment'] as const) {
      shader = replaceChunk(shader, name, shadowHighlights)
    }
  }
  return shader
}

/** Highlights of lights are shadowed by the layers' occlusion; those of the surroundings are by three.js. */
function shadowHighlights(chunk: string): string {
  const highlight = 'reflectedLight.directSpecular += irradiance *'
  return `float furrowMicroShadow( float cosine );\n${replace(chunk, highlight, `${highlight} furrowMicroShadow( dotNL ) *`)}`
}
