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
import { type UnusualMeasure, unusualMeasures } from './anatomy/proportions.ts'
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

/** Area with its driver. */
export interface AutoArea {
  name: string
  /** Index of its layer. */
  layer: number
  weights: GrayImage
  driver: MorphDriver
  /** Age driver that keeps the lines at rest by the input `age`; faces only. */
  ageing?: AgeDriver | undefined
  /** Fraction by which its expression shortens the skin across the lines. */
  compression: number
  /** Root mean square error of the driver's activation against the measured one, over single targets and combinations, 0..1. */
  error: number
  lines: number
}

/** Wrinkles made from blendshapes. */
export interface AutoWrinkles {
  /** Positions of facial features; undefined if no face was detected and strain alone places the lines. */
  landmarks: Landmarks | undefined
  /** Names of the targets used: all except broken ones. */
  targets: string[]
  /** Layers of lines, then the layer of fine furrows, which has no strokes. */
  layers: AutoLayer[]
  /** Net of fine furrows; undefined if disabled or texels are too large. */
  furrows: AutoFurrows | undefined
  /** Blood maps of the layers, and areas that show only blood. */
  blood: AutoBlood
  areas: AutoArea[]
  /** Millimetres per unit of the skin's positions; faces are scaled by the distance of their eyes. */
  scale: number
  /** Parts of a face without an area, with reasons. */
  missing: MissingRegion[]
  /** Presets for the face's blendshapes; the drivers of the areas add the wrinkles. */
  expressions: ExpressionDriver[]
  /** Complete sentences without a full stop. */
  warnings: string[]
  /** Reason for missing areas, as part of a sentence; undefined if there are areas. */
  emptyReason: string | undefined
}

/**
 * Reports progress: called before each step, during it, and at the end. Errors it throws abort the work and are passed on.
 *
 * @param done finished steps, plus the fraction of the current one.
 */
export type AutoProgress = (done: number, total: number, step: string) => void

export const AUTO_STEPS = ['face', 'lines', 'drivers', 'layers', 'maps'] as const

/**
 * Makes wrinkles from a character's blendshapes: skin creases where they compress it, on faces along anatomical lines. The same input and
 * seed give bit-identical maps.
 *
 * @throws FurrowError if the skin has no targets, no UV area, or NaN or infinite values.
 * @throws FurrowError if regions are chosen without a face, or furrows with only one layer.
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

  // One folder per stage, each using the previous ones: surface -> strain -> lines -> fit -> raster -> blood, furrows.
  begin('face')
  const prepared = prepareSkin(skin)
  if (!prepared.face && options.regions) throw missingFaceError(options.regions)
  const unusual = prepared.face && !options.regions ? unusualMeasures(prepared.face) : []
  const doubtful = new Set(unusual.flatMap(({ regions }) => regions))
  const regions = settings.regions.filter((region) => !doubtful.has(region))
  const lineSettings = { ...settings, regions, ageFraction: (age - 20) / 60, maxAreas }
  const lineProgress = begin('lines')
  // Strain is the largest data, so it is not kept in a variable: it can be freed once the lines are laid.
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

/** Returns the lines of all layers and the net of fine furrows as a document for `parseStrokes`. */
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

/** Returns a warning about a head whose landmarks are unreliable. */
function stylisedWarnings(unusual: readonly UnusualMeasure[]): string[] {
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

/** Returns the presets that a face can show, without activations. */
function presetsOf({ names, hints, find }: DetectedFace): ExpressionDriver[] {
  const loaderFinds = targetFinder(names)
  const ownNames = (shape: string) => {
    const found = find(shape)
    const loaded = loaderFinds(shape)
    const isSame = loaded.length > 0 && loaded.every((target) => found.includes(target))
    if (found.length === 0 || isSame) return found.slice(0, 1).map(() => shape)
    // The loader knows this rig only by its own names.
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
