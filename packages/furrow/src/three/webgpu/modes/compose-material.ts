import { int, ivec2, select, texture, varying, vec2, vec4 } from 'three/tsl'
import type { Node, TextureNode } from 'three/webgpu'
import type { ComposeMaterial } from '../../material/composed-map.ts'
import { influenceFromMap } from '../influence/influence.ts'
import { quadMaterial, targetUv } from '../influence/influence-quads.ts'
import { mixNormals, unpack } from '../mixing/mix-normals.ts'
import { sizeOf } from '../node.ts'
import { bySampler, type SliceSampler } from '../texture-sampling.ts'

/** Draws the composed normal map with `WebGPURenderer`. */
export const composeMaterial: ComposeMaterial = (base, inputs, level) => {
  const isTexelwise = level !== undefined
  const uv = varying(targetUv())
  const baseMap = texture(base, uv)
  const normal = unpack((isTexelwise ? baseMap.load(texelAt(baseMap, uv)) : baseMap).xyz)
  const influence = influenceFromMap(inputs, uv, null)
  const layers = { influence, uv, sampler: isTexelwise ? byTexel : bySampler }
  const mixed = mixNormals(normal, inputs, layers).toVar()
  const hasDetails = inputs.textures.kinds.includes('detail')
  const shown = hasDetails ? select(influence.greaterThan(vec4(0)).any(), mixed.normalize(), normal) : mixed
  return quadMaterial('composed', vec4(shown.mul(0.5).add(0.5), 1))
}

/** Reads the texel at the target's pixel: all maps have the target's size. */
const byTexel: SliceSampler = (uv) => (array, slice) => {
  const map = texture(array)
  return map.load(texelAt(map, uv)).depth(int(slice))
}

/** Texel of a map's finest level at texture coordinates within 0..1. */
export function texelAt(map: TextureNode, uv: Node<'vec2'>): Node<'ivec2'> {
  return ivec2(uv.mul(vec2(sizeOf(map))))
}
