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

/** What a program depends on: never the number of areas. */
export interface ShaderVariant extends NormalLayers {
  /** The layers' other maps, by kind. */
  values: Values
  cell: SampledCell
  /** Whether texture coordinates leave 0..1, and so wrap. */
  isTiled: boolean
  sampling: SliceSampling
  /** Whether the material lights in steps, and so shows wrinkles as lines too. */
  isToon: boolean
}

/**
 * Makes a material's fragment shader mix the layers' maps into its own before it lights them: `mixNormals` and `mixValues` of the
 * reference, except that the last normalisation is left to the material. The shader is one of three.js's, as the user may have edited
 * it, or another that reads its normal map as these do, such as MToon's. Such a one shows the layers' normals only: it need not
 * have the texture coordinates before its other maps are read.
 *
 * @throws Error when it reads its normal map in another way, or not at all.
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
  const chunk = ShaderChunk.batching_pars_vertex
  // Until r165 of three.js each vertex of a batch knows its instance.
  if (chunk.includes('attribute float batchId;')) return 'batchId'
  // Later ones draw the visible instances in an order of their own.
  const [call] = chunk.match(/getIndirectIndex(?=\()/) ?? []
  return `${requireInternal(call, 'Wrinkles', 'getIndirectIndex in batching_pars_vertex', REVISION)}(gl_DrawID)`
}
