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

/** A skin that wrinkles can be made for. */
export interface PreparedSkin {
  /** Without broken targets, in the first tile of its texture. */
  skin: Skin
  /** Names of its targets. */
  names: readonly string[]
  /** The same without names that the motion contradicts. */
  known: readonly string[]
  /** Kind of each target, by motion and name. */
  hints: TargetHints
  /** Indices of the targets of that name: of a face in any rig's spelling, or of its stand-ins. */
  find(name: string): number[]
  /** Set if its targets show that it is one. */
  face: DetectedFace | undefined
  /** Whether it is a head on which no face was detected: nothing tells where it folds. */
  isUnknownHead: boolean
  /** In millimetres, of a face in its frame. */
  surface: SkinSurface
  /** Offsets of each target by point, in millimetres. */
  offsets: readonly Float64Array[]
  /** Millimetres per unit of the skin's positions. */
  scale: number
  /** Whether the left and right half of the face use the same texels. */
  isMirrored: boolean
  /** Tells whether a triangle is drawn into the texture; of halves that use the same texels only the left one is. */
  isDrawn: (triangle: number) => boolean
  locator: UvLocator
  /** One sentence each. */
  warnings: readonly string[]
}

/**
 * Checks a skin, moves it into the first tile of its texture, welds it, and detects a face.
 *
 * @throws FurrowError for a skin that no wrinkles can be made from.
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
  const { surface, offsets, scale } = face ?? weldInMillimetres(skin)
  checkScale(scale)
  const overlap = findOverlap(skin, surface)
  const isMirrored = face !== undefined && isFaceMirrored(face, overlap)
  if (isMirrored)
    warnings.push('left and right use the same texels: both sides crease together, driven half by each side')
  else if (isOverlapped(overlap))
    warnings.push(
      `${percent(overlap.fraction)} of the texture is used twice: wrinkles there show in both places`,
    )
  const isUnknownHead = !face && isHead(surface, offsets, hints)
  if (!face && !isUnknownHead)
    warnings.push(
      'no face was found by what the blendshapes move: wrinkles are placed by strain alone, cautiously',
    )
  const isDrawn = (face && drawnTriangles(surface, overlap)) ?? (() => true)
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
    isMirrored,
    isDrawn,
    locator,
    warnings,
  }
}

/** Whether most triangles between hairline, outer corners of the eyes and chin are mirrored. */
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

/** Lines are kept in millimetres, and so is the size of the face. */
function checkScale(scale: number): void {
  const [least, most] = SCALE_RANGE
  if (scale >= least && scale <= most) return
  throw new FurrowError({
    code: 'out-of-range',
    who: 'autoWrinkles',
    problem: `the skin is far too ${scale < least ? 'large' : 'small'} for a character`,
    value: `${scale.toPrecision(3)} mm per unit of its positions`,
    limit: `${least} to ${most}`,
    remedy: 'check the scale and the positions of its vertices',
  })
}
