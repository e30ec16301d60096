import type { Build } from './anatomy/region.ts'
import { type AutoRegion, regionsOf } from './anatomy/regions.ts'
import { type CreasedRegion, creaseLines } from './crease.ts'
import { type Face, poseOf } from './face.ts'
import { layGuides } from './guided-lines.ts'
import { Random } from './random.ts'
import { poseInOwnShapes } from './stand-ins.ts'
import { strainOf } from './strain.ts'

/**
 * Lays the lines of the wanted regions on a face.
 *
 * @param age 0 at 20 years, 1 at 80.
 * @param strength multiplies the depth.
 */
export function faceRegions(
  face: Face,
  age: number,
  strength: number,
  seed: number,
  wanted: readonly AutoRegion[],
): CreasedRegion[] {
  const build: Build = { landmarks: face.landmarks, age, random: (name) => new Random(seed, name) }
  const strains = new Map<string, Float64Array>()
  const known = new Map<unknown, Omit<CreasedRegion, 'region'>>()
  return regionsOf(build, wanted).flatMap((asArkit): CreasedRegion[] => {
    const region = { ...asArkit, cause: poseInOwnShapes(asArkit.cause, face.names) }
    const expression = poseInOwnShapes(asArkit.together ?? asArkit.cause, face.names)
    const key = JSON.stringify(expression)
    const tensors = strains.get(key) ?? strainOf(face.surface, face.offsets, poseOf(face.find, expression))
    strains.set(key, tensors)
    const lines =
      known.get(region.guides) ??
      creaseLines(region, layGuides(face.surface, face.chart, region.guides, tensors), strength)
    known.set(region.guides, lines)
    return lines.creases.length > 0 ? [{ region, ...lines }] : []
  })
}
