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
import { onsetOf } from './onset.ts'
import type { Values } from './value-layers.ts'

/** Parameters of a patched shader program. The program does not depend on the number of areas. */
export interface ShaderVariant extends NormalLayers {
  values: Values
  cell: SampledCell
  /** Whether texture coordinates may leave 0..1. They are then wrapped into 0..1. */
  isTiled: boolean
  sampling: SliceSampling
  /** Whether the material has toon shading. It then also shows wrinkles as dark lines. */
  isToon: boolean
}

/**
 * Patches a fragment shader to mix the maps of layers into the maps of the material before lighting. The formulas are `mixNormals` and
 * `mixValues` of the reference implementation, without the final normalisation. Supports the shaders of three.js, even if the page edits them,
 * and other shaders that read the normal map in the same way, such as MToon. In shaders that are not from three.js, only normals are mixed.
 * Mixing needs the texture coordinates of the normal map, and such a shader may read its other maps before it computes them.
 *
 * @throws Error if the shader does not read its normal map in the same way as three.js.
 */
export function defaultFragment(fragment: string, variant: ShaderVariant): string {
  const shader = replaceChunk(fragment, 'normal_fragment_maps')
  const [, uv] = shader.match(MAP_READ) ?? []
  const [scaled, normal] = shader.match(NORMAL_SCALED) ?? []
  if (!uv || !scaled) throw new Error((uv ? NORMAL_SCALED : MAP_READ).source)
  const { kinds, cell, isTiled, sampling } = variant
  const isBuiltIn = uv === BUILT_IN_UV
  const values = isBuiltIn ? variant.values : onsetOf(variant.values)
  const added = addValues(values, { ...variant, normal })
  const influence = influenceFromMap(kinds.length, cell, isTiled)
  const sample = `furrowSampleInfluence(${uv});`
  const mixed = [
    isBuiltIn ? '' : [sample, added.begin].join('\n\t'),
    `vec3 furrowOwn = ${normal};`,
    `${normal} = furrowMixNormals(furrowOwn);`,
    added.tint,
    scaled,
  ].join('\n\t')
  const declarations = [influence, sliceSampling(sampling), normalMixing(variant), added.declarations]
  const started = [...declarations, MAIN, ...(isBuiltIn ? [sample, added.begin] : ['', ''])].join('\n')
  const shown = replace(replace(shader, scaled, mixed), MAIN, started)
  return added.mixOthers(shown)
}

/** Whether `defaultFragment` can patch a shader. */
export function isPatchable(fragment: string): boolean {
  const shader = replaceChunk(fragment, 'normal_fragment_maps')
  return MAP_READ.test(shader) && NORMAL_SCALED.test(shader) && shader.includes(MAIN)
}

/** Matches the code in three.js's chunk `normal_fragment_maps` that samples the normal map. Captures the texture coordinates. */
const MAP_READ = /texture2D\( *normalMap, *(\w+) *\)/

/** Matches the code in `normal_fragment_maps` that scales the tangent-space normal. Captures the variable of the normal. */
const NORMAL_SCALED = /\b(\w+)\.xy \*= normalScale;/

/** Texture coordinates of the normal map in the shaders of three.js. */
const BUILT_IN_UV = 'vNormalMapUv'

/** Patches a vertex shader to pass the corner of an instance's cell in the influence atlas to the fragment shader. */
export function instancedVertex(vertex: string, instances: 'instanced' | 'batched'): string {
  const declarations = `${CORNER_OF_INSTANCE}flat out highp vec2 vFurrowCorner;`
  const corner = `vFurrowCorner = furrowCornerOf(${instanceIndex(instances)});`
  return replace(vertex, MAIN, `${declarations}\n${MAIN}\n\t${corner}`)
}

function instanceIndex(instances: 'instanced' | 'batched'): string {
  if (instances === 'instanced') return 'float(gl_InstanceID)'
  const chunk = ShaderChunk.batching_pars_vertex
  // Up to three.js r165, each vertex of a batched mesh has an instance index.
  if (chunk.includes('attribute float batchId;')) return 'batchId'
  // Later releases reorder the visible instances, and have a function that returns the index of the drawn instance.
  const [call] = chunk.match(/getIndirectIndex(?=\()/) ?? []
  return `${requireInternal(call, 'Wrinkles', 'getIndirectIndex in batching_pars_vertex', REVISION)}(gl_DrawID)`
}
