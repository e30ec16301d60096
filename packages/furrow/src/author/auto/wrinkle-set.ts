import type { Layer, WrinkleSet } from '../../core/types.ts'
import type { AgeDriver } from '../../drivers/age/definition.ts'
import type { BoneDriver } from '../../drivers/bone/definition.ts'
import type { ExpressionDriver } from '../../drivers/expression/definition.ts'
import type { MorphDriver } from '../../drivers/morph/definition.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import type { TimeDriver } from '../../drivers/time/definition.ts'
import type { HeightMap } from '../strokes/height.ts'
import type { AutoWrinkles } from './auto.ts'
import { halfSide, heightLevels } from './raster/half-side.ts'

export type AutoDriver = MorphDriver | BoneDriver | AgeDriver | TimeDriver | ExpressionDriver

type Heights = Required<Pick<Layer, 'height' | 'heightAmplitude'>>

/**
 * Converts the result of `autoWrinkles` to a wrinkle set with heights, drivers and expressions. A page can show it with
 * `new Wrinkles(mesh, autoWrinkleSet(wrinkles))`.
 */
export function autoWrinkleSet({
  layers,
  areas,
  jointAreas,
  blood,
  bulges,
  furrows,
  expressions,
}: Pick<
  AutoWrinkles,
  'layers' | 'areas' | 'jointAreas' | 'blood' | 'bulges' | 'furrows' | 'expressions'
>): WrinkleSet & {
  drivers: WrinkleDriver[]
} {
  return {
    layers: layers.map(({ name, normal, occlusion, onset, heights }, i) => ({
      name,
      kind: 'detail',
      normal,
      occlusion,
      ...(onset && { onset }),
      // Fine furrows are too shallow to move the surface.
      ...(name !== furrows?.furrows.layer && heightOf(heights)),
      blood: blood.maps[i],
      bloodAmplitude: blood.amplitude,
    })),
    areas: [...areas, ...jointAreas, ...blood.areas, ...bulges, ...(furrows?.areas ?? [])].map(
      ({ name, layer, weights }) => ({
        name,
        layer: layers[layer].name,
        weights,
      }),
    ),
    drivers: autoDrivers({ areas, jointAreas, blood, bulges, furrows, expressions }),
  }
}

/** Converts heights to a map of half the width and height, because heights need less resolution than normals. */
function heightOf(heights: HeightMap): Heights {
  const { levels, amplitude } = heightLevels(heights.data)
  return { height: halfSide({ ...heights, data: levels }), heightAmplitude: amplitude }
}

/**
 * Returns all drivers of automatic wrinkles: blendshape and age drivers of the lines, drivers of blood, bulges and fine furrows, and
 * expressions.
 *
 * @param wrinkles result of `autoWrinkles`. Omit `blood`, `bulges` or `furrows` if their areas are not used.
 */
export function autoDrivers({
  areas,
  jointAreas = [],
  blood,
  bulges = [],
  furrows,
  expressions,
}: Pick<AutoWrinkles, 'areas' | 'expressions'> &
  Partial<Pick<AutoWrinkles, 'jointAreas' | 'blood' | 'bulges' | 'furrows'>>): AutoDriver[] {
  return [
    ...areas.map(({ driver }) => driver),
    ...areas.flatMap(({ ageing }) => ageing ?? []),
    ...jointAreas.flatMap(({ drivers }) => drivers),
    ...(blood?.areas ?? []).flatMap(({ drivers }) => drivers),
    ...[...bulges, ...(furrows?.areas ?? [])].map(({ driver }) => driver),
    ...expressions,
  ]
}
