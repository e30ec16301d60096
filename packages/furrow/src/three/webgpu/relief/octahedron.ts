/** TSL for the octahedral encoding of directions; source in `CoarseParts`. */
import { select, vec2, vec3 } from 'three/tsl'
import type { Node } from 'three/webgpu'

/** Encodes a direction of nonzero length as two numbers, -1..1. */
export function toOctahedron(direction: Node<'vec3'>): Node<'vec2'> {
  const size = direction.abs()
  const v = direction.div(size.x.add(size.y, size.z)).toVar()
  return select(v.z.lessThan(0), folded(v.xy), v.xy)
}

/** Decodes a unit vector. */
export function fromOctahedron(point: Node<'vec2'>): Node<'vec3'> {
  const size = point.abs()
  const z = size.x.add(size.y).oneMinus().toVar()
  return vec3(select(z.lessThan(0), folded(point), point), z).normalize()
}

/** Folds the lower half of the octahedron over the upper half, and back. */
function folded(point: Node<'vec2'>): Node<'vec2'> {
  const sign = (value: Node<'float'>) => select(value.lessThan(0), -1, 1)
  return point.yx
    .abs()
    .oneMinus()
    .mul(vec2(sign(point.x), sign(point.y)))
}
