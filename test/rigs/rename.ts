import type { Skin } from 'furrow/author'
import type { Spell } from './naming-schemes.ts'

/** Half width of the blend between the two sides of a shape, metres. */
const MIDDLE = 0.01

/**
 * Renames ARKit's shapes to a rig's, and keeps only shapes that the rig has. Shapes with equal names are summed. A shape with a name per
 * side is split into the motion of each side.
 *
 * @param nameOf replaces a rig's name. It also receives ARKit's name, with a side if the rig splits the shape.
 */
export function respelled(
  face: Skin,
  spell: Spell,
  nameOf: (own: string, shape: string) => string = (own) => own,
): Skin {
  const targets = new Map<string, Float32Array>()
  const add = (name: string, offsets: ArrayLike<number>, share: (vertex: number) => number) => {
    const sum = targets.get(name) ?? new Float32Array(offsets.length)
    targets.set(
      name,
      sum.map((value, k) => value + offsets[k]! * share(Math.floor(k / 3))),
    )
  }
  for (const { name, offsets } of face.targets) {
    const own = spell(name)
    if (own === undefined) continue
    if (typeof own === 'string') {
      add(nameOf(own, name), offsets, () => 1)
      continue
    }
    for (const [i, side] of (['Left', 'Right'] as const).entries()) {
      const sign = i === 0 ? 1 : -1
      add(nameOf(own[i]!, `${name}${side}`), offsets, (vertex) =>
        Math.min(1, Math.max(0, 0.5 + (sign * face.positions[3 * vertex]!) / (2 * MIDDLE))),
      )
    }
  }
  return { ...face, targets: [...targets].map(([name, offsets]) => ({ name, offsets })) }
}
