import { SIDES, type SkinRegion } from '../anatomy/region.ts'
import { type ChartPoint, unroll } from '../surface/head-chart.ts'
import type { Landmarks } from '../surface/landmarks.ts'

/** Part of a face that an expression reddens or turns pale. */
export interface Flush {
  name: string
  /** Names of areas with wrinkle lines. The flush is drawn only if at least one of these areas exists. */
  areas: readonly string[]
  /** Centre of an ellipse on the head's chart (the head unrolled into a plane), in millimetres. The flush is strongest at the centre. */
  centre: ChartPoint
  /** Radii of the ellipse, in millimetres. The flush ends at the edge of the ellipse. */
  radii: ChartPoint
  /** Increase of blood as a fraction of the blood map's amplitude. Negative values make the skin paler. */
  amount: number
  /** Weights of the blendshapes that cause the flush, by ARKit names. */
  cause: SkinRegion['cause']
  /** Time constant in seconds with which the flush appears; see `TimeDriver`. */
  attack: number
  /** Time constant in seconds with which the flush disappears. */
  release: number
}

const ENDS = SIDES.map(([, name]) => name)

/** Adds the suffixes in `ends` to the names of blendshapes. Two suffixes share the weight equally. */
function causeOf(weights: Readonly<Record<string, number>>, ends: readonly string[]): SkinRegion['cause'] {
  return Object.fromEntries(
    Object.entries(weights).flatMap(([shape, weight]) =>
      ends.map((end) => [shape + end, weight / ends.length]),
    ),
  )
}

/** Skin over a working muscle reddens within seconds, and stays red for longer. */
const REDDENING = { attack: 1.2, release: 4 }
/**
 * Pressed skin turns pale at once, and blood refills it within about a second. The upper limits of normal refill times are 1.0 s in men,
 * 1.2 s in women and 4.5 s in the elderly (Schriger, Baraff 1988).
 */
export const PRESSING = { attack: 0.08, release: 0.9 }

/**
 * Returns the flushes of a face: red skin between the brows, beside the nose and on the cheeks, and pale lips when the mouth is pressed.
 *
 * @param isMirrored whether the left and the right half of the face share texels. If so, both sides share an area, and the blendshapes of
 *   one side activate it to 0.5.
 */
export function flushesOf(landmarks: Landmarks, isMirrored: boolean): Flush[] {
  const at = ([x, y, z]: Landmarks['eye']) => unroll(x, y, z)
  const [, brow] = at(landmarks.innerBrow)
  const [wing, base] = at(landmarks.wing)
  const [corner, mouth] = at(landmarks.mouthCorner)
  const [eye] = at(landmarks.eye)
  const cheek = mouth + 0.52 * (landmarks.eye[1] - mouth)
  const sides = isMirrored
    ? [{ side: 1, name: '', ends: ENDS }]
    : SIDES.map(([side, name]) => ({ side, name, ends: [name] }))
  return [
    {
      name: 'flushBrows',
      areas: ['', ...ENDS].map((end) => `glabella${end}`),
      centre: [0, brow + 4],
      radii: [21, 19],
      amount: 1,
      cause: causeOf({ browDown: 1 }, ENDS),
      ...REDDENING,
    },
    ...sides.flatMap(({ side, name, ends }): Flush[] => [
      {
        name: `flushNose${name}`,
        areas: [`nose${name}`],
        centre: [side * (wing + 2), base + 5],
        radii: [11, 16],
        amount: 1,
        cause: causeOf({ noseSneer: 1 }, ends),
        ...REDDENING,
      },
      {
        name: `flushCheek${name}`,
        areas: [`nasolabial${name}`],
        centre: [side * (eye + 4), cheek],
        radii: [25, 19],
        amount: 0.5,
        cause: causeOf({ mouthSmile: 1, cheekSquint: 0.3 }, ends),
        ...REDDENING,
      },
    ]),
    {
      name: 'paleLips',
      areas: ['upperLip', 'lowerLip'],
      centre: [0, mouth],
      radii: [corner * 1.05, 12],
      amount: -0.7,
      cause: { ...causeOf({ mouthPress: 1 }, ENDS), mouthRollUpper: 0.3, mouthRollLower: 0.3 },
      ...PRESSING,
    },
  ]
}

/** Returns the strength of a flush at a chart point: 1 at the flush's centre, 0 at its edge and outside. */
export function fadeOf({ centre, radii }: Flush, [across, up]: ChartPoint): number {
  const square = ((across - centre[0]) / radii[0]) ** 2 + ((up - centre[1]) / radii[1]) ** 2
  return square >= 1 ? 0 : (1 - square) ** 2
}
