import type { WrinkleSet } from '../../core/types.ts'
import type { AgeDriver } from '../../drivers/age/definition.ts'
import type { ExpressionDriver } from '../../drivers/expression/definition.ts'
import type { MorphDriver } from '../../drivers/morph/definition.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import type { AutoWrinkles } from './auto.ts'

/** Automatic wrinkles as a wrinkle set, drivers and expressions included: `new Wrinkles(mesh, autoWrinkleSet(wrinkles))` shows them. */
export function autoWrinkleSet({
  layers,
  areas,
  expressions,
}: Pick<AutoWrinkles, 'layers' | 'areas' | 'expressions'>): WrinkleSet & { drivers: WrinkleDriver[] } {
  return {
    layers: layers.map(({ name, normal, occlusion }) => ({ name, kind: 'detail', normal, occlusion })),
    areas: areas.map(({ name, layer, weights }) => ({ name, layer: layers[layer].name, weights })),
    drivers: autoDrivers({ areas, expressions }),
  }
}

/** All drivers of automatic wrinkles: of blendshapes, of age, and expressions. */
export function autoDrivers({
  areas,
  expressions,
}: Pick<AutoWrinkles, 'areas' | 'expressions'>): (MorphDriver | AgeDriver | ExpressionDriver)[] {
  return [
    ...areas.map(({ driver }) => driver),
    ...areas.flatMap(({ ageing }) => ageing ?? []),
    ...expressions,
  ]
}
