/** Texture coordinates and how maps are sampled at them, in TSL; the same formulas as the GLSL of `webgl/`. */
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

/** Call it outside of any branch: inside one, neighbouring pixels may diverge. */
export function gradientsOf(uv: Node<'vec2'>): Gradients {
  const unwrapped = uv.toVar()
  return {
    uv: repeat(unwrapped).toVar(),
    dx: unwrapped.dFdx().toVar(),
    dy: unwrapped.dFdy().toVar(),
  }
}

/**
 * Samples one slice of an array with the gradients of the coordinates: safe inside a branch. Only an anisotropic sampler needs the
 * gradients themselves, which cost more than the level of detail computed from them (OpenGL ES 3.0, equations 3.18 and 3.21).
 *
 * @param slice counted from 0.
 * @returns the filtered texel, colours decoded to linear.
 */
export function sampleSlice(array: ArrayTexture, { uv, dx, dy }: Gradients, slice: number): Node<'vec4'> {
  const sampled = texture(array, uv).depth(int(slice))
  if (array.anisotropy > 1) return sampled.grad(dx, dy)
  const size = vec2(sizeOf(texture(array)))
  const [across, down] = [dx.mul(size), dy.mul(size)]
  const level = max(across.dot(across), down.dot(down), 1).log2().mul(0.5)
  return sampled.level(level)
}

/** Samples a slice of an array, counted from 0. */
export type SampleSlice = (array: ArrayTexture, slice: number) => Node<'vec4'>

/** How the layers' maps are sampled at texture coordinates within 0..1, by gradients at any. Called outside of any branch. */
export type SliceSampler = (uv: Node<'vec2'>) => SampleSlice

/** The sampler finds the level of detail, which software rasterisers pay less for than for one that is given. */
export const bySampler: SliceSampler = (uv) => (array, slice) => texture(array, uv).depth(int(slice))

/** Where texture coordinates may wrap between neighbouring pixels. */
export const byGradients: SliceSampler = (uv) => {
  const gradients = gradientsOf(uv)
  return (array, slice) => sampleSlice(array, gradients, slice)
}

/** Wraps texture coordinates into 0..1, see `repeat` in core; those already within stay exactly as they are. */
export function repeat(uv: Node<'vec2'>): Node<'vec2'> {
  return uv.sub(max(uv.ceil().sub(1), min(uv.floor(), 0)))
}

/** Texture coordinates of the material's normal map, its `KHR_texture_transform` applied. */
export function mapUv(material: Pick<WrinkleMaterial, 'normalMap'>): Node<'vec2'> {
  const transform = uniform(new Matrix3()).onObjectUpdate(() => {
    const map = material.normalMap!
    if (map.matrixAutoUpdate) map.updateMatrix()
    return map.matrix
  })
  return transform.mul(vec3(uv(material.normalMap!.channel), 1)).xy
}
