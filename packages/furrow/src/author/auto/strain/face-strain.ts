import { lerp } from '../../../math/scalar.ts'
import { FaceRng } from '../anatomy/face-rng.ts'
import type { FaceContext, FaceRegion } from '../anatomy/region.ts'
import type { AutoRegion } from '../anatomy/region-names.ts'
import { faceRegions } from '../anatomy/regions.ts'
import type { DetectedFace } from '../surface/detect-face.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import { poseOf } from '../surface/pose.ts'
import { poseInRigShapes } from '../surface/stand-ins.ts'
import { FACE_SIGMA, poseStrain } from './pose-strain.ts'

/** Region of a face, and the compression of the skin in the expression that creases the region. */
export interface StrainedRegion {
  /** Region. Its `cause` contains the names of the rig's blendshapes instead of ARKit names. */
  region: FaceRegion
  /** Result of `compressionTensors` for the expression. Regions with the same expression share the array. */
  tensors: Float64Array
}

/** Requested regions, random seeds and symmetry; see `AutoOptions`. */
export interface RegionSettings {
  seed: number
  seeds: Readonly<Partial<Record<AutoRegion, number>>>
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
  { landmarks, chart }: Pick<DetectedFace, 'landmarks' | 'chart'>,
  ageFraction: number,
  { seed, seeds, symmetry }: Pick<RegionSettings, 'seed' | 'seeds' | 'symmetry'>,
): FaceContext {
  return {
    landmarks,
    ageFraction,
    radiusAt: (point: ChartPoint) => chart.radiusAt(point),
    byAge: (at20: number, at80: number) => lerp(at20, at80, ageFraction),
    rngOf: (name: string) => FaceRng.of(seeds[regionOf(name)] ?? seed, name, symmetry),
  }
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
