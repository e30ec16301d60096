import { length3 } from '../../../math/vector.ts'
import { crossOf, type Skin } from '../../skin/surface.ts'
import { faceShapeFinder, hintsOf } from './stand-ins.ts'

/** A mesh, or the part of one with one material, that may be the skin. */
export interface SkinCandidate {
  skin: Skin
  /** Whether its material can show wrinkles: such a one is preferred where it moves at least half as much. */
  isLit: boolean
}

/** The skin that was chosen. */
export interface SkinChoice {
  /** Index of the candidate. */
  index: number
  /** Of what the blendshapes move, 0..1; NaN where they move nothing. */
  fraction: number
  /** Whether brows, lids and mouth were looked at; all blendshapes otherwise. */
  isFace: boolean
}

/** Blendshapes of a face that move its skin, not only eyes or teeth. */
const SKIN_SHAPES = [
  'browInnerUp',
  'browDownLeft',
  'browDownRight',
  'eyeBlinkLeft',
  'eyeBlinkRight',
  'mouthSmileLeft',
  'mouthSmileRight',
]

/**
 * Chooses the skin of a character: the candidate whose surface brows, lids and mouth move most. Where no blendshape has such a name, the
 * one that all blendshapes together move most.
 *
 * @returns undefined where there are no candidates.
 */
export function chooseSkin(candidates: readonly SkinCandidate[]): SkinChoice | undefined {
  if (candidates.length === 0) return undefined
  const byFace = candidates.map(({ skin }) => movedSurface(skin, faceTargets(skin)))
  const isFace = byFace.some((moved) => moved > 0)
  const moved = isFace ? byFace : candidates.map(({ skin }) => movedSurface(skin, [...skin.targets.keys()]))
  const preferred = moved.map((value, i) => (candidates[i].isLit ? 2 * value : value))
  const index = preferred.indexOf(Math.max(...preferred))
  return { index, fraction: moved[index] / moved.reduce((a, b) => a + b, 0), isFace }
}

/** Indices of the targets that move brows, lids and mouth. */
function faceTargets({ targets }: Skin): number[] {
  const names = targets.map(({ name }) => name)
  const find = faceShapeFinder(names, hintsOf(targets))
  return [...new Set(SKIN_SHAPES.flatMap(find))]
}

/** The area of each triangle times how far the chosen targets move it, summed. */
function movedSurface({ positions, indices, targets }: Skin, chosen: readonly number[]): number {
  const distances = new Float64Array(positions.length / 3)
  for (const { offsets } of chosen.map((index) => targets[index])) {
    for (let i = 0; i < distances.length; i++) {
      distances[i] += length3(offsets[3 * i], offsets[3 * i + 1], offsets[3 * i + 2])
    }
  }
  const normal = new Float64Array(3)
  let sum = 0
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const distance = distances[indices[t]] + distances[indices[t + 1]] + distances[indices[t + 2]]
    const area = crossOf(positions, indices[t], indices[t + 1], indices[t + 2], normal) / 2
    if (distance > 0 && area > 0) sum += distance * area
  }
  return sum
}
