import { dot, length } from '../../../math/vector.ts'
import { correctedNames } from '../../shapes/corrections.ts'
import { pointAreas, pointOffsets, type Skin, type SkinSurface, weldSurface } from '../../skin/surface.ts'
import type { MirrorPlane } from '../../strokes/edit/mirror.ts'
import { HeadChart } from './head-chart.ts'
import { type KnownTargets, knownTargets } from './known-targets.ts'
import { centroidOf, findLandmarks, type Landmarks } from './landmarks.ts'
import { faceShapeFinder, hintsOf, partShapeFinder, type TargetHints } from './stand-ins.ts'

/**
 * Skin that was recognised as a face. Face coordinates have their origin at the midpoint of the eyes. x points to the person's left, y up and
 * z forwards.
 */
export interface DetectedFace {
  /** Surface in face coordinates, in millimetres. */
  surface: SkinSurface
  /** Chart of the head: the surface, unrolled into a plane. */
  chart: HeadChart
  landmarks: Landmarks
  /** Millimetres per unit of the skin's positions. */
  scale: number
  /** Column-major 4 x 4 matrix from the skin's positions to the surface. */
  toSurface: readonly number[]
  /** Offsets of each target per point, in face coordinates, in millimetres. */
  offsets: readonly Float64Array[]
  names: readonly string[]
  /** Reliable names of the targets. A name that contradicts the target's motion is replaced by a placeholder. */
  known: readonly string[]
  /** Kind of each target, derived from its motion and its name. */
  hints: TargetHints
  /** Returns the indices of the targets with an ARKit name, in any rig's spelling. If there are none, returns similar targets. */
  find(name: string): number[]
}

/** Faces are scaled to this distance between the eyes, in millimetres: the mean of women's 61.7 and men's 64.0 (Dodgson 2004). */
const EYE_DISTANCE = 63

/** Skin of the mouth is at least this far below the eyes, in millimetres. */
const MOUTH_BELOW = 40
/** Skin of the brows is at least this far above the eyes, in millimetres. */
const BROWS_ABOVE = 10

/**
 * Recognises a face, and finds its features by the motion of targets (blendshapes): blinks move the lids, brow shapes move the brows, and
 * smiles move the corners of the mouth. If no target moves the brows, they are placed above the eyes.
 *
 * @returns undefined if the required targets are missing, are not recognised, or move nothing.
 */
export function detectFace(skin: Skin): DetectedFace | undefined {
  const names = skin.targets.map(({ name }) => name)
  const targets = knownTargets(skin)
  const { known, hints } = targets
  const placed = placeFace(skin, targets)
  if (!placed) return undefined
  const { surface, offsets, scale, toSurface } = placed
  const [find, findPart] = [faceShapeFinder(known, hints), partShapeFinder(known, hints)]
  const browsMoveAsOne = `${find('browInnerUp')}` === `${find('browOuterUpLeft')}`
  const count = surface.areas.length
  const landmarks = findLandmarks(surface, browsMoveAsOne, (...shapes) => {
    const parts = shapes.flatMap(findPart)
    if (parts.length > 0) return sumDisplacements(offsets, parts, count)
    return inHalf(surface, shapes[0], sumDisplacements(offsets, shapes.flatMap(find), count))
  })
  return (
    landmarks && {
      surface,
      chart: new HeadChart(surface),
      landmarks,
      scale,
      toSurface,
      offsets,
      names,
      known,
      hints,
      find,
    }
  )
}

/**
 * Finds the symmetry plane of a face from the positions of its eyes and mouth, which the motion of targets reveals.
 *
 * @returns undefined if the targets do not reveal the eyes and the mouth.
 */
export function middleOf(skin: Skin): MirrorPlane | undefined {
  return placedFace(skin)?.middle
}

/** Surface of a face in face coordinates (see `DetectedFace`). */
interface PlacedFace extends Pick<DetectedFace, 'surface' | 'offsets' | 'scale' | 'toSurface'> {
  /** Symmetry plane, in the coordinates of the skin. */
  middle: MirrorPlane
}

/**
 * Transforms a skin into face coordinates. The targets that reveal eyes and mouth are found by name, or by motion if names do not suffice.
 *
 * @returns undefined if the targets do not reveal the eyes and the mouth.
 */
export function placedFace(skin: Skin): PlacedFace | undefined {
  const byName = { known: correctedNames(skin.targets), hints: hintsOf(skin.targets) }
  return placeFace(skin, byName) ?? placeFace(skin, knownTargets(skin))
}

/** Transforms a skin into face coordinates. The positions of the eyes and the mouth define the axes. */
function placeFace(skin: Skin, { known, hints, eyes }: KnownTargets): PlacedFace | undefined {
  const welded = weldSurface(skin)
  const findPart = partShapeFinder(known, hints)
  const raw = skin.targets.map((target) => pointOffsets(welded, target))
  const centroid = (threshold: number, ...shapes: string[]) =>
    centroidOf(welded, sumDisplacements(raw, shapes.flatMap(findPart), welded.areas.length), threshold)
  // If one target closes both eyes, its centroid is between the eyes, so the positions found by `knownTargets` are used.
  const isBoth = `${findPart('eyeBlinkLeft')}` === `${findPart('eyeBlinkRight')}`
  const leftEye = isBoth ? eyes?.[0] : centroid(0.3, 'eyeBlinkLeft')
  const rightEye = isBoth ? eyes?.[1] : centroid(0.3, 'eyeBlinkRight')
  const mouth =
    centroid(0.5, 'mouthSmileLeft', 'mouthSmileRight', 'mouthStretch', 'mouthFrown') ??
    centroid(0.5, 'jawOpen')
  if (!leftEye || !rightEye || !mouth) return undefined
  const frame = faceFrame(leftEye, rightEye, mouth)
  if (!frame) return undefined
  const points = frame.positions(welded.points)
  const areas = pointAreas(points, welded.corners)
  const surface = { ...welded, points, areas, normals: frame.directions(welded.normals, 1) }
  const offsets = raw.map((offset) => frame.directions(offset, frame.scale))
  const { scale, middle, toSurface } = frame
  return { surface, offsets, scale, toSurface, middle }
}

function faceFrame(leftEye: readonly number[], rightEye: readonly number[], mouth: readonly number[]) {
  const origin = leftEye.map((value, k) => (value + rightEye[k]) / 2)
  const across = leftEye.map((value, k) => value - rightEye[k])
  const distance = length(across)
  const x = across.map((value) => value / distance)
  const rise = origin.map((value, k) => value - mouth[k])
  const along = rise.reduce((sum, value, k) => sum + value * x[k], 0)
  const upright = rise.map((value, k) => value - along * x[k])
  const height = length(upright)
  if (!(distance > 0 && height > 0)) return undefined
  const y = upright.map((value) => value / height)
  const z = [0, 1, 2].map((k) => x[(k + 1) % 3] * y[(k + 2) % 3] - x[(k + 2) % 3] * y[(k + 1) % 3])
  const scale = EYE_DISTANCE / distance
  const transform = (vectors: Float64Array, origin: readonly number[], scale: number): Float64Array => {
    const out = new Float64Array(vectors.length)
    for (const [row, axis] of [x, y, z].entries()) {
      const [ax, ay, az] = axis
      const [ox, oy, oz] = origin
      for (let i = 0; i < vectors.length; i += 3) {
        const sum = ax * (vectors[i] - ox) + ay * (vectors[i + 1] - oy) + az * (vectors[i + 2] - oz)
        out[i + row] = scale * sum
      }
    }
    return out
  }
  const middle: MirrorPlane = { origin: [origin[0], origin[1], origin[2]], normal: [x[0], x[1], x[2]] }
  return {
    /** Millimetres per unit of the skin. */
    scale,
    middle,
    toSurface: [
      ...[0, 1, 2].flatMap((k) => [scale * x[k], scale * y[k], scale * z[k], 0]),
      ...[x, y, z].map((axis) => -scale * dot(axis, origin)),
      1,
    ],
    positions: (vectors: Float64Array) => transform(vectors, origin, scale),
    directions: (vectors: Float64Array, factor: number) => transform(vectors, [0, 0, 0], factor),
  }
}

/**
 * Sets displacements outside one half of the face to 0, because emotions that replace missing shapes move the whole face. Shapes of the mouth
 * keep the lower half. All other shapes keep the upper half.
 */
function inHalf({ points }: SkinSurface, shape: string, displacements: Float64Array): Float64Array {
  const isInside = shape.startsWith('mouth')
    ? (up: number) => up < -MOUTH_BELOW
    : (up: number) => up > BROWS_ABOVE
  return displacements.map((distance, i) => (isInside(points[3 * i + 1]) ? distance : 0))
}

/** Sums the displacements of each point over several targets. */
function sumDisplacements(
  offsets: readonly Float64Array[],
  targets: readonly number[],
  count: number,
): Float64Array {
  const out = new Float64Array(count)
  for (const target of targets) {
    const offset = offsets[target]
    for (let i = 0; i < count; i++) {
      const x = offset[3 * i]
      const y = offset[3 * i + 1]
      const z = offset[3 * i + 2]
      out[i] += Math.sqrt(x * x + y * y + z * z)
    }
  }
  return out
}
