import type { Skin } from 'furrow/author'
import type { NamingScheme } from './naming-schemes.ts'

/** Half the width of the band where one side of a split blendshape fades into the other, metres. */
const MIDDLE = 0.01

/**
 * Returns a face with the blendshapes of a rig, made of ARKit's. Blendshapes that get equal names become one blendshape, their sum. A
 * blendshape that gets a name per side is split into two.
 *
 * @param nameOf returns another name for a blendshape, given the rig's name and ARKit's; default: the rig's name.
 */
export function withNamesOf(
  face: Skin,
  scheme: NamingScheme,
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
    const own = scheme(name)
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
