import { int, ivec2, select, texture, varying, vec2, vec4 } from 'three/tsl'
import type { Node, TextureNode } from 'three/webgpu'
import type { ComposeMaterial } from '../../material/composed-map.ts'
import { influenceFromMap } from '../influence/influence.ts'
import { quadMaterial, targetUv } from '../influence/influence-quads.ts'
import { mixNormals, unpack } from '../mixing/mix-normals.ts'
import { delayInfluence } from '../mixing/onset.ts'
import { sizeOf } from '../node.ts'
import { bySampler, type SliceSampler } from '../texture-sampling.ts'

/**
 * Creates the material that draws the composed normal map with `WebGPURenderer`. The map is the normal map of a material, mixed with the normals
 * of the wrinkles.
 */
export const composeMaterial: ComposeMaterial = (base, inputs, level) => {
  const isTexelwise = level !== undefined
  const uv = varying(targetUv())
  const baseMap = texture(base, uv)
  const normal = unpack((isTexelwise ? baseMap.load(texelAt(baseMap, uv)) : baseMap).xyz)
  const influence = delayInfluence(inputs, influenceFromMap(inputs, uv, null), bySampler(uv))
  const layers = { influence, uv, sampler: isTexelwise ? byTexel : bySampler }
  const mixed = mixNormals(normal, inputs, layers).toVar()
  const hasDetails = inputs.textures.kinds.includes('detail')
  const shown = hasDetails ? select(influence.greaterThan(vec4(0)).any(), mixed.normalize(), normal) : mixed
  return quadMaterial('composed', vec4(shown.mul(0.5).add(0.5), 1))
}

/** Reads the texel of a map at the position of the pixel that is drawn. The maps and the render target must have the same size. */
const byTexel: SliceSampler = (uv) => (array, slice) => {
  const map = texture(array)
  return map.load(texelAt(map, uv)).depth(int(slice))
}

export function texelAt(map: TextureNode, uv: Node<'vec2'>): Node<'ivec2'> {
  return ivec2(uv.mul(vec2(sizeOf(map))))
}
