import { noise } from '../../../math/noise.ts'
import type { Rng } from '../../../math/rng.ts'
import { dot } from '../../../math/vector.ts'
import { across, subtract, vectorAt } from '../../../math/vector3.ts'
import type { LineStyle } from '../anatomy/region.ts'
import type { ArcCrease } from './hand-tables.ts'
import { aroundLimb, LimbChart, type LimbFrame, type LimbGuide } from './limb-chart.ts'
import type { LimbSkin } from './limb-skin.ts'

/** Maximum distance from the joint along the limb at which creases are drawn, in millimetres for an adult. */
const EXTENT = 40
/** Normals may point inwards by this cosine, because pads of fingers bulge. */
const OUTWARDS = -0.2

/** Random variation of creases: shift along the limb and of the bow in millimetres, of width and depth as factors. */
const VARIED = { shift: 0.35, bow: 0.35, width: 0.1, depth: 0.15 } as const
/** Height, in millimetres, and number of the waves of a crease. */
const WAVES = { height: 0.45, count: 5 } as const

/** Creases with a valley that is deepest in the middle and fades out towards the sides of the limb. */
const STYLE: Omit<LineStyle, 'width' | 'depth'> = {
  depths: [0.35, 0.75, 0.95, 1, 0.9, 1, 0.95, 0.75, 0.35],
  taper: [0.102, 0.102],
  shoulder: [0.85, 0.85],
  softness: 0.35,
}

/** Returns the chart of a limb: the cylinder around it, with the angle in radians and the distance from the joint in millimetres. */
export function cylinderChart(
  limb: LimbSkin,
  frame: LimbFrame,
  isInside: (point: number) => boolean,
  size: number,
) {
  const { surface } = limb.prepared
  const at = (point: number) => vectorAt(surface.points, point)
  return new LimbChart(
    surface,
    (point) => {
      const { angle, along } = aroundLimb(frame, at(point))
      return Math.abs(along) < EXTENT * size ? [angle, along] : undefined
    },
    (normal, point) =>
      isInside(point) && dot(normal, across(subtract(at(point), frame.origin), frame.axis)) > OUTWARDS,
    2 * Math.PI,
  )
}

/**
 * Returns guides for creases across a limb, with random variation.
 *
 * @param varied factor on the variation of positions. Creases of an arm vary more than those of a finger.
 */
export function arcGuides(
  chart: LimbChart,
  arcs: readonly ArcCrease[],
  size: number,
  rng: Rng,
  style: Partial<LineStyle> = {},
  varied = 1,
): LimbGuide[] {
  return arcs.map((arc) => {
    const shift = varied * rng.jitter(VARIED.shift)
    const bow = arc.bow + varied * rng.jitter(VARIED.bow)
    const [from, to] = [-arc.span * rng.uniform(0.88, 1.06), arc.span * rng.uniform(0.88, 1.06)]
    const [width, depth] = [1 + rng.jitter(VARIED.width), 1 - VARIED.depth * rng.next()]
    const seed = rng.integer()
    return {
      chart,
      path: (t) => {
        const angle = from + (to - from) * t
        const share = angle / arc.span
        const wave = varied * WAVES.height * noise(WAVES.count * t, seed)
        return [angle, size * (arc.along + shift + bow * (1 - share * share) + wave)]
      },
      style: { ...STYLE, ...style, width: size * arc.width * width, depth: arc.depth * depth },
    }
  })
}
