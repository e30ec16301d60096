import type { WrinkleSet } from '../../core/types.ts'
import type { AgeDriver } from '../../drivers/age/definition.ts'
import type { ExpressionDriver } from '../../drivers/expression/definition.ts'
import type { MorphDriver } from '../../drivers/morph/definition.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import type { TimeDriver } from '../../drivers/time/definition.ts'
import type { AutoWrinkles } from './auto.ts'

/** A driver of automatic wrinkles. */
export type AutoDriver = MorphDriver | AgeDriver | TimeDriver | ExpressionDriver

/** Automatic wrinkles as a wrinkle set, drivers and expressions included: `new Wrinkles(mesh, autoWrinkleSet(wrinkles))` shows them. */
export function autoWrinkleSet({
  layers,
  areas,
  blood,
  expressions,
}: Pick<AutoWrinkles, 'layers' | 'areas' | 'blood' | 'expressions'>): WrinkleSet & {
  drivers: WrinkleDriver[]
} {
  return {
    layers: layers.map(({ name, normal, occlusion }, i) => ({
      name,
      kind: 'detail',
      normal,
      occlusion,
      blood: blood.maps[i],
      bloodAmplitude: blood.amplitude,
    })),
    areas: [...areas, ...blood.areas].map(({ name, layer, weights }) => ({
      name,
      layer: layers[layer].name,
      weights,
    })),
    drivers: autoDrivers({ areas, blood, expressions }),
  }
}

/**
 * All drivers of automatic wrinkles: of blendshapes, of age, of blood, and expressions.
 *
 * @param wrinkles without blood where its areas are not used.
 */
export function autoDrivers({
  areas,
  blood,
  expressions,
}: Pick<AutoWrinkles, 'areas' | 'expressions'> & Partial<Pick<AutoWrinkles, 'blood'>>): AutoDriver[] {
  return [
    ...areas.map(({ driver }) => driver),
    ...areas.flatMap(({ ageing }) => ageing ?? []),
    ...(blood?.areas ?? []).flatMap(({ drivers }) => drivers),
    ...expressions,
  ]
}
