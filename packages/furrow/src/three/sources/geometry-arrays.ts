import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute } from 'three'

export type AnyAttribute = BufferAttribute | InterleavedBufferAttribute

const GETTERS = ['getX', 'getY', 'getZ', 'getW'] as const

/** Returns component k of vertex i. Interleaved attributes lack `getComponent` in three.js r160. */
export function componentOf(attribute: AnyAttribute, i: number, k: number): number {
  const { getComponent } = attribute as Partial<AnyAttribute>
  return getComponent ? getComponent.call(attribute, i, k) : attribute[GETTERS[k]](i)
}

/** Copies an attribute to floats. Supports quantised and interleaved attributes. */
export function coordinates(attribute: AnyAttribute, size = 3): Float32Array {
  const { isBufferAttribute, array, itemSize, normalized } = attribute as Partial<BufferAttribute>
  // Reading through the attribute is several times slower.
  if (isBufferAttribute && itemSize === size && !normalized) return new Float32Array(array!)
  const out = new Float32Array(size * attribute.count)
  for (let i = 0; i < out.length; i++) out[i] = componentOf(attribute, Math.floor(i / size), i % size)
  return out
}

/**
 * Returns packed xyz vectors, valid at the given vertices. Read-only: may alias the attribute's array, because reading through the attribute
 * is several times slower.
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

/** Vertex indices of the triangles; generated if the geometry has no index. */
export function trianglesOf({ attributes, index }: BufferGeometry): ArrayLike<number> {
  return index?.array ?? Uint32Array.from({ length: attributes.position.count }, (_, i) => i)
}

/** Packed xyz displacements of each morph target, for relative and absolute targets. */
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

/** Copies numbers. Returns whether any has changed. */
export function copyNumbers(out: Float32Array, values: ArrayLike<number>): boolean {
  let changed = false
  for (let i = 0; i < out.length; i++) {
    const before = out[i]
    out[i] = values[i]
    if (out[i] !== before) changed = true
  }
  return changed
}
