import { lerp } from '../../../math/scalar.ts'
import { cornersOf } from '../../skin/surface.ts'
import { barycentricsAt } from '../../skin/walk.ts'
import { eyeOpening } from '../anatomy/eye-opening.ts'
import { FaceRng } from '../anatomy/face-rng.ts'
import type { EyeOpening, FaceContext, FaceRegion, Side } from '../anatomy/region.ts'
import type { AutoRegion, DenseRegion } from '../anatomy/region-names.ts'
import { faceRegions } from '../anatomy/regions.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import { type ChartPoint, unroll } from '../surface/head-chart.ts'
import { type Pose, poseOf } from '../surface/pose.ts'
import { poseInRigShapes } from '../surface/stand-ins.ts'
import { FACE_SIGMA, poseStrain } from './pose-strain.ts'

/** Distances, in millimetres, of the points whose mean motion is taken. The mean smooths the edges of triangles. */
const AROUND = [-4, 0, 4] as const

/** Region of a face, and the compression of the skin in the expression that creases the region. */
export interface StrainedRegion {
  /** Region. Its `cause` contains the names of the rig's blendshapes instead of ARKit names. */
  region: FaceRegion
  /** Result of `compressionTensors` for the expression. Regions with the same expression share the array. */
  tensors: Float64Array
}

/** Requested regions, their random seeds and numbers of lines, and symmetry; see `AutoOptions`. */
export interface RegionSettings {
  seed: number
  seeds: Readonly<Partial<Record<AutoRegion, number>>>
  densities: Readonly<Partial<Record<DenseRegion, number>>>
  symmetry: number
  regions: readonly AutoRegion[]
}

/** Returns the region whose seed applies to a random number generator with the given name. */
function regionOf(name: string): AutoRegion {
  const region = name.replace(/(Left|Right)$/, '')
  return region === 'forehead' ? 'foreheadInner' : (region as AutoRegion)
}

/**
 * Returns the input for creating the regions of a face.
 *
 * @param ageFraction age as a number from 0 (20 years) to 1 (80 years).
 */
export function faceContext(
  { landmarks, chart, surface, offsets, find }: DetectedFace,
  ageFraction: number,
  { seed, seeds, densities, symmetry }: Omit<RegionSettings, 'regions'>,
): FaceContext {
  const radiusAt = (point: ChartPoint) => chart.radiusAt(point)
  const openings = new Map<Side, EyeOpening>()
  return {
    landmarks,
    ageFraction,
    radiusAt,
    openingOf: (side: Side) => {
      const opening = openings.get(side) ?? eyeOpening({ landmarks, radiusAt }, side)
      openings.set(side, opening)
      return opening
    },
    posedBy: (expression: Readonly<Record<string, number>>) => {
      const pose = poseOf(find, expression)
      return (point: ChartPoint) => posedPoint({ chart, surface, offsets }, pose, point)
    },
    motionOf: (expression: Readonly<Record<string, number>>) => {
      const pose = poseOf(find, expression)
      return ([across, up]: ChartPoint): ChartPoint => {
        const around = AROUND.flatMap((x) => AROUND.map((y) => [across + x, up + y] as const))
        const moved = around.map((point) => {
          const posed = posedPoint({ chart, surface, offsets }, pose, point)
          return posed ? unroll(...posed) : point
        })
        const motion = (k: 0 | 1) =>
          moved.reduce((sum, point, i) => sum + point[k] - around[i][k], 0) / around.length
        return [across + motion(0), up + motion(1)]
      }
    },
    byAge: (at20: number, at80: number) => lerp(at20, at80, ageFraction),
    densityOf: (region) => densities[region] ?? 1,
    rngOf: (name: string) => FaceRng.of(seeds[regionOf(name)] ?? seed, name, symmetry),
  }
}

function posedPoint(
  { chart, surface, offsets }: Pick<DetectedFace, 'chart' | 'surface' | 'offsets'>,
  pose: Pose,
  point: ChartPoint,
): [x: number, y: number, z: number] | undefined {
  const found = chart.find(point)
  if (!found) return undefined
  const weights = new Float64Array(3)
  barycentricsAt(weights, surface, found.triangle, Float64Array.from(found.position))
  const corners = cornersOf(surface, found.triangle)
  const posed = (k: 0 | 1 | 2) => {
    let sum = found.position[k]
    for (const [target, weight] of pose)
      for (const [c, corner] of corners.entries())
        sum += weight * weights[c] * offsets[target][3 * corner + k]
    return sum
  }
  return [posed(0), posed(1), posed(2)]
}

/**
 * Measures, for each region of a face, how the region's expression compresses the skin.
 *
 * @param ageFraction age as a number from 0 (20 years) to 1 (80 years).
 */
export function strainFaceRegions(
  face: DetectedFace,
  ageFraction: number,
  settings: RegionSettings,
  report: (fraction: number) => void,
): StrainedRegion[] {
  const context = faceContext(face, ageFraction, settings)
  const regions = faceRegions(context, settings.regions).map((inArkit) => {
    const cause = poseInRigShapes(inArkit.cause, face.known, face.hints)
    const expression = poseInRigShapes(inArkit.expression ?? inArkit.cause, face.known, face.hints)
    const region: FaceRegion = { ...inArkit, cause, shapes: Object.keys(inArkit.cause) }
    return { region, expression, key: JSON.stringify(expression) }
  })
  const count = new Set(regions.map(({ key }) => key)).size
  const known = new Map<string, Float64Array>()
  return regions.map(({ region, expression, key }, i) => {
    report(i / regions.length)
    const pose = poseOf(face.find, expression)
    const tensors = known.get(key) ?? poseStrain(face.surface, face.offsets, pose, FACE_SIGMA, count)
    known.set(key, tensors)
    return { region, tensors }
  })
}
