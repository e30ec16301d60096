import { noise, normals } from '../map-image.ts'
import type { Pose, SampleFile } from '../sample.ts'

const WEIGHTS = noise(1)
const LAYERS = [{ name: 'skin', normal: normals(2) }]
export const AREAS = (['a', 'b', 'c'] as const).map((name, i) => ({
  name,
  weights: WEIGHTS,
  channel: i as 0 | 1 | 2,
}))
const base = normals(3)

/** A square with blendshapes `up`, `down` and `smile` that move nothing, areas a, b and c, and drivers. */
export function driven(drivers: readonly object[], more: Partial<SampleFile> = {}): SampleFile {
  const targets = ['up', 'down', 'smile'].map((name) => ({ name }))
  return { base, layers: LAYERS, areas: AREAS, targets, drivers, ...more }
}

/** Expected activations of the three areas in a pose. */
export const at = (a: number, b: number, c: number, pose: Omit<Pose, 'activations'> = {}): Pose => ({
  ...pose,
  activations: { a, b, c },
})

/** A driver input with its weight. */
export const link = (name: string, weight?: number) => ({ name, weight })

/** A driver by blendshapes. */
export const morph = (area: string, targets: readonly object[], more: object = {}) => ({
  type: 'morph',
  area,
  targets,
  ...more,
})

/** The pose of most samples. */
export const HALF = { weights: { up: 0.5, down: 0.25 } }
