import { median } from '../../../math/quantile.ts'
import { type Vector, vectorAt } from '../vectors.ts'
import type { MovingSurface } from './moving-surface.ts'

/** Sphere around the part of a surface that targets (blendshapes) move. */
export interface MovingRegion {
  centre: Vector
  /** Typical distance of moved points from the centre. */
  radius: number
  /** For each point, the sum of its shares in the motions of all targets. Weak and strong targets count the same. */
  heat: Float64Array
  /** Indices of the points within two radii of the centre. */
  near: Uint32Array
}

/** Finds the region that most targets move. This is the head, even if the mesh includes the body. */
export function movingRegion({ points, areas, motions }: MovingSurface): MovingRegion | undefined {
  const heat = new Float64Array(areas.length)
  const regions = motions.map(({ distances, largest }) => {
    const sum = [0, 0, 0]
    let [mass, squares] = [0, 0]
    for (let i = 0; i < areas.length; i++) {
      const weight = (areas[i] * distances[i]) / largest
      mass += weight
      for (let k = 0; k < 3; k++) {
        sum[k] += weight * points[3 * i + k]
        squares += weight * points[3 * i + k] ** 2
      }
    }
    if (!(mass > 0)) return undefined
    for (let i = 0; i < areas.length; i++) heat[i] += (areas[i] * distances[i]) / largest / mass
    const centroid: Vector = [sum[0] / mass, sum[1] / mass, sum[2] / mass]
    const spread = squares / mass - centroid.reduce((total, x) => total + x * x, 0)
    return { centroid, spread: Math.max(0, spread) }
  })
  const found = regions.filter((region) => region !== undefined)
  if (found.length === 0) return undefined
  const centre: Vector = [0, 1, 2].map((k) =>
    median(found.map(({ centroid }) => centroid[k])),
  ) as unknown as Vector
  const square = (a: Vector) => a.reduce((sum, x, k) => sum + (x - centre[k]) ** 2, 0)
  const radius = RADIUS * Math.sqrt(median(found.map(({ centroid, spread }) => square(centroid) + spread)))
  const near: number[] = []
  for (let i = 0; i < areas.length; i++) if (square(vectorAt(points, i)) < (2 * radius) ** 2) near.push(i)
  return { centre, radius, heat, near: Uint32Array.from(near) }
}

/** Radius of the region as a multiple of the root mean square distance of moved points from the centre. */
const RADIUS = 0.85
