import { cross, dot, minus, unit, type Vector } from '../../../test/vectors.ts'
import { median } from '../../statistics.ts'
import type { LineSample, SkinLine } from './skin-lines.ts'

/** Maximum distance between neighbouring lines, as a multiple of the wavelength. */
const FARTHEST = 2.5
/** Half the width, in millimetres, of the strip across a line in which the neighbours of a point are found. */
const STRIP = 0.5

/**
 * Measures the distance between neighbouring lines. From each point of each line, it measures the distance to the next line on each side,
 * across the line, in the tangent plane of the skin. Returns the median distance.
 *
 * @param lines lines of one region.
 * @param wavelength distance between the folds into which the region's skin buckles, in millimetres.
 * @returns millimetres, undefined if no line has a neighbour.
 */
export function lineSpacing(lines: readonly SkinLine[], wavelength: number): number | undefined {
  const distances = lines.flatMap((line) => {
    const others = lines.filter((other) => other !== line).flatMap(({ samples }) => samples)
    return line.samples.slice(1).flatMap((sample, i) => {
      const previous = line.samples[i]!
      return neighbourDistances(
        sample,
        minus(sample.position, previous.position),
        others,
        FARTHEST * wavelength,
      )
    })
  })
  return distances.length > 0 ? median(distances) : undefined
}

/** Returns the distance from a point of a line to the nearest neighbour on each side. Leaves out a side without neighbours. */
function neighbourDistances(
  { position, normal }: LineSample,
  direction: Vector,
  others: readonly LineSample[],
  farthest: number,
): number[] {
  const along = unit(direction)
  const across = unit(cross(normal, along))
  const nearest = [farthest, farthest]
  for (const other of others) {
    const offset = minus(other.position, position)
    if (Math.abs(dot(offset, along)) > STRIP) continue
    const distance = dot(offset, across)
    const side = distance < 0 ? 0 : 1
    nearest[side] = Math.min(nearest[side]!, Math.abs(distance))
  }
  return nearest.filter((distance) => distance < farthest)
}
