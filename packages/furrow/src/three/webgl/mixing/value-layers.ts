import type { ValueLayers } from '../../../runtime/value-texels.ts'
import type { ValueKind, WrinkleTextures } from '../../material/wrinkle-textures.ts'

/** The layers' other maps, by kind. */
export type Values = Readonly<Partial<Record<ValueKind, ValueLayers>>>

/** The layers' other maps, as a program depends on them. */
export function valueLayers(values: WrinkleTextures['values']): Values {
  const kinds = Object.keys(values) as ValueKind[]
  return Object.fromEntries(
    Object.entries(values).map(([kind, { texture, slices, channel }]) => {
      const sampler = kinds.find((other) => values[other]!.texture === texture)!
      return [kind, { slices, channel, sampler }]
    }),
  )
}
