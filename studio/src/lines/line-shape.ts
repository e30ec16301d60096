import type { LayerStroke } from '../document/document.ts'

/** Fields that define the cross-section and the fading ends of a line. */
export type LineShape = Pick<
  LayerStroke,
  'width' | 'depth' | 'softness' | 'shoulder' | 'bank' | 'lean' | 'taper'
>

/** Default shape, similar to a forehead wrinkle. Width and depth in millimetres. */
export const LINE_SHAPE: LineShape = {
  width: 3,
  depth: 0.6,
  softness: 0.4,
  shoulder: [0.6, 0.6],
  taper: [0.3, 0.3],
}

/**
 * Changes the shape of a line. Keeps the taper of ends in forks, because an end that fades would leave a gap in the fork.
 *
 * @param attached ends in forks; 0: the start, 1: the end.
 */
export function withShape(
  stroke: LayerStroke,
  fields: Partial<LineShape>,
  attached: readonly (0 | 1)[],
): LayerStroke {
  const { taper } = fields
  if (!taper) return { ...stroke, ...fields }
  const own = (end: 0 | 1) => (attached.includes(end) ? stroke : { taper }).taper[end]
  return { ...stroke, ...fields, taper: [own(0), own(1)] }
}

/** Returns the mean taper of the ends that are not in a fork, or of both ends if there are none. */
export function meanTaper({ taper }: LineShape, attached: readonly (0 | 1)[]): number {
  const free = taper.filter((_, end) => !attached.includes(end as 0 | 1))
  const shown = free.length > 0 ? free : taper
  return shown.reduce((sum, value) => sum + value, 0) / shown.length
}
