import { length3 } from '../../../math/vector.ts'
import { correctedNames } from '../../shapes/corrections.ts'
import type { ShapeKind } from '../../shapes/names/name-hint.ts'
import { crossOf, type Skin } from '../../skin/surface.ts'
import { knownTargets } from './known-targets.ts'
import { faceShapeFinder, hintsOf, type TargetHints } from './stand-ins.ts'

/** Mesh, or its part with one material, that may be the skin. */
export interface SkinCandidate {
  skin: Skin
  /** Whether its material can show wrinkles: preferred if it moves at least half as much. */
  isLit: boolean
  /** Names of its mesh and material, which may indicate that it is not skin. */
  label: string
}

export interface SkinChoice {
  /** Index of the candidate. */
  index: number
  /** Fraction of the surface moved by `movers` that belongs to the candidate, 0..1; NaN if they move nothing. */
  fraction: number
  /** Human-readable reason for the choice. */
  movers: string
}

/** Minimum fraction of the most moved surface for a candidate to be a face. */
const NEGLIGIBLE = 0.02

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

/** Kinds of blendshapes that do not indicate a face. */
const NO_EXPRESSIONS: readonly (ShapeKind | undefined)[] = ['body', 'corrective', 'hidden', 'other']

/** Words in names of meshes and materials that are not skin. */
const NO_SKIN =
  /cloth|outfit|pants|trousers?|jeans|shorts|skirt|dress|shirt|\btops?\b|bottom|jacket|coat|shoe|boot|sock|glove|hat\b|glasses|hair|brow|lash|eye|iris|pupil|teeth|tooth|tongue|gum/i
/** Factor for candidates with these words. */
const DOUBT = 0.25

/**
 * Chooses the skin of a character: the candidate whose surface moves most with brows, lids and mouth, by the names of blendshapes or else
 * by their motion. Without these, the blendshapes weighted by the head joint decide, then all expressions. Body sliders and similar
 * blendshapes only count if nothing else moves.
 *
 * @returns undefined if there are no candidates.
 */
export function chooseSkin(candidates: readonly SkinCandidate[]): SkinChoice | undefined {
  if (candidates.length === 0) return undefined
  const hasHead = candidates.some(({ skin }) => Array.prototype.some.call(skin.headWeights ?? [], isHead))
  const largest = () => Math.max(...candidates.map(({ skin }) => movedByAll(skin)))
  const ways: [movers: string, measure: (candidate: SkinCandidate) => number][] = [
    [
      'brows, lids and mouth',
      ({ skin }) => movedSurface(skin, faceTargets(correctedNames(skin.targets), hintsOf(skin.targets))),
    ],
    ['brows, lids and mouth', ({ skin }) => movedFace(skin, largest())],
    [
      'the blendshapes of the head',
      ({ skin, label }) =>
        hasHead ? doubt(label) * movedSurface(skin, expressions(skin), skin.headWeights ?? []) : 0,
    ],
    ['the blendshapes', ({ skin, label }) => doubt(label) * movedSurface(skin, expressions(skin))],
    ['all blendshapes', ({ skin }) => movedByAll(skin)],
  ]
  let [moved, movers]: [number[], string] = [[], '']
  for (const [name, measure] of ways) {
    ;[moved, movers] = [candidates.map(measure), name]
    if (moved.some((value) => value > 0)) break
  }
  const preferred = moved.map((value, i) => (candidates[i].isLit ? 2 * value : value))
  const index = preferred.indexOf(Math.max(...preferred))
  return { index, fraction: moved[index] / moved.reduce((a, b) => a + b, 0), movers }
}

function isHead(weight: number): boolean {
  return weight > 0.5
}

function doubt(label: string): number {
  return NO_SKIN.test(label) ? DOUBT : 1
}

function movedByAll(skin: Skin): number {
  return movedSurface(skin, [...skin.targets.keys()])
}

/** Measures the surface that brows, lids and mouth move, identified by motion. */
function movedFace(skin: Skin, largest: number): number {
  if (!(movedByAll(skin) > NEGLIGIBLE * largest)) return 0
  const { known, hints } = knownTargets(skin)
  return movedSurface(skin, faceTargets(known, hints))
}

/** Returns the indices of the targets that move brows, lids and mouth. */
function faceTargets(names: readonly string[], hints: TargetHints): number[] {
  const find = faceShapeFinder(names, hints)
  return [...new Set(SKIN_SHAPES.flatMap(find))]
}

/** Returns the indices of the targets that may be expressions. */
function expressions({ targets }: Skin): number[] {
  const hints = hintsOf(targets)
  return [...targets.keys()].filter((target) => !NO_EXPRESSIONS.includes(hints[target]?.kind))
}

/**
 * Sums the area of each triangle times its displacement by the chosen targets.
 *
 * @param weights factors of the vertices, 0 if missing; default: all 1.
 */
function movedSurface(
  { positions, indices, targets }: Skin,
  chosen: readonly number[],
  weights?: ArrayLike<number>,
): number {
  const distances = new Float64Array(positions.length / 3)
  for (const { offsets } of chosen.map((index) => targets[index])) {
    for (let i = 0; i < distances.length; i++) {
      distances[i] += length3(offsets[3 * i], offsets[3 * i + 1], offsets[3 * i + 2])
    }
  }
  if (weights) for (let i = 0; i < distances.length; i++) distances[i] *= weights[i] ?? 0
  const normal = new Float64Array(3)
  let sum = 0
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const distance = distances[indices[t]] + distances[indices[t + 1]] + distances[indices[t + 2]]
    const area = crossOf(positions, indices[t], indices[t + 1], indices[t + 2], normal) / 2
    if (distance > 0 && area > 0) sum += distance * area
  }
  return sum
}
