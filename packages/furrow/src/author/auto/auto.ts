import { FurrowError } from '../../core/error.ts'
import type { GrayImage } from '../../core/types.ts'
import type { AgeDriver } from '../../drivers/age/definition.ts'
import type { ExpressionDriver } from '../../drivers/expression/definition.ts'
import { canMove } from '../../drivers/expression/face-expressions.ts'
import { EXPRESSIONS } from '../../drivers/expression/presets.ts'
import type { MorphDriver } from '../../drivers/morph/definition.ts'
import { targetFinder } from '../../drivers/morph/target-names.ts'
import type { Skin } from '../skin/surface.ts'
import type { StrokesDocument } from '../strokes/document.ts'
import { type ImplausibleMeasure, implausibleMeasures } from './anatomy/proportions.ts'
import { type AutoBlood, drawBlood, neutralBlood } from './blood/draw-blood.ts'
import { ageDriver } from './fit/age-driver.ts'
import type { MissingRegion } from './fit/fit-driver.ts'
import { fitDrivers } from './fit/fit-drivers.ts'
import { assignLayers } from './fit/layers.ts'
import { type AutoFurrows, drawNet } from './furrows/draw-net.ts'
import { planNet } from './furrows/plan-net.ts'
import { layLines } from './lines/lay-lines.ts'
import { AUTO_DEFAULTS, type AutoOptions, checkAutoOptions } from './options.ts'
import { type AutoLayer, drawMaps } from './raster/draw-maps.ts'
import { measureStrain } from './strain/measure-strain.ts'
import type { DetectedFace } from './surface/detect-face.ts'
import type { Landmarks } from './surface/landmarks.ts'
import { prepareSkin } from './surface/prepare-skin.ts'

/** Area of influence with its driver. */
export interface AutoArea {
  name: string
  /** Index of the area's layer. */
  layer: number
  weights: GrayImage
  driver: MorphDriver
  /** Driver that shows the lines at rest, depending on the input `age`. Only faces have it. */
  ageing?: AgeDriver | undefined
  /** Fraction by which the region's expression shortens the skin across the lines. */
  compression: number
  /**
   * Root mean square difference, 0..1, between the driver's activation and the activation that follows from the measured compression. The
   * mean is over poses of single blendshapes and of combinations.
   */
  error: number
  /** Number of lines. */
  lines: number
}

/** Wrinkles made from blendshapes. */
export interface AutoWrinkles {
  /** Positions of facial features. Undefined if no face was detected; the lines are then placed by the compression of the skin alone. */
  landmarks: Landmarks | undefined
  /** Names of the blendshapes that were used: all except broken ones. */
  targets: string[]
  /** Layers with lines. If there are fine furrows, their layer comes last; it has no strokes. */
  layers: AutoLayer[]
  /** Pattern of fine furrows. Undefined if furrows are disabled, or texels are too large for them. */
  furrows: AutoFurrows | undefined
  /** Blood maps of the layers, and areas that show only blood. */
  blood: AutoBlood
  areas: AutoArea[]
  /** Millimetres per unit of the skin's positions. On faces, it is derived from the distance between the eyes. */
  scale: number
  /** Regions of the face that got no area, with reasons. */
  missing: MissingRegion[]
  /** Expression presets in the names of the face's blendshapes. They move blendshapes only; the areas' drivers add the wrinkles. */
  expressions: ExpressionDriver[]
  /** Complete sentences without a full stop. */
  warnings: string[]
  /** Reason why there are no areas, to be used in a sentence. Undefined if there are areas. */
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

/**
 * Makes wrinkles from a character's blendshapes. Skin creases where blendshapes compress it; on faces, creases follow the lines known from
 * anatomy. The same input and seed produce bit-identical maps.
 *
 * @throws FurrowError if the skin has no blendshapes, no area in UV space, or NaN or infinite values.
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

  // Each stage has a folder and uses the stages before it: surface -> strain -> lines -> fit -> raster -> blood, furrows.
  begin('face')
  const prepared = prepareSkin(skin)
  if (!prepared.face && options.regions) throw missingFaceError(options.regions)
  const unusual = prepared.face && !options.regions ? implausibleMeasures(prepared.face) : []
  const doubtful = new Set(unusual.flatMap(({ regions }) => regions))
  const regions = settings.regions.filter((region) => !doubtful.has(region))
  const lineSettings = { ...settings, regions, ageFraction: (age - 20) / 60, maxAreas }
  const lineProgress = begin('lines')
  // The strain is not stored in a variable, so that its large arrays can be freed once the lines are laid.
  const creased = layLines(prepared, measureStrain(prepared, lineSettings, lineProgress), lineSettings)
  const fitted = fitDrivers(prepared, creased, maxAreas, begin('drivers'))
  begin('layers')
  const { face } = prepared
  const planned =
    face && settings.furrows ? planNet({ ...prepared, face }, { ...settings, regions }) : undefined
  const layerOf = assignLayers(fitted.regions, planned?.net ? settings.layers - 1 : settings.layers)
  const drawn = drawMaps(prepared, fitted.regions, layerOf, settings, begin('maps'))
  const { layers, weights } = drawn ?? { layers: [], weights: [] }
  const blood = drawn
    ? drawBlood(prepared, { ...drawn, regions: fitted.regions, layerOf }, settings.strength)
    : { amplitude: 0, maps: [], areas: [] }
  const furrows =
    drawn && face && planned?.net ? drawNet({ ...prepared, face }, planned.net, drawn, settings) : undefined
  if (furrows) blood.maps.push(neutralBlood(settings.size))
  progress(AUTO_STEPS.length, AUTO_STEPS.length, 'done')

  const { names, scale } = prepared
  return {
    landmarks: face?.landmarks,
    targets: [...names],
    layers: furrows ? [...layers, furrows.layer] : layers,
    furrows: furrows?.net,
    blood,
    areas: fitted.regions.map(({ region, driver, compression, error, creases }, i) => ({
      name: region.name,
      layer: layerOf[i],
      weights: weights[i],
      driver,
      ageing: ageDriver(region, options.age),
      compression,
      error,
      lines: creases.length,
    })),
    scale,
    missing: [
      ...fitted.missing,
      ...[...doubtful].map((name) => ({ name, reason: 'the head is stylised' })),
      ...(planned?.missing ?? []),
    ],
    expressions: face ? presetsOf(face) : [],
    warnings: [
      ...prepared.warnings,
      ...stylisedWarnings(unusual),
      ...fitted.warnings,
      ...(settings.furrows && !face ? ['fine furrows require a face; none are drawn'] : []),
    ],
    emptyReason: fitted.regions.length > 0 ? undefined : emptyReasonOf(prepared.isUnknownHead),
  }
}

/** Returns the lines of all layers and the pattern of fine furrows as a strokes document, which `parseStrokes` accepts. */
export function strokesOf({
  layers,
  scale,
  furrows: net,
}: Pick<AutoWrinkles, 'layers' | 'scale'> & Partial<Pick<AutoWrinkles, 'furrows'>>): StrokesDocument {
  const strokes = layers.flatMap(({ name, strokes }) => strokes.map((stroke) => ({ layer: name, ...stroke })))
  return { version: 1, scale, size: layers[0].heights.width, strokes, ...(net && { furrows: net.furrows }) }
}

function emptyReasonOf(isUnknownHead: boolean): string {
  return isUnknownHead
    ? 'the mesh looks like a head, but no blendshapes show where its eyes and mouth are, as blinks and smiles do'
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

/** Returns the expression presets that a face's blendshapes can show. The presets have no activations. */
function presetsOf({ names, hints, find }: DetectedFace): ExpressionDriver[] {
  const loaderFinds = targetFinder(names)
  const ownNames = (shape: string) => {
    const found = find(shape)
    const loaded = loaderFinds(shape)
    const isSame = loaded.length > 0 && loaded.every((target) => found.includes(target))
    if (found.length === 0 || isSame) return found.slice(0, 1).map(() => shape)
    // Loaders do not find this shape by its ARKit name, so the preset must name the rig's blendshapes.
    const own = found.filter((target) => hints[target]?.match !== 'like')
    return own.length > 0 ? own.map((target) => names[target]) : [shape]
  }
  const [neutral, ...others] = EXPRESSIONS
  const possible = others.filter((expression) => canMove(expression, (shape) => find(shape).length > 0))
  return [neutral, ...possible].map(({ name, targets }) => {
    const weights = new Map<string, number>()
    for (const [shape, weight] of Object.entries(targets))
      for (const own of ownNames(shape)) weights.set(own, Math.max(weight, weights.get(own) ?? 0))
    return {
      type: 'expression',
      name,
      targets: [...weights].map(([own, weight]) => ({ name: own, weight })),
      activations: [],
    }
  })
}
