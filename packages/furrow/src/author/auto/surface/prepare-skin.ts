import { FurrowError } from '../../../core/error.ts'
import { checkCoverage } from '../../skin/check-coverage.ts'
import { drawnTriangles, findOverlap, isOverlapped, type UvOverlap } from '../../skin/overlap.ts'
import type { Skin, SkinSurface } from '../../skin/surface.ts'
import { UvLocator, uvGridOf } from '../../skin/uv-locator.ts'
import { SCALE_RANGE } from '../../strokes/document.ts'
import { checkSkin } from './check-skin.ts'
import { type DetectedFace, detectFace } from './detect-face.ts'
import { isHead } from './head-signs.ts'
import { weldInMillimetres } from './skin-surface.ts'
import { hintsOf, type TargetHints } from './stand-ins.ts'
import { moveToFirstTile } from './uv-tiles.ts'

/** Skin with the data from which wrinkles are made. */
export interface PreparedSkin {
  /** Skin without broken targets, with UVs moved into 0..1. */
  skin: Skin
  names: readonly string[]
  /** Reliable names of the targets. A name that contradicts the target's motion is replaced by a placeholder. */
  known: readonly string[]
  /** Kind of each target, derived from its motion and its name. */
  hints: TargetHints
  /** Returns the indices of the targets with a name. On faces, see `DetectedFace.find`. */
  find(name: string): number[]
  /** Undefined if the skin is not recognised as a face. */
  face: DetectedFace | undefined
  /** Whether the skin is a head on which no face was detected, so that the positions of its wrinkles are unknown. */
  isUnknownHead: boolean
  /** Surface in millimetres. The surface of a face is in face coordinates. */
  surface: SkinSurface
  /** Offsets of each target per point, in millimetres. */
  offsets: readonly Float64Array[]
  /** Millimetres per unit of the skin's positions. */
  scale: number
  /** Column-major 4 x 4 matrix from the skin's positions to the surface. */
  toSurface: readonly number[]
  /** Whether the left and the right half of the face share texels. */
  isMirrored: boolean
  /** Returns whether a triangle is drawn into the texture. If both halves share texels, only the left half is drawn. */
  isDrawn: (triangle: number) => boolean
  /** Whether `isDrawn` leaves out the right side of parts whose sides share texels. */
  drawsOneSide: boolean
  /** Finds the drawn triangle at a UV point. */
  locator: UvLocator
  /** Each warning is a complete sentence without a full stop. */
  warnings: readonly string[]
}

/**
 * Checks a skin, moves its UVs into 0..1, merges vertices with equal positions, and detects a face.
 *
 * @throws FurrowError if no wrinkles can be made for the skin.
 */
export function prepareSkin(raw: Skin): PreparedSkin {
  const { skin: checked, warnings } = checkSkin(raw)
  const { skin, crossing } = moveToFirstTile(checked)
  checkCoverage(skin, 'autoWrinkles')
  if (crossing > 0)
    warnings.push(
      `${percent(crossing)} of the skin crosses the edges of its texture: nothing is drawn beyond them`,
    )
  const names = skin.targets.map(({ name }) => name)
  const face = detectFace(skin)
  const { known, hints } = face ?? { known: names, hints: hintsOf(skin.targets) }
  const find = face?.find ?? ((name: string) => [names.indexOf(name)])
  const { surface, offsets, scale, toSurface } = face ?? weldInMillimetres(skin)
  checkScale(scale)
  const overlap = findOverlap(skin, surface)
  const isMirrored = face !== undefined && isFaceMirrored(face, overlap)
  if (isMirrored)
    warnings.push(
      'left and right use the same texels: both sides crease together, at half strength if only one side moves',
    )
  else if (isOverlapped(overlap))
    warnings.push(
      `${percent(overlap.fraction)} of the texture is used twice: wrinkles there show in both places`,
    )
  const isUnknownHead = !face && isHead(surface, offsets, hints)
  if (!face && !isUnknownHead && names.length > 0)
    warnings.push(
      'no face detected from the blendshapes: shallow lines are placed by the compression of the skin alone',
    )
  const ofOneSide = face || skin.skeleton ? drawnTriangles(surface, overlap) : undefined
  const isDrawn = ofOneSide ?? (() => true)
  const locator = new UvLocator(skin, surface, uvGridOf(skin, surface, isDrawn))
  return {
    skin,
    names,
    known,
    hints,
    find,
    face,
    isUnknownHead,
    surface,
    offsets,
    scale,
    toSurface,
    isMirrored,
    isDrawn,
    drawsOneSide: ofOneSide !== undefined,
    locator,
    warnings,
  }
}

/** Returns whether most triangles on the front of the face share texels with the other half of the face. */
function isFaceMirrored({ surface, landmarks }: DetectedFace, { isMirrored }: UvOverlap): boolean {
  if (!isMirrored) return false
  const { points, corners } = surface
  const { chin, hairline, outerCorner } = landmarks
  const inFace = isMirrored.filter((_, t) => {
    const point = 3 * corners[3 * t]
    const [y, z] = [points[point + 1], points[point + 2]]
    return y > chin && y < hairline && z > outerCorner[2]
  })
  return inFace.filter(Boolean).length > inFace.length / 2
}

function percent(fraction: number): string {
  return `${Math.max(1, Math.round(100 * fraction))}%`
}

/** Checks that the scale is in the range of strokes documents, because the wrinkle lines are stored in such a document. */
function checkScale(scale: number): void {
  const [min, max] = SCALE_RANGE
  if (scale >= min && scale <= max) return
  throw new FurrowError({
    code: 'out-of-range',
    who: 'autoWrinkles',
    problem: `the skin is far too ${scale < min ? 'large' : 'small'} for a character`,
    value: `${scale.toPrecision(3)} mm per unit of its positions`,
    limit: `${min} to ${max}`,
    remedy: 'check the scale and the positions of its vertices',
  })
}
