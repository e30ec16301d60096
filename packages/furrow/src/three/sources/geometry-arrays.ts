import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute } from 'three'

export type AnyAttribute = BufferAttribute | InterleavedBufferAttribute

const GETTERS = ['getX', 'getY', 'getZ', 'getW'] as const

/** Returns component `k` (0..3) of vertex `i`. Interleaved attributes lack `getComponent` in three.js r160. */
export function componentOf(attribute: AnyAttribute, i: number, k: number): number {
  const { getComponent } = attribute as Partial<AnyAttribute>
  return getComponent ? getComponent.call(attribute, i, k) : attribute[GETTERS[k]](i)
}

export function coordinates(attribute: AnyAttribute, size = 3): Float32Array {
  const { isBufferAttribute, array, itemSize, normalized } = attribute as Partial<BufferAttribute>
  // Copying the array is several times faster than `componentOf`.
  if (isBufferAttribute && itemSize === size && !normalized) return new Float32Array(array!)
  const out = new Float32Array(size * attribute.count)
  for (let i = 0; i < out.length; i++) out[i] = componentOf(attribute, Math.floor(i / size), i % size)
  return out
}

/**
 * Returns an array of packed xyz vectors, indexed like the attribute. If possible, this is the array of the attribute itself, because `getX` is
 * several times slower. The result must therefore not be changed. In a new array, only the vectors of the given vertices are set.
 */
export function vectorsOf(
  attribute: BufferAttribute | InterleavedBufferAttribute,
  vertices: ArrayLike<number>,
): ArrayLike<number> {
  const { isBufferAttribute, array, itemSize, normalized } = attribute as BufferAttribute
  if (isBufferAttribute && itemSize === 3 && !normalized) return array
  const vectors = new Float32Array(3 * attribute.count)
  for (let k = 0; k < vertices.length; k++) {
    const i = vertices[k]
    vectors[3 * i] = attribute.getX(i)
    vectors[3 * i + 1] = attribute.getY(i)
    vectors[3 * i + 2] = attribute.getZ(i)
  }
  return vectors
}

/** Returns three vertex indices per triangle, also for a geometry without an index. */
export function trianglesOf({ attributes, index }: BufferGeometry): ArrayLike<number> {
  return index?.array ?? Uint32Array.from({ length: attributes.position.count }, (_, i) => i)
}

/** Returns the packed xyz displacements of each morph target, whether the geometry stores displacements or positions. */
export function targetOffsets({
  attributes,
  morphAttributes,
  morphTargetsRelative,
}: BufferGeometry): Float32Array[] {
  const targets = (morphAttributes.position ?? []).map((target) => coordinates(target))
  if (morphTargetsRelative || targets.length === 0) return targets
  const rest = coordinates(attributes.position)
  return targets.map((target) => target.map((value, i) => value - rest[i]))
}

/** Copies the first `out.length` numbers. Returns whether any number in `out` has changed. */
export function copyNumbers(out: Float32Array, values: ArrayLike<number>): boolean {
  let changed = false
  for (let i = 0; i < out.length; i++) {
    const before = out[i]
    out[i] = values[i]
    if (out[i] !== before) changed = true
  }
  return changed
}
