import type { Layer, WrinkleSet } from '../../core/types.ts'
import type { AgeDriver } from '../../drivers/age/definition.ts'
import type { ExpressionDriver } from '../../drivers/expression/definition.ts'
import type { MorphDriver } from '../../drivers/morph/definition.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import type { TimeDriver } from '../../drivers/time/definition.ts'
import type { HeightMap } from '../strokes/height.ts'
import type { AutoWrinkles } from './auto.ts'
import { halfSide, heightLevels } from './raster/half-side.ts'

export type AutoDriver = MorphDriver | AgeDriver | TimeDriver | ExpressionDriver

type Heights = Required<Pick<Layer, 'height' | 'heightAmplitude'>>

/**
 * Converts the result of `autoWrinkles` to a wrinkle set with heights, drivers and expressions. A page can show it with
 * `new Wrinkles(mesh, autoWrinkleSet(wrinkles))`.
 */
export function autoWrinkleSet({
  layers,
  areas,
  blood,
  furrows,
  expressions,
}: Pick<AutoWrinkles, 'layers' | 'areas' | 'blood' | 'furrows' | 'expressions'>): WrinkleSet & {
  drivers: WrinkleDriver[]
} {
  return {
    layers: layers.map(({ name, normal, occlusion, heights }, i) => ({
      name,
      kind: 'detail',
      normal,
      occlusion,
      // Fine furrows are too shallow to move the surface.
      ...(name !== furrows?.furrows.layer && heightOf(heights)),
      blood: blood.maps[i],
      bloodAmplitude: blood.amplitude,
    })),
    areas: [...areas, ...blood.areas, ...(furrows?.areas ?? [])].map(({ name, layer, weights }) => ({
      name,
      layer: layers[layer].name,
      weights,
    })),
    drivers: autoDrivers({ areas, blood, furrows, expressions }),
  }
}

/** Converts heights to a map of half the width and height. Heights need less resolution than normals, which show how steep a crease is. */
function heightOf(heights: HeightMap): Heights {
  const { levels, amplitude } = heightLevels(heights.data)
  return { height: halfSide({ ...heights, data: levels }), heightAmplitude: amplitude }
}

/**
 * Returns all drivers of automatic wrinkles: drivers by blendshapes, age drivers, drivers of blood and fine furrows, and expressions.
 *
 * @param wrinkles result of `autoWrinkles`. Omit `blood` or `furrows` if their areas are not used.
 */
export function autoDrivers({
  areas,
  blood,
  furrows,
  expressions,
}: Pick<AutoWrinkles, 'areas' | 'expressions'> &
  Partial<Pick<AutoWrinkles, 'blood' | 'furrows'>>): AutoDriver[] {
  return [
    ...areas.map(({ driver }) => driver),
    ...areas.flatMap(({ ageing }) => ageing ?? []),
    ...(blood?.areas ?? []).flatMap(({ drivers }) => drivers),
    ...(furrows?.areas ?? []).map(({ driver }) => driver),
    ...expressions,
  ]
}
