/** Texture coordinates and sampling of maps, in TSL; same formulas as the GLSL in `webgl/`. */
import { Matrix3 } from 'three'
import { int, max, min, texture, uniform, uv, vec2, vec3 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import type { ArrayTexture } from '../material/array-texture.ts'
import type { WrinkleMaterial } from '../material/wrinkle-material.ts'
import { sizeOf } from './node.ts'

/** Texture coordinates and their screen-space derivatives. */
export interface Gradients {
  uv: Node<'vec2'>
  dx: Node<'vec2'>
  dy: Node<'vec2'>
}

/** Computes gradients. Must be called outside of branches, where neighbouring pixels may diverge. */
export function gradientsOf(uv: Node<'vec2'>): Gradients {
  const unwrapped = uv.toVar()
  return {
    uv: repeat(unwrapped).toVar(),
    dx: unwrapped.dFdx().toVar(),
    dy: unwrapped.dFdy().toVar(),
  }
}

/**
 * Samples one slice of a texture array with explicit derivatives; safe inside branches. Only anisotropic samplers need the gradients.
 * Otherwise the level of detail computed from them is cheaper (OpenGL ES 3.0, equations 3.18 and 3.21).
 *
 * @param slice index from 0.
 * @returns the filtered texel, with colours in linear space.
 */
export function sampleSlice(array: ArrayTexture, { uv, dx, dy }: Gradients, slice: number): Node<'vec4'> {
  const sampled = texture(array, uv).depth(int(slice))
  if (array.anisotropy > 1) return sampled.grad(dx, dy)
  const size = vec2(sizeOf(texture(array)))
  const [across, down] = [dx.mul(size), dy.mul(size)]
  const level = max(across.dot(across), down.dot(down), 1).log2().mul(0.5)
  return sampled.level(level)
}

/** Samples a slice, by index from 0, of a texture array. */
export type SampleSlice = (array: ArrayTexture, slice: number) => Node<'vec4'>

/** Samples layer maps at texture coordinates: within 0..1 for `bySampler`, any for `byGradients`. Must be called outside of branches. */
export type SliceSampler = (uv: Node<'vec2'>) => SampleSlice

/** Implicit level of detail; on software rasterisers cheaper than an explicit one. */
export const bySampler: SliceSampler = (uv) => (array, slice) => texture(array, uv).depth(int(slice))

/** Explicit gradients, for texture coordinates that wrap between neighbouring pixels. */
export const byGradients: SliceSampler = (uv) => {
  const gradients = gradientsOf(uv)
  return (array, slice) => sampleSlice(array, gradients, slice)
}

/** Wraps texture coordinates into 0..1, see `repeat` in core. Coordinates within 0..1 stay bit-exact. */
export function repeat(uv: Node<'vec2'>): Node<'vec2'> {
  return uv.sub(max(uv.ceil().sub(1), min(uv.floor(), 0)))
}

/** Texture coordinates of the material's normal map, with its `KHR_texture_transform` applied. */
export function mapUv(material: Pick<WrinkleMaterial, 'normalMap'>): Node<'vec2'> {
  const transform = uniform(new Matrix3()).onObjectUpdate(() => {
    const map = material.normalMap!
    if (map.matrixAutoUpdate) map.updateMatrix()
    return map.matrix
  })
  return transform.mul(vec3(uv(material.normalMap!.channel), 1)).xy
}
