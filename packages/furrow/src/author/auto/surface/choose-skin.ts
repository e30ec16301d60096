import { length3 } from '../../../math/vector.ts'
import { correctedNames } from '../../shapes/corrections.ts'
import type { ShapeKind } from '../../shapes/names/name-hint.ts'
import { crossOf, type Skin } from '../../skin/surface.ts'
import { knownTargets } from './known-targets.ts'
import { faceShapeFinder, hintsOf, type TargetHints } from './stand-ins.ts'

/** Mesh that may be the skin of a character. A mesh with several materials has one candidate for each material. */
export interface SkinCandidate {
  skin: Skin
  /** Whether the material can show wrinkles. If so, the motion of the candidate counts twice. */
  isLit: boolean
  /** Names of the mesh and its material. They can indicate that the candidate is not skin. */
  label: string
}

export interface SkinChoice {
  index: number
  /** Motion of the chosen candidate as a fraction of the motion of all candidates, 0..1; NaN if nothing moves. */
  fraction: number
  /** Noun phrase for a message: the moving parts that were compared, such as "brows, lids and mouth". */
  movers: string
}

/** `SkinChoice.movers` of a face. */
export const FACE_MOVERS = 'brows, lids and mouth'

/** A candidate is not a face if its motion is less than this fraction of the largest motion of a candidate. */
const NEGLIGIBLE = 0.02

/** Blendshapes that move the skin of a face, and not only eyes or teeth. */
const SKIN_SHAPES = [
  'browInnerUp',
  'browDownLeft',
  'browDownRight',
  'eyeBlinkLeft',
  'eyeBlinkRight',
  'mouthSmileLeft',
  'mouthSmileRight',
]

/** Kinds of blendshapes that do not indicate a face, because bodies and other meshes have them too. */
const NO_EXPRESSIONS: readonly (ShapeKind | undefined)[] = ['body', 'corrective', 'hidden', 'other']

/** Words in names of meshes and materials that are not skin. */
const NO_SKIN =
  /cloth|outfit|pants|trousers?|jeans|shorts|skirt|dress|shirt|\btops?\b|bottom|jacket|coat|shoe|boot|sock|glove|hat\b|glasses|hair|brow|lash|eye|iris|pupil|teeth|tooth|tongue|gum/i
/** Factor on the motion of candidates whose label contains a word in `NO_SKIN`. */
const DOUBT = 0.25

/**
 * Chooses the skin of a character: the candidate whose surface moves most. The motion is measured with the first of these sets of blendshapes
 * that moves any candidate:
 *
 * 1. Blendshapes that move brows, lids and mouth, recognised by name.
 * 2. Blendshapes that move brows, lids and mouth, recognised by motion.
 * 3. Blendshapes that may be expressions, counting only vertices skinned to the head joint.
 * 4. Blendshapes that may be expressions.
 * 5. All blendshapes, including body sliders.
 *
 * @returns undefined if there are no candidates.
 */
export function chooseSkin(candidates: readonly SkinCandidate[]): SkinChoice | undefined {
  if (candidates.length === 0) return undefined
  const hasHead = candidates.some(({ skin }) => Array.prototype.some.call(skin.headWeights ?? [], isHead))
  const largest = () => Math.max(...candidates.map(({ skin }) => movedByAll(skin)))
  const ways: [movers: string, measure: (candidate: SkinCandidate) => number][] = [
    [
      FACE_MOVERS,
      ({ skin }) => movedSurface(skin, faceTargets(correctedNames(skin.targets), hintsOf(skin.targets))),
    ],
    [FACE_MOVERS, ({ skin }) => movedFace(skin, largest())],
    [
      'the head by blendshapes',
      ({ skin, label }) =>
        hasHead ? doubt(label) * movedSurface(skin, expressions(skin), skin.headWeights ?? []) : 0,
    ],
    ['all meshes by blendshapes', ({ skin, label }) => doubt(label) * movedSurface(skin, expressions(skin))],
    ['all meshes by blendshapes', ({ skin }) => movedByAll(skin)],
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

/** Measures how far blendshapes of brows, lids and mouth move a skin. These blendshapes are recognised by motion. */
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
 * Measures the motion of a skin: sums the area of each triangle times the displacement of its corners by the chosen targets.
 *
 * @param weights factors on the displacements of the vertices, 0 where missing. Default: 1 for all vertices.
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
