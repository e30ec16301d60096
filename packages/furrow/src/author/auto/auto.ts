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
import { type OddMeasure, oddMeasures } from './anatomy/proportions.ts'
import { type AutoBlood, drawBlood, withoutBlood } from './blood/draw-blood.ts'
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

/** An area and its driver. */
export interface AutoArea {
  name: string
  /** Index of its layer. */
  layer: number
  weights: GrayImage
  driver: MorphDriver
  /** Keeps its lines at rest by the input `age`; of a face alone. */
  ageing?: AgeDriver | undefined
  /** Fraction by which its expression shortens the skin across its lines. */
  compression: number
  /** Root mean square of the driver's activation less the measured one, over single targets and combinations, 0..1. */
  error: number
  lines: number
}

/** Wrinkles made from blendshapes. */
export interface AutoWrinkles {
  /** Positions of the features, if a face was detected; otherwise the lines are placed by strain alone. */
  landmarks: Landmarks | undefined
  /** Names of the targets that were used: all but broken ones. */
  targets: string[]
  /** That of fine furrows, which has no strokes, is the last one. */
  layers: AutoLayer[]
  /** The net of fine furrows, where one was asked for and texels are small enough. */
  furrows: AutoFurrows | undefined
  /** Maps of the layers, and areas that show nothing else. */
  blood: AutoBlood
  areas: AutoArea[]
  /** Millimetres per unit of the skin's positions: a face is measured by the distance of its eyes. */
  scale: number
  /** Parts of a face that get no area, and why. */
  missing: MissingRegion[]
  /** Presets of the blendshapes that the face has; the drivers of its areas add the wrinkles. */
  expressions: ExpressionDriver[]
  /** One sentence each. */
  warnings: string[]
  /** Why there are no areas, as part of a sentence; undefined where there are some. */
  emptyReason: string | undefined
}

/**
 * Called before each step, as parts of it are done, and at the end. An error that it throws ends the work and is passed on.
 *
 * @param done steps that are done, with the fraction of the current one.
 */
export type AutoProgress = (done: number, total: number, step: string) => void

/** Steps of `autoWrinkles`, in order. */
export const AUTO_STEPS = ['face', 'lines', 'drivers', 'layers', 'maps'] as const

/**
 * Makes wrinkles from a character's own blendshapes: skin creases where they compress it, and on a face as its anatomy has it. The same
 * input and seed give the same maps, bit for bit.
 *
 * @throws FurrowError when the skin has no targets, no UV area, or values that are NaN or infinite; when regions are chosen and no face is
 *   detected; when furrows are wanted and there is one layer; when an option is unknown or out of range.
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

  if (settings.furrows && settings.layers < 2) throw withoutLayer()

  // One room per stage, each using those before it: surface -> strain -> lines -> fit -> raster -> blood, furrows.
  begin('face')
  const prepared = prepareSkin(skin)
  if (!prepared.face && options.regions) throw regionsWithoutFace(options.regions)
  const odd = prepared.face && !options.regions ? oddMeasures(prepared.face) : []
  const doubtful = new Set(odd.flatMap(({ regions }) => regions))
  const regions = settings.regions.filter((region) => !doubtful.has(region))
  const lineSettings = { ...settings, regions, ageFraction: (age - 20) / 60, maxAreas }
  const lineProgress = begin('lines')
  // The strain is the largest of the data: it is freed once the lines are laid.
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
  if (furrows) blood.maps.push(withoutBlood(settings.size))
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
      ...stylised(odd),
      ...fitted.warnings,
      ...(settings.furrows && !face ? ['fine furrows are of faces alone, and none is drawn'] : []),
    ],
    emptyReason: fitted.regions.length > 0 ? undefined : emptyReasonOf(prepared.isUnknownHead),
  }
}

/** The lines of all layers, and the net of fine furrows, as a document that `parseStrokes` reads. */
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
    ? 'no blendshapes show where its eyes and mouth are, as blinks and smiles do, though some have names of a face or part it as lips do, so nothing tells where it folds'
    : 'no blendshape compresses the skin enough to crease it'
}

/** One line about a head on which landmarks fail. */
function stylised(odd: readonly OddMeasure[]): string[] {
  if (odd.length === 0) return []
  const measures = odd.map(({ what }) => what).join('; ')
  return [
    `the head is stylised (${measures}, where the eyes are 63 mm apart): regions that rely on this are left out unless they are asked for`,
  ]
}

function withoutLayer(): FurrowError {
  return new FurrowError({
    who: 'autoWrinkles',
    problem: 'fine furrows need a layer besides those of lines',
    value: '1 layer',
    limit: '2 to 4',
    remedy: 'allow one more layer, or leave the furrows out',
  })
}

function regionsWithoutFace(regions: readonly string[]): FurrowError {
  return new FurrowError({
    who: 'autoWrinkles',
    problem: 'regions cannot be chosen, since no face was found by what the blendshapes move',
    value: regions.join(', '),
    remedy: 'leave the regions out, or name the mesh of the face',
  })
}

/** The presets that a face can show, with its targets, without activations of areas that it lacks. */
function presetsOf({ names, hints, find }: DetectedFace): ExpressionDriver[] {
  const loaderFinds = targetFinder(names)
  const ownNames = (shape: string) => {
    const found = find(shape)
    const loaded = loaderFinds(shape)
    const isSame = loaded.length > 0 && loaded.every((target) => found.includes(target))
    if (found.length === 0 || isSame) return found.slice(0, 1).map(() => shape)
    // The loader knows this rig's names as they are and no others.
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
