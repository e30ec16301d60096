import type { DabShape } from './brush.ts'
import type { PaintMap } from './paint-map.ts'

/** Minimum radius of a dab in texels, so that the brush covers at least one texel. */
const MIN_RADIUS = 1.25
/**
 * Width that bilinear filtering adds to the visible radius of a hard dab, texels: mean over all positions of the dab between texels. There, the
 * weight is a tenth of its maximum.
 */
const FILTERED = 0.4

type Sizes = Pick<PaintMap, 'texelSizes'>

/** Returns the radius of a dab on a triangle, millimetres: that of the brush, or the smallest that the texels can hold. */
export function dabRadius(
  { texelSizes }: Sizes,
  { radius }: Pick<DabShape, 'radius'>,
  triangle: number,
): number {
  return Math.max(radius, MIN_RADIUS * texelSizes[triangle])
}

/** Returns the radius up to which a dab is visible on a triangle, millimetres. */
export function visibleRadius(
  map: Sizes,
  brush: Pick<DabShape, 'radius' | 'softness'>,
  triangle: number,
): number {
  return dabRadius(map, brush, triangle) + FILTERED * (1 - brush.softness) * map.texelSizes[triangle]
}
