import type { WrinkleSet } from '../../core/types.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import type { AutoWrinkles } from './auto.ts'

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
    drivers: [
      ...areas.map(({ driver }) => driver),
      ...blood.areas.flatMap(({ drivers }) => drivers),
      ...expressions,
    ],
  }
}
