import { REVISION, ShaderChunk } from 'three'
import { requireInternal } from '../../three-version.ts'
import {
  CORNER_OF_INSTANCE,
  influenceFromMap,
  type SampledCell,
  type SliceSampling,
  sliceSampling,
} from '../influence/influence.ts'
import { MAIN, replace, replaceChunk } from '../patch/shader-text.ts'
import { addValues } from './add-values.ts'
import { type NormalLayers, normalMixing } from './mix-normals.ts'
import type { Values } from './value-layers.ts'

/** Parameters of a shader program. Independent of the number of areas. */
export interface ShaderVariant extends NormalLayers {
  /** Value maps of the layers, by kind. */
  values: Values
  cell: SampledCell
  /** Whether texture coordinates leave 0..1, and so wrap. */
  isTiled: boolean
  sampling: SliceSampling
  /** Whether the material has toon shading, and so shows wrinkles as lines too. */
  isToon: boolean
}

/**
 * Patches a fragment shader to mix the layers' maps into the material's before lighting: `mixNormals` and `mixValues` of the reference,
 * without the final normalisation. Supports three.js's shaders, also when edited by the user, and others that read the normal map the same
 * way, such as MToon. The latter show normals only, because they may read other maps before the texture coordinates are known.
 *
 * @throws Error if the shader does not read its normal map like three.js.
 */
export function defaultFragment(fragment: string, variant: ShaderVariant): string {
  const shader = replaceChunk(fragment, 'normal_fragment_maps')
  const [, uv] = shader.match(MAP_READ) ?? []
  const [scaled, normal] = shader.match(NORMAL_SCALED) ?? []
  if (!uv || !scaled) throw new Error((uv ? NORMAL_SCALED : MAP_READ).source)
  const { kinds, cell, isTiled, sampling } = variant
  const isBuiltIn = uv === BUILT_IN_UV
  const values = isBuiltIn ? variant.values : {}
  const added = addValues(values, { ...variant, normal })
  const influence = influenceFromMap(kinds.length, cell, isTiled)
  const sample = `furrowSampleInfluence(${uv});`
  const mixed = [
    isBuiltIn ? '' : sample,
    `vec3 furrowOwn = ${normal};`,
    `${normal} = furrowMixNormals(furrowOwn);`,
    added.tint,
    scaled,
  ].join('\n\t')
  const declarations = [influence, sliceSampling(sampling), normalMixing(variant), added.declarations]
  const started = [...declarations, MAIN, isBuiltIn ? sample : '', added.begin].join('\n')
  const shown = replace(replace(shader, scaled, mixed), MAIN, started)
  return added.mixOthers(shown)
}

/** Whether `defaultFragment` can patch a shader. */
export function isPatchable(fragment: string): boolean {
  const shader = replaceChunk(fragment, 'normal_fragment_maps')
  return MAP_READ.test(shader) && NORMAL_SCALED.test(shader) && shader.includes(MAIN)
}

/** Sample of the normal map in three.js's `normal_fragment_maps` and shaders modelled on it; captures the texture coordinates. */
const MAP_READ = /texture2D\( *normalMap, *(\w+) *\)/

/** Scaling of the tangent-space normal in the same chunk; captures its variable. */
const NORMAL_SCALED = /\b(\w+)\.xy \*= normalScale;/

/** Varying with three.js's texture coordinates of the normal map. */
const BUILT_IN_UV = 'vNormalMapUv'

/** Patches a vertex shader to pass the corner of the instance's cell to the fragment shader. */
export function instancedVertex(vertex: string, instances: 'instanced' | 'batched'): string {
  const declarations = `${CORNER_OF_INSTANCE}flat out highp vec2 vFurrowCorner;`
  const corner = `vFurrowCorner = furrowCornerOf(${instanceIndex(instances)});`
  return replace(vertex, MAIN, `${declarations}\n${MAIN}\n\t${corner}`)
}

function instanceIndex(instances: 'instanced' | 'batched'): string {
  if (instances === 'instanced') return 'float(gl_InstanceID)'
  const chunk = ShaderChunk.batching_pars_vertex
  // Up to three.js r165 each vertex of a batch has an instance index.
  if (chunk.includes('attribute float batchId;')) return 'batchId'
  // Later releases reorder the visible instances.
  const [call] = chunk.match(/getIndirectIndex(?=\()/) ?? []
  return `${requireInternal(call, 'Wrinkles', 'getIndirectIndex in batching_pars_vertex', REVISION)}(gl_DrawID)`
}
