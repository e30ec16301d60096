import type { ValueLayers } from '../../../runtime/maps/value-texels.ts'
import type { ValueKind, WrinkleTextures } from '../../material/wrinkle-textures.ts'

/** Shader parameters of the value maps of layers, by kind of map. Value maps are all maps except normals. */
export type Values = Readonly<Partial<Record<ValueKind, ValueLayers>>>

/** Returns the shader parameters of the value maps. Kinds that share a texture share a sampler, named after the first of these kinds. */
export function valueLayers(values: WrinkleTextures['values']): Values {
  const kinds = Object.keys(values) as ValueKind[]
  return Object.fromEntries(
    Object.entries(values).map(([kind, { texture, slices, channel }]) => {
      const sampler = kinds.find((other) => values[other]!.texture === texture)!
      return [kind, { slices, channel, sampler }]
    }),
  )
}
