import type { Skin } from 'furrow/author'
import type { Spell } from './naming-schemes.ts'

/** Metres to either side of the middle over which a shape passes from one side's part to the other's. */
const MIDDLE = 0.01

/**
 * A face with ARKit's names under the names of a rig, with the shapes that the rig has. Shapes of one name are added up. Where the rig has a
 * name for each side of a shape, each gets the motion of its side.
 *
 * @param nameOf replaces a rig's name; it is also given ARKit's name, with a side where the rig splits the shape.
 */
export function spelled(
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
