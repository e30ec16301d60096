import { FurrowError } from '../../core/error.ts'
import type { GrayImage } from '../../core/types.ts'
import type { AgeDriver } from '../../drivers/age/definition.ts'
import type { BoneDriver } from '../../drivers/bone/definition.ts'
import type { ExpressionDriver } from '../../drivers/expression/definition.ts'
import type { MorphDriver } from '../../drivers/morph/definition.ts'
import type { Skin } from '../skin/surface.ts'
import type { StrokesDocument } from '../strokes/document.ts'
import { valleyBlood } from '../valley-blood.ts'
import { faceSeed } from './anatomy/face-seed.ts'
import { type ImplausibleMeasure, implausibleMeasures } from './anatomy/proportions.ts'
import { type AutoBlood, drawBlood, neutralBlood } from './blood/draw-blood.ts'
import { drawKnuckles } from './blood/draw-knuckles.ts'
import { BULGES_FROM } from './bulges/bulge-driver.ts'
import { type BulgeArea, drawBulges } from './bulges/draw-bulges.ts'
import { planBulges } from './bulges/plan-bulges.ts'
import { regionsAt } from './bulges/regions.ts'
import { ageDriver } from './fit/age-driver.ts'
import { facePresets } from './fit/face-presets.ts'
import type { MissingRegion } from './fit/fit-driver.ts'
import { fitDrivers } from './fit/fit-drivers.ts'
import { assignLayers } from './fit/layers.ts'
import { type AutoFurrows, drawNet } from './furrows/draw-net.ts'
import { planNet } from './furrows/plan-net.ts'
import { areaSizeFor, clothMapSize, coarseWarnings } from './joints/area-size.ts'
import { creaseJoints } from './joints/crease-joints.ts'
import { layLines } from './lines/lay-lines.ts'
import { AUTO_DEFAULTS, type AutoOptions, checkAutoOptions } from './options.ts'
import { type AutoLayer, drawMaps } from './raster/draw-maps.ts'
import { measureStrain } from './strain/measure-strain.ts'
import type { Landmarks } from './surface/landmarks.ts'
import { type PreparedSkin, prepareSkin } from './surface/prepare-skin.ts'

/** Area of influence (a map of weights that tells where a group of wrinkles appears), with the drivers that compute its activation. */
export interface AutoArea {
  name: string
  /** Index of the area's layer. */
  layer: number
  weights: GrayImage
  driver: MorphDriver
  /** Driver that shows the lines on the neutral face, depending on the input `age`. Undefined if the lines vanish at rest. */
  ageing?: AgeDriver | undefined
  /** Fraction of length that the skin loses across the lines, in the expression that causes the lines. */
  compression: number
  /**
   * Root mean square error of the driver's activation, 0..1, over poses with one or several blendshapes. The correct activation of a pose is
   * computed from the compression that the pose causes. 0 if the driver was not fitted to compression.
   */
  error: number
  /** Number of wrinkle lines. */
  lines: number
}

/** Area of skin that joints fold, with the drivers that compute its activation from the angles of joints. */
export interface JointArea
  extends Pick<AutoArea, 'name' | 'layer' | 'weights' | 'compression' | 'error' | 'lines'> {
  drivers: readonly BoneDriver[]
  /** Fraction of length that cloth loses, if its folds take up only `compression`. Neighbouring cloth and the body limit the folds. */
  lost?: number
}

/** Wrinkles made from blendshapes and joints. */
export interface AutoWrinkles {
  /** Positions of facial features. Undefined if no face was detected; the lines are then placed by the compression of the skin alone. */
  landmarks: Landmarks | undefined
  /** Names of the blendshapes that were used: all except broken ones. */
  targets: string[]
  /** Layers with wrinkle lines, then the layer with bulges. If there are fine furrows, the last layer contains them and has no strokes. */
  layers: AutoLayer[]
  /** Pattern of fine furrows. Undefined if furrows are disabled, if texels are too large for furrows, or if no face was detected. */
  furrows: AutoFurrows | undefined
  /** Areas of skin that rises with age, all on one layer. Empty if the option `age` is missing or at most 35. */
  bulges: BulgeArea[]
  /** Blood maps of the layers, and areas that show only blood (reddened or pale skin). */
  blood: AutoBlood
  /** Areas that blendshapes activate. */
  areas: AutoArea[]
  /** Areas that joints activate. */
  jointAreas: JointArea[]
  /** Millimetres per unit of the skin's positions. On faces, it is derived from the distance between the eyes. */
  scale: number
  /** Random seed that was used. The same seed draws the same lines. */
  seed: number
  /** Regions of the face that got no area, with reasons. */
  missing: MissingRegion[]
  /** Expression presets, which name the face's own blendshapes. They set blendshape weights only; the areas' drivers add the wrinkles. */
  expressions: ExpressionDriver[]
  /** Each warning is a complete sentence without a full stop. */
  warnings: string[]
  /** Reason why there are no areas: a clause for a message. Undefined if there are areas. */
  emptyReason: string | undefined
}

/**
 * Reports progress. It is called before each step, during the step, and at the end. An error that it throws stops the work.
 *
 * @param done number of finished steps, plus the finished fraction of the current step.
 * @param total number of steps.
 * @param step name of the current step.
 */
export type AutoProgress = (done: number, total: number, step: string) => void

export const AUTO_STEPS = ['face', 'lines', 'drivers', 'layers', 'maps'] as const

/** Maximum number of areas with lines. */
const MAX_AREAS = 64

/**
 * Makes wrinkles from a character's blendshapes and joints. Lines appear where these compress the skin. On faces, the lines follow paths known
 * from anatomy. The same input and seed produce bit-identical maps.
 *
 * @throws FurrowError if the skin has neither blendshapes nor a skeleton, no area in UV space, or NaN or infinite values.
 * @throws FurrowError if `regions` is set but no face is detected, or if `furrows` is set with only one layer.
 * @throws FurrowError if an option is unknown or out of range.
 */
export function autoWrinkles(
  skin: Skin,
  options: AutoOptions = {},
  progress: AutoProgress = () => {},
): AutoWrinkles {
  checkAutoOptions(options, 'autoWrinkles')
  const settings = { ...AUTO_DEFAULTS, ...options }
  const { age, areas: maxAreas } = settings
  const begin = (step: (typeof AUTO_STEPS)[number]) => {
    const report = (fraction: number) =>
      progress(AUTO_STEPS.indexOf(step) + fraction, AUTO_STEPS.length, step)
    report(0)
    return report
  }

  if (settings.furrows && settings.layers < 2) throw missingLayerError()

  // Each stage has a folder and uses the stages before it: surface -> strain -> lines -> fit -> raster -> blood, bulges, furrows.
  begin('face')
  // Blendshapes do not fold cloth.
  const prepared = prepareSkin(options.cloth === undefined ? skin : { ...skin, targets: [] })
  if (!prepared.face && options.regions) throw missingFaceError(options.regions)
  const seed = options.seed ?? (prepared.face ? faceSeed(prepared.face.landmarks) : 1)
  const unusual = prepared.face && !options.regions ? implausibleMeasures(prepared.face) : []
  const doubtful = new Set(unusual.flatMap(({ regions }) => regions))
  const wanted = regionsAt(options.age, settings.regions)
  const regions = wanted.filter((region) => !doubtful.has(region))
  const lineSettings = {
    ...settings,
    cloth: options.cloth,
    seed,
    regions,
    ageFraction: (age - 20) / 60,
    maxAreas,
  }
  const lineProgress = begin('lines')
  // The strain is not stored in a variable, so that its large arrays can be freed once the lines are laid.
  const creased = layLines(
    prepared,
    measureStrain(prepared, lineSettings, (fraction) => lineProgress(fraction / 2)),
    lineSettings,
    (fraction) => lineProgress((1 + fraction) / 2),
  )
  const fitted = fitDrivers(prepared, creased, maxAreas, begin('drivers'))
  const { regions: jointed, knuckles } = options.regions
    ? { regions: [], knuckles: [] }
    : creaseJoints(prepared, lineSettings, MAX_AREAS - fitted.regions.length)
  begin('layers')
  const { face } = prepared
  const drawnRegions = [...fitted.regions, ...jointed]
  const planned =
    face && settings.furrows ? planNet({ ...prepared, face }, { ...settings, seed, regions }) : undefined
  const lineLayers = planned?.net ? settings.layers - 1 : settings.layers
  const rising = face
    ? planBulges({ ...prepared, face }, { ...lineSettings, layers: lineLayers })
    : { bulges: [], missing: [] }
  const hasBulges = rising.bulges.length > 0
  const layerOf = assignLayers(drawnRegions, hasBulges ? lineLayers - 1 : lineLayers)
  const isEmpty = drawnRegions.length === 0 && !hasBulges
  const mapProgress = begin('maps')
  const mapSettings = {
    ...settings,
    size: options.cloth === undefined ? settings.size : clothMapSize(prepared, jointed, settings.size),
    areaSize: options.areaSize ?? areaSizeFor(prepared, jointed),
  }
  const drawn = isEmpty ? undefined : drawMaps(prepared, drawnRegions, layerOf, mapSettings, mapProgress)
  const { layers, weights } = drawn ?? { layers: [] as AutoLayer[], weights: [] }
  const blood = drawn
    ? drawBlood(prepared, { ...drawn, regions: drawnRegions, layerOf }, settings.strength)
    : { amplitude: 0, maps: [], areas: [] }
  if (drawn) blood.areas.push(...drawKnuckles(drawn, knuckles, blood.maps))
  const raised =
    drawn && face && hasBulges
      ? drawBulges(face, rising.bulges, drawn, { ...settings, years: age })
      : { layers: [], areas: [] }
  blood.maps.push(...raised.layers.map(({ heights }) => valleyBlood(heights)))
  layers.push(...raised.layers)
  const furrows =
    drawn && face && planned?.net ? drawNet({ ...prepared, face }, planned.net, drawn, settings) : undefined
  if (furrows) blood.maps.push(neutralBlood(settings.size))
  progress(AUTO_STEPS.length, AUTO_STEPS.length, 'done')

  const { names, scale } = prepared
  const areaOf = ({ region, compression, error, creases }: (typeof drawnRegions)[number], i: number) => ({
    name: region.name,
    layer: layerOf[i],
    weights: weights[i],
    compression,
    error,
    lines: creases.length,
  })
  const first = fitted.regions.length
  return {
    landmarks: face?.landmarks,
    targets: [...names],
    layers: furrows ? [...layers, furrows.layer] : layers,
    furrows: furrows?.net,
    blood,
    bulges: raised.areas,
    areas: fitted.regions.map((fit, i) => ({
      ...areaOf(fit, i),
      driver: fit.driver,
      ageing: ageDriver(fit.region, options.age),
    })),
    jointAreas: jointed.map((fold, i) => ({
      ...areaOf(fold, first + i),
      drivers: fold.drivers,
      ...(fold.lost !== undefined && { lost: fold.lost }),
    })),
    scale,
    seed,
    missing: [
      ...fitted.missing,
      ...wanted
        .filter((region) => doubtful.has(region))
        .map((name) => ({ name, reason: 'the head is stylised' })),
      ...rising.missing,
      ...(planned?.missing ?? []),
    ],
    expressions: face ? facePresets(face) : [],
    warnings: [
      ...prepared.warnings,
      ...stylisedWarnings(unusual),
      ...fitted.warnings,
      ...coarseWarnings(prepared, jointed, settings.size),
      ...(settings.furrows && !face ? ['fine furrows require a face; none are drawn'] : []),
    ],
    emptyReason: isEmpty
      ? emptyReasonOf(prepared, wanted.length === 0 && settings.regions.length > 0)
      : undefined,
  }
}

/** Returns the lines of all layers and the pattern of fine furrows as a strokes document, which `parseStrokes` accepts. */
export function strokesOf({
  layers,
  scale,
  seed,
  furrows: net,
}: Pick<AutoWrinkles, 'layers' | 'scale' | 'seed'> &
  Partial<Pick<AutoWrinkles, 'furrows'>>): StrokesDocument {
  const strokes = layers.flatMap(({ name, strokes }) => strokes.map((stroke) => ({ layer: name, ...stroke })))
  return {
    version: 1,
    scale,
    size: layers[0].heights.width,
    seed,
    strokes,
    ...(net && { furrows: net.furrows }),
  }
}

function emptyReasonOf({ isUnknownHead, names }: PreparedSkin, isTooYoung: boolean): string {
  if (isTooYoung) return `the chosen regions only bulge above the age of ${BULGES_FROM} years`
  if (names.length === 0) return 'no joint of a hand, a neck, an elbow, a knee or a waist folds the surface'
  return isUnknownHead
    ? 'the mesh looks like a head, but no blendshapes show where its eyes and mouth are (blinks and smiles would)'
    : 'no blendshape compresses the skin enough to crease it'
}

/** Returns a warning if measurements of the head are outside the human range, because its landmarks are then unreliable. */
function stylisedWarnings(unusual: readonly ImplausibleMeasure[]): string[] {
  if (unusual.length === 0) return []
  const measures = unusual.map(({ description }) => description).join('; ')
  return [
    `the head is stylised (${measures}; scaled to eyes 63 mm apart): affected regions are skipped unless requested`,
  ]
}

function missingLayerError(): FurrowError {
  return new FurrowError({
    who: 'autoWrinkles',
    problem: 'fine furrows need a separate layer',
    value: '1 layer',
    limit: '2 to 4',
    remedy: 'allow one more layer, or disable the furrows',
  })
}

function missingFaceError(regions: readonly string[]): FurrowError {
  return new FurrowError({
    who: 'autoWrinkles',
    problem: 'regions require a face, and none was detected from the blendshapes',
    value: regions.join(', '),
    remedy: 'omit the regions, or name the mesh of the face',
  })
}
