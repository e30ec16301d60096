import { ShaderChunk } from 'three'
import type { Instances } from '../instances.ts'
import type { ValueKind } from '../material/wrinkle-textures.ts'
import { requireInternal } from '../three-version.ts'
import { influenceFromMap } from './influence-glsl.ts'
import { type NormalLayers, normalMixing, type ValueLayers, valueMixing } from './mixing-glsl.ts'
import { BASE_COLOR_MAP, MAIN, NORMAL_MAPS, replace } from './shader-text.ts'

/** What a program depends on: never the number of areas. */
export interface ShaderVariant extends NormalLayers {
  /** The layers' other maps, by kind. */
  values: Readonly<Partial<Record<ValueKind, ValueLayers>>>
  instances: Instances
  /** Whether the layers' maps are sampled with anisotropy. */
  anisotropic: boolean
}

/**
 * Makes a built-in material's fragment shader mix the layers' maps into its own before it lights them: `mixNormals`
 * and `mixValues` of the reference, except that the last normalisation is left to the material.
 */
export function defaultFragment(fragment: string, variant: ShaderVariant): string {
  const { kinds, instances, anisotropic, values } = variant
  const declarations = [
    influenceFromMap(kinds.length, instances !== null, anisotropic),
    normalMixing(variant),
    ...Object.entries(values).map(([kind, layers]) => valueMixing(kind as ValueKind, layers)),
  ]
  const normals = replace(
    ShaderChunk.normal_fragment_maps,
    'mapN.xy *= normalScale;',
    'mapN = furrowMixNormals(mapN);\n\tmapN.xy *= normalScale;',
  )
  const started = replace(
    fragment,
    MAIN,
    `${declarations.join('')}\n${MAIN}\n\tfurrowSampleInfluence(vNormalMapUv);`,
  )
  const chunks: Chunk[] = [[NORMAL_MAPS, normals], ...valueChunks(variant, fragment)]
  return chunks.reduce((text, [include, chunk]) => replace(text, include, chunk), started)
}

/** Passes the index of the instance from the vertex shader to the fragment shader. */
export function instancedVertex(vertex: string, instances: 'instanced' | 'batched'): string {
  const varying = 'flat out float vFurrowInstance;'
  return replace(vertex, MAIN, `${varying}\n${MAIN}\n\tvFurrowInstance = ${instanceIndex(instances)};`)
}

function instanceIndex(instances: 'instanced' | 'batched'): string {
  if (instances === 'instanced') return 'float(gl_InstanceID)'
  // A batch draws its visible instances in an order of its own.
  const [call] = ShaderChunk.batching_pars_vertex.match(/getIndirectIndex(?=\()/) ?? []
  return `${requireInternal(call, 'Wrinkles', 'getIndirectIndex in batching_pars_vertex')}(gl_DrawID)`
}

/** An `#include` and the text that replaces it. */
type Chunk = [include: string, chunk: string]

/** The chunks that read the material's own maps, with the mixed value in place of the map's; without a map its own value is 1. */
function valueChunks({ values }: ShaderVariant, fragment: string): Chunk[] {
  const chunks: Chunk[] = []
  if (values.baseColor) {
    const withMap = replace(
      ShaderChunk.map_fragment,
      'diffuseColor *= sampledDiffuseColor;',
      'sampledDiffuseColor.rgb = furrowMix_baseColor( sampledDiffuseColor.rgb );\n\tdiffuseColor *= sampledDiffuseColor;',
    )
    const withoutMap = 'diffuseColor.rgb *= furrowMix_baseColor( vec3( 1.0 ) );'
    chunks.push([BASE_COLOR_MAP, `${withMap}\n#ifndef USE_MAP\n\t${withoutMap}\n#endif\n`])
  }
  // Only standard and physical materials have a roughness.
  if (values.roughness && fragment.includes(ROUGHNESS_MAP)) {
    const withMap = replace(
      ShaderChunk.roughnessmap_fragment,
      'roughnessFactor *= texelRoughness.g;',
      'roughnessFactor *= furrowMix_roughness( texelRoughness.g );',
    )
    const withoutMap = 'roughnessFactor *= furrowMix_roughness( 1.0 );'
    chunks.push([ROUGHNESS_MAP, `${withMap}\n#ifndef USE_ROUGHNESSMAP\n\t${withoutMap}\n#endif\n`])
  }
  if (values.occlusion && fragment.includes(OCCLUSION_MAP)) {
    const { aomap_fragment } = ShaderChunk
    const sample = 'texture2D( aoMap, vAoMapUv ).r'
    const withMap = replace(aomap_fragment, sample, `furrowMix_occlusion( ${sample} )`)
    const scaled = `( ${sample} - 1.0 ) * aoMapIntensity + 1.0`
    const withoutMap = replace(aomap_fragment, scaled, 'furrowMix_occlusion( 1.0 )')
    chunks.push([
      OCCLUSION_MAP,
      `${withMap}\n${replace(withoutMap, '#ifdef USE_AOMAP', '#ifndef USE_AOMAP')}`,
    ])
  }
  return chunks
}

const ROUGHNESS_MAP = '#include <roughnessmap_fragment>'
const OCCLUSION_MAP = '#include <aomap_fragment>'
