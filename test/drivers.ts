import type { Curve, Link, MorphDriver } from 'furrow'

/** Linear curve from 0 at `from` to `most` at `to`. */
export const ramp = (from: number, to: number, most = 1): Curve => [
  [from, 0],
  [to, most],
]

export const STRAIGHT = ramp(0, 1)

export const link = (name: string, weight = 1, curve?: Curve): Link => ({
  name,
  weight,
  ...(curve && { curve }),
})

/** Returns a driver that sums blendshapes. `targets` is the name of one blendshape, or links to several. */
export const morph = (
  area: string,
  targets: string | Link[],
  more: Partial<MorphDriver> = {},
): MorphDriver => ({
  type: 'morph',
  area,
  targets: typeof targets === 'string' ? [link(targets)] : targets,
  rule: 'sum',
  curve: STRAIGHT,
  ...more,
})
