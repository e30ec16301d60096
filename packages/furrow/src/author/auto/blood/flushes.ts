import { SIDES, type SkinRegion } from '../anatomy/region.ts'
import { type ChartPoint, unroll } from '../surface/head-chart.ts'
import type { Landmarks } from '../surface/landmarks.ts'

/** Part of a face whose blood an expression changes. */
export interface Flush {
  /** Name of its area. */
  name: string
  /** Areas of which at least one must have lines. */
  areas: readonly string[]
  /** Ellipse on the head's chart in millimetres, fading from its centre to its edge. */
  centre: ChartPoint
  radii: ChartPoint
  /** Increase of redness as a fraction of the amplitude; negative is paler. */
  amount: number
  /** Weights of the blendshapes that cause it, by ARKit names. */
  cause: SkinRegion['cause']
  /**
   * Time constants in seconds, see `TimeDriver`. Skin reddens over seconds and stays red for longer.
   * Pressed skin turns pale at once and refills within about a second. Upper limits of normal are 1.0 s in men, 1.2 s in women and 4.5 s
   * in the elderly (Schriger, Baraff 1988).
   */
  attack: number
  release: number
}

const ENDS = SIDES.map(([, name]) => name)

/** Expands weights to one side's blendshapes, or to both sides at half the weight. */
function causeOf(weights: Readonly<Record<string, number>>, ends: readonly string[]): SkinRegion['cause'] {
  return Object.fromEntries(
    Object.entries(weights).flatMap(([shape, weight]) =>
      ends.map((end) => [shape + end, weight / ends.length]),
    ),
  )
}

/** Working muscles redden the skin over them within seconds. */
const REDDENING = { attack: 1.2, release: 4 }
const PRESSING = { attack: 0.08, release: 0.9 }

/**
 * Returns the flushes of a face: between the brows, beside the nose, on the cheeks, and the pale lips of a pressed mouth.
 *
 * @param isMirrored whether left and right share texels: both sides then redden together, each driving half.
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

/** Returns the fade of a flush at a chart point: 1 at its centre, 0 from its edge. */
export function fadeOf({ centre, radii }: Flush, [across, up]: ChartPoint): number {
  const square = ((across - centre[0]) / radii[0]) ** 2 + ((up - centre[1]) / radii[1]) ** 2
  return square >= 1 ? 0 : (1 - square) ** 2
}
