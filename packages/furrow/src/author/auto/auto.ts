import { FurrowError } from '../../core/error.ts'
import type { GrayImage, RgbaImage } from '../../core/types.ts'
import type { ExpressionDriver } from '../../drivers/expression/definition.ts'
import { EXPRESSIONS } from '../../drivers/expression/presets.ts'
import type { MorphDriver } from '../../drivers/morph/definition.ts'
import { surfaceMetric } from '../metric.ts'
import { heightToNormal, type TangentFrame } from '../relief/height-to-normal.ts'
import type { HeightMap } from '../strokes/height.ts'
import { AUTO_REGIONS, type AutoRegion } from './anatomy/regions.ts'
import type { CreasedRegion } from './crease.ts'
import { drawAreas, drawCreases } from './draw.ts'
import { type Landmarks, poseOf } from './face.ts'
import { faceRegions } from './face-regions.ts'
import { layersOf } from './layers.ts'
import { type FittedRegion, fitDriver } from './links.ts'
import { findOverlap, isOverlapped, leftTriangles, onBothSides } from './mirror.ts'
import { prepareSkin } from './prepare.ts'
import { standInsOf } from './stand-ins.ts'
import { strainRegions } from './strain-regions.ts'
import type { Skin, Surface } from './surface.ts'
import { MIP_MARGIN, SkinTexels } from './texels.ts'

/** How the wrinkles are made; `AUTO_DEFAULTS` where nothing is told. */
export interface AutoOptions {
  /** Years, 20..80: lines grow in number, length and depth. */
  age?: number
  /** Multiplies the depth, 0..2. */
  strength?: number
  /** Side of the maps in texels. */
  size?: number
  /** Side of the areas in texels. */
  areaSize?: number
  /** Any whole number; the same one gives the same wrinkles. */
  seed?: number
  /** Layers that there may be, 1..4. */
  layers?: number
  /** Areas that there may be, 1..64; those that are shortened least are left out. */
  areas?: number
  /** Parts of a face that may crease, all unless told. Without a face there are none to choose from. */
  regions?: readonly AutoRegion[]
  /** The frame in which renderers read the normal maps, see `heightToNormal`. */
  frame?: TangentFrame
}

/** What is done unless told otherwise. */
export const AUTO_DEFAULTS = {
  age: 45,
  strength: 1,
  size: 1024,
  areaSize: 128,
  seed: 1,
  layers: 4,
  areas: 24,
  regions: AUTO_REGIONS,
  frame: 'orthonormal',
} as const satisfies AutoOptions

/** Maps of one layer. */
export interface AutoLayer {
  name: string
  /** Of kind `detail`: wrinkles over nothing. */
  normal: RgbaImage
  relief: HeightMap
  /** 255 = open to the light. */
  occlusion: GrayImage
}

/** One area with what drives it. */
export interface AutoArea {
  name: string
  /** Index of its layer. */
  layer: number
  weights: GrayImage
  driver: MorphDriver
  /** Share by which its own expression shortens the skin across its lines. */
  compression: number
  /** Root mean square of the driver's activation less the measured one, over single targets and some together, 0..1. */
  error: number
  lines: number
}

/** What blendshapes say of wrinkles. */
export interface AutoWrinkles {
  /** Where the features are, if a face was found by what the targets move; otherwise strain alone placed the lines. */
  landmarks: Landmarks | undefined
  /** Names of the targets that were used: those that are not broken. */
  targets: string[]
  layers: AutoLayer[]
  areas: AutoArea[]
  /** Presets of those blendshapes that the face has; its areas' drivers add the wrinkles. */
  expressions: ExpressionDriver[]
  /** What the user should know, a sentence each. */
  warnings: string[]
}

/** Told before each step, and at the end. */
export type AutoProgress = (done: number, total: number, step: string) => void

/** What `autoWrinkles` does, in this order. */
export const AUTO_STEPS = ['face', 'lines', 'drivers', 'layers', 'maps'] as const

/**
 * Makes wrinkles from a character's own blendshapes: where they push the skin together it creases, and where a face is recognised
 * anatomy says how. The same input and seed give the same maps, bit by bit.
 *
 * @throws FurrowError when the skin has no targets, no texture coordinates that span a surface, or numbers that are none; when
 *   regions are asked for and no face is found.
 */
export function autoWrinkles(
  skin: Skin,
  options: AutoOptions = {},
  progress: AutoProgress = () => {},
): AutoWrinkles {
  const {
    age,
    strength,
    size,
    areaSize,
    seed,
    layers: most,
    areas: mostAreas,
    regions,
    frame,
  } = { ...AUTO_DEFAULTS, ...options }
  const tell = (step: (typeof AUTO_STEPS)[number]) =>
    progress(AUTO_STEPS.indexOf(step), AUTO_STEPS.length, step)
  tell('face')
  const { skin: usable, face, surface, offsets, warnings } = prepareSkin(skin)
  const names = usable.targets.map(({ name }) => name)
  if (!face && options.regions) throw noRegions(options.regions)
  const grown = (age - 20) / 60
  tell('lines')
  const overlap = findOverlap(usable, surface)
  const isMirrored = face !== undefined && overlap.isMirrored
  if (isMirrored)
    warnings.push('left and right share their texels: both sides crease at once, each driven by half')
  else if (isOverlapped(overlap)) {
    warnings.push(
      `${Math.round(100 * overlap.share)}% of the texture is used twice: what creases one place creases the other`,
    )
  }
  const creased = face
    ? faceRegions(face, grown, strength, seed, regions)
    : strainRegions(surface, offsets, names, grown, strength, seed, mostAreas)
  if (!face)
    warnings.push(
      'no face was found by what the blendshapes move: strain alone places the wrinkles, and carefully',
    )
  tell('drivers')
  const find = face?.find ?? ((name: string) => [names.indexOf(name)])
  const everyFit = creased.flatMap(
    (region) => fitDriver(surface, region, offsets, names, poseOf(find, region.region.cause)) ?? [],
  )
  const fitted = strongest(isMirrored ? onBothSides(everyFit, names, find) : everyFit, mostAreas)
  if (fitted.length === 0) warnings.push('no blendshape pushes skin together enough to crease it')
  const stoodIn = face ? standInsOf(names) : []
  if (stoodIn.length > 0) {
    const still = creased.filter(({ region }) => !everyFit.some((fit) => fit.region === region))
    const smooth = still.map(({ region }) => region.name).join(', ')
    warnings.push(
      `${stoodIn.join(', ')} stand in for ARKit's shapes${smooth && `; none moves these, which stay smooth: ${smooth}`}`,
    )
  }
  tell('layers')
  const layerOf = layersOf(fitted, most)
  tell('maps')
  const isDrawn = isMirrored ? leftTriangles(surface) : undefined
  const canvas = { surface, texels: new SkinTexels(usable, surface, size, isDrawn, MIP_MARGIN) }
  const small = { surface, texels: new SkinTexels(usable, surface, areaSize, isDrawn) }
  const metric = surfaceMetric({ ...usable, positions: inMetres(surface) }, size)
  const layers: AutoLayer[] = []
  const images = new Map<CreasedRegion, GrayImage>()
  for (let layer = 0; layer <= Math.max(-1, ...layerOf); layer++) {
    const regions = fitted.filter((_, i) => layerOf[i] === layer)
    const creases = [...new Set(regions.map((region) => region.creases))].flat()
    const drawn = drawCreases(canvas, creases)
    layers.push({ name: `auto${layer + 1}`, normal: heightToNormal(drawn.relief, metric, frame), ...drawn })
    for (const [i, image] of drawAreas(small, regions, face?.chart).entries()) images.set(regions[i]!, image)
  }
  progress(AUTO_STEPS.length, AUTO_STEPS.length, 'done')
  const areas = fitted.map((fit, i) => ({
    name: fit.region.name,
    layer: layerOf[i]!,
    weights: images.get(fit)!,
    driver: fit.driver,
    compression: fit.compression,
    error: fit.error,
    lines: fit.creases.length,
  }))
  return {
    landmarks: face?.landmarks,
    targets: names,
    layers,
    areas,
    expressions: face ? presetsOf(face.find) : [],
    warnings,
  }
}

function noRegions(asked: readonly string[]): FurrowError {
  return new FurrowError({
    who: 'autoWrinkles',
    what: 'regions cannot be chosen, since no face was found by what the blendshapes move',
    value: asked.join(', '),
    remedy: 'leave the regions out, or name the mesh of the face',
  })
}

/** `EXPRESSIONS` without the activations of areas that other faces have. */
function presetsOf(find: (name: string) => number[]): ExpressionDriver[] {
  return EXPRESSIONS.map(({ name, targets }) => ({
    type: 'expression',
    name,
    targets: Object.entries(targets).flatMap(([target, weight]) =>
      find(target).length > 0 ? [{ name: target, weight }] : [],
    ),
    activations: [],
  }))
}

/** Those whose skin loses most, in the order they came in. */
function strongest(fitted: readonly FittedRegion[], most: number): FittedRegion[] {
  const kept = new Set([...fitted].sort((a, b) => b.compression - a.compression).slice(0, most))
  return fitted.filter((fit) => kept.has(fit))
}

/** Positions of the skin's vertices as its surface is scaled. */
function inMetres({ pointOf, points }: Surface): Float64Array {
  const out = new Float64Array(3 * pointOf.length)
  for (const [vertex, point] of pointOf.entries()) {
    for (let k = 0; k < 3; k++) out[3 * vertex + k] = points[3 * point + k]! / 1000
  }
  return out
}
