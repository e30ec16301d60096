import { SIDES, type SkinRegion } from '../anatomy/region.ts'
import { type ChartPoint, unroll } from '../surface/head-chart.ts'
import type { Landmarks } from '../surface/landmarks.ts'

/** A part of a face whose blood an expression changes. */
export interface Flush {
  /** Name of its area. */
  name: string
  /** It is drawn where one of these areas has lines. */
  areas: readonly string[]
  /** An ellipse on the chart of the head, in millimetres: full in the middle, fading out to its edge. */
  centre: ChartPoint
  radii: ChartPoint
  /** How much redder it turns, as a fraction of the amplitude; below 0 paler. */
  amount: number
  /** Weights of the blendshapes that cause it, by ARKit's names. */
  cause: SkinRegion['cause']
  /**
   * Seconds, see `TimeDriver`. Skin reddens over seconds and stays red for longer; pressed, it turns pale at once, and takes about a second
   * to refill: 1.0 s in men and 1.2 s in women, 4.5 s in the elderly, are upper limits of the normal (Schriger, Baraff 1988).
   */
  attack: number
  release: number
}

const ENDS = SIDES.map(([, name]) => name)

/** Blendshapes of one side, or half of each. */
function causeOf(weights: Readonly<Record<string, number>>, ends: readonly string[]): SkinRegion['cause'] {
  return Object.fromEntries(
    Object.entries(weights).flatMap(([shape, weight]) =>
      ends.map((end) => [shape + end, weight / ends.length]),
    ),
  )
}

/** A muscle that works reddens the skin over it within seconds. */
const REDDENING = { attack: 1.2, release: 4 }
const PRESSING = { attack: 0.08, release: 0.9 }

/**
 * The flushes of a face: between the brows, beside the nose, on the cheeks, and the pale lips of a pressed mouth.
 *
 * @param isMirrored whether left and right use the same texels: both sides then redden together, driven half by each.
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

/** How far a flush has faded at a point of the chart: 1 in its middle, 0 from its edge on. */
export function fadeOf({ centre, radii }: Flush, [across, up]: ChartPoint): number {
  const square = ((across - centre[0]) / radii[0]) ** 2 + ((up - centre[1]) / radii[1]) ** 2
  return square >= 1 ? 0 : (1 - square) ** 2
}
