import type { ChartSamples } from '../buckling/sample-chart.ts'
import type { LimbSkin } from '../limbs/limb-skin.ts'
import type { RegionCreases } from '../lines/crease.ts'
import { clothCreases } from './cloth-creases.ts'
import { buckleCloth, type ClothTube } from './cloth-film.ts'
import { fitHeights } from './fit-heights.ts'
import { type Ridge, traceRidges } from './ridges.ts'

/** Maximum height of a fold in wavelengths. Neighbouring cloth and the body limit it. */
const MAX_HEIGHT = 0.3

/** Returns further lines on the chart of a tube. */
type MoreLines = (samples: ChartSamples, tube: ClothTube) => Ridge[]

/** Returns the part of a region's plan that all folds of cloth share. See `layFolds` for the parameters. */
export function foldPlan(limb: LimbSkin, tube: ClothTube, strength: number, more?: MoreLines) {
  const { wavelength } = tube
  return {
    spacing: wavelength,
    creasedFraction: 1,
    maxDepth: MAX_HEIGHT * wavelength,
    reach: 0.55 * wavelength,
    feather: 0.6 * wavelength,
    crease: (tensors: Float64Array) => layFolds(limb, tube, tensors, strength, more),
  }
}

/**
 * Lets the cloth of a tube buckle, and converts its folds to strokes.
 *
 * @param tensors result of `turnTensors`.
 * @param strength factor on the heights.
 * @param more returns further lines on the chart.
 * @returns undefined if the mesh has no cloth there.
 */
function layFolds(
  { prepared }: LimbSkin,
  tube: ClothTube,
  tensors: Float64Array,
  strength: number,
  more: MoreLines = () => [],
): RegionCreases | undefined {
  const { wavelength } = tube
  const cloth = buckleCloth(prepared.surface, tube, tensors)
  if (!cloth) return undefined
  const ridges = [...traceRidges(cloth, tube), ...more(cloth.samples, tube)]
  const heights = fitHeights(cloth, ridges, { wavelength, limit: MAX_HEIGHT * wavelength })
  const scaled = heights.map((own) => own.map((height) => strength * height))
  return clothCreases(prepared, { cloth, ridges, heights: scaled })
}
