/** TSL that computes texture coordinates and samples maps. The formulas are those of the GLSL in `webgl/`. */
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

/** Computes gradients, and wraps texture coordinates into 0..1. Must be called outside of branches, in which derivatives are undefined. */
export function gradientsOf(uv: Node<'vec2'>): Gradients {
  const unwrapped = uv.toVar()
  return {
    uv: repeat(unwrapped).toVar(),
    dx: unwrapped.dFdx().toVar(),
    dy: unwrapped.dFdy().toVar(),
  }
}

/**
 * Samples one slice of a texture array with explicit derivatives, so it can be called inside branches. Anisotropic filtering needs the
 * derivatives. Without anisotropic filtering, the code computes the mipmap level from the derivatives, which is cheaper (OpenGL ES 3.0,
 * equations 3.18 and 3.21).
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

/** Samples one slice of a texture array. `slice` is its index. */
export type SampleSlice = (array: ArrayTexture, slice: number) => Node<'vec4'>

/**
 * Returns a function that samples layer maps at texture coordinates. `bySampler` requires coordinates within 0..1; `byGradients` wraps them.
 * Must be called outside of branches.
 */
export type SliceSampler = (uv: Node<'vec2'>) => SampleSlice

/** Lets the GPU choose the mipmap level, which is cheaper on software rasterisers than computing it in the shader. */
export const bySampler: SliceSampler = (uv) => (array, slice) => texture(array, uv).depth(int(slice))

/** Uses derivatives from before wrapping, because wrapped texture coordinates may jump between neighbouring pixels. */
export const byGradients: SliceSampler = (uv) => {
  const gradients = gradientsOf(uv)
  return (array, slice) => sampleSlice(array, gradients, slice)
}

/** Wraps texture coordinates into 0..1, see `repeat` in core. Coordinates within 0..1 stay bit-identical. */
export function repeat(uv: Node<'vec2'>): Node<'vec2'> {
  return uv.sub(max(uv.ceil().sub(1), min(uv.floor(), 0)))
}

/** Returns the texture coordinates of a material's normal map, after its `KHR_texture_transform`. */
export function mapUv(material: Pick<WrinkleMaterial, 'normalMap'>): Node<'vec2'> {
  const transform = uniform(new Matrix3()).onObjectUpdate(() => {
    const map = material.normalMap!
    if (map.matrixAutoUpdate) map.updateMatrix()
    return map.matrix
  })
  return transform.mul(vec3(uv(material.normalMap!.channel), 1)).xy
}
