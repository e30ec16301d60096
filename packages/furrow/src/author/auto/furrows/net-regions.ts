import { lerp } from '../../../math/scalar.ts'
import type { AutoRegion } from '../anatomy/region-names.ts'
import { type ChartPoint, unroll } from '../surface/head-chart.ts'
import type { Landmarks } from '../surface/landmarks.ts'

/** Part of a face whose fine furrows deepen and smooth out together. */
export interface NetRegion {
  /** Name of the area that shows the furrows. */
  name: string
  /** The part gets furrows if the user requested at least one of these regions. */
  regions: readonly AutoRegion[]
  /**
   * Spheres that contain the part. Each sphere is centred on the skin at a position on the head's chart (the head unrolled into a plane). Radii
   * are in millimetres.
   */
  spheres: readonly { centre: ChartPoint; radius: number }[]
  /** Size of the cells between furrows, in millimetres. */
  size: number
  /** Depth of the furrows at rest, in millimetres. */
  depth: number
}

/** Sizes of the cells between furrows, and depths of the furrows, at the age of 30, in millimetres. */
const AT_30 = {
  forehead: { size: 1.3, depth: 0.04 },
  brows: { size: 1.3, depth: 0.04 },
  nose: { size: 1.25, depth: 0.025 },
  eye: { size: 1.2, depth: 0.04 },
  cheek: { size: 1.4, depth: 0.04 },
  mouth: { size: 1.3, depth: 0.04 },
  neck: { size: 1.7, depth: 0.05 },
} as const

/**
 * Factors on the values of `AT_30`, by age. The depth is constant until the age of 40, then grows, and has doubled at 80. The number of
 * furrows falls (Corcuff et al. 1983, Skin relief and aging). With age, more and more furrows have the same direction (Lagarde et al. 2005,
 * Topography and anisotropy of the skin surface with ageing). `stretch` is the ratio of a cell's length to its width.
 */
const BY_AGE = [
  { years: 20, size: 1, depth: 1, stretch: 1.25 },
  { years: 40, size: 1, depth: 1, stretch: 1.35 },
  { years: 50, size: 1.06, depth: 1.2, stretch: 1.5 },
  { years: 80, size: 1.3, depth: 2.1, stretch: 2 },
] as const

export function ageOfNet(years: number): { size: number; depth: number; stretch: number } {
  const next = Math.max(
    1,
    BY_AGE.findIndex((row) => row.years >= years),
  )
  const [from, to] = [BY_AGE[next - 1], BY_AGE[next]]
  const t = (years - from.years) / (to.years - from.years)
  return {
    size: lerp(from.size, to.size, t),
    depth: lerp(from.depth, to.depth, t),
    stretch: lerp(from.stretch, to.stretch, t),
  }
}

export function netRegionsOf(landmarks: Landmarks, age: number): NetRegion[] {
  const at = ([x, y, z]: Landmarks['eye']) => unroll(x, y, z)
  const [, brow] = at(landmarks.innerBrow)
  const [outer] = at(landmarks.outerCorner)
  const [eye] = at(landmarks.eye)
  const [corner, mouth] = at(landmarks.mouthCorner)
  const tip = landmarks.tip[1]
  const forehead = lerp(brow, landmarks.hairline, 0.55)
  const cheek = lerp(landmarks.eye[1], mouth, 0.62)
  const older = ageOfNet(age)
  const cells = (part: keyof typeof AT_30) => ({
    size: AT_30[part].size * older.size,
    depth: AT_30[part].depth * older.depth,
  })
  const both = (part: NetRegion): NetRegion[] => [
    { ...part, name: `${part.name}Left` },
    {
      ...part,
      name: `${part.name}Right`,
      spheres: part.spheres.map(({ centre: [across, up], radius }) => ({ centre: [-across, up], radius })),
    },
  ]
  const sphere = (across: number, up: number, radius: number) => ({ centre: [across, up] as const, radius })
  return [
    {
      name: 'furrowsForehead',
      regions: ['foreheadInner', 'foreheadOuter'],
      spheres: [sphere(0, forehead, 40), sphere(-42, forehead - 4, 38), sphere(42, forehead - 4, 38)],
      ...cells('forehead'),
    },
    {
      name: 'furrowsBrows',
      regions: ['glabella', 'noseRoot'],
      spheres: [sphere(0, brow + 2, 24)],
      ...cells('brows'),
    },
    { name: 'furrowsNose', regions: ['nose'], spheres: [sphere(0, tip + 8, 26)], ...cells('nose') },
    ...both({
      name: 'furrowsEye',
      regions: ['crowsFeet', 'underEye'],
      spheres: [sphere(eye, -16, 26), sphere(outer + 12, -4, 28)],
      ...cells('eye'),
    }),
    ...both({
      name: 'furrowsCheek',
      regions: ['nasolabial', 'mouthCorner'],
      spheres: [sphere(eye + 4, cheek, 34), sphere(eye + 32, cheek, 38), sphere(corner + 22, mouth - 8, 34)],
      ...cells('cheek'),
    }),
    {
      name: 'furrowsMouth',
      regions: ['upperLip', 'lowerLip', 'chin'],
      spheres: [sphere(0, mouth, 36), sphere(0, landmarks.chin + 8, 32)],
      ...cells('mouth'),
    },
    {
      name: 'furrowsNeck',
      regions: ['neck'],
      spheres: [
        sphere(0, landmarks.chin - 40, 44),
        sphere(-50, landmarks.chin - 36, 44),
        sphere(50, landmarks.chin - 36, 44),
      ],
      ...cells('neck'),
    },
  ]
}
