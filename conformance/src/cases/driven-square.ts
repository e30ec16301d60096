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

/**
 * Returns a square with the given drivers, the areas a, b and c, and the blendshapes `up`, `down` and `smile`, which
 * move nothing.
 */
export function driven(drivers: readonly object[], more: Partial<SampleFile> = {}): SampleFile {
  const targets = ['up', 'down', 'smile'].map((name) => ({ name }))
  return { base, layers: LAYERS, areas: AREAS, targets, drivers, ...more }
}

/** Returns a pose with the expected activations of the areas a, b and c. */
export const at = (a: number, b: number, c: number, pose: Omit<Pose, 'activations'> = {}): Pose => ({
  ...pose,
  activations: { a, b, c },
})

/** Returns a link, which is an input of a driver with its weight. */
export const link = (name: string, weight?: number) => ({ name, weight })

export const morph = (area: string, targets: readonly object[], more: object = {}) => ({
  type: 'morph',
  area,
  targets,
  ...more,
})

/** Blendshape weights that most samples set. */
export const HALF = { weights: { up: 0.5, down: 0.25 } }
