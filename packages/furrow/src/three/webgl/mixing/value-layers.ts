import type { ValueLayers } from '../../../runtime/value-texels.ts'
import type { ValueKind, WrinkleTextures } from '../../material/wrinkle-textures.ts'

/** Value maps (all except normals) of the layers, by kind. */
export type Values = Readonly<Partial<Record<ValueKind, ValueLayers>>>

/** Shader parameters of the layers' value maps. */
export function valueLayers(values: WrinkleTextures['values']): Values {
  const kinds = Object.keys(values) as ValueKind[]
  return Object.fromEntries(
    Object.entries(values).map(([kind, { texture, slices, channel }]) => {
      const sampler = kinds.find((other) => values[other]!.texture === texture)!
      return [kind, { slices, channel, sampler }]
    }),
  )
}
