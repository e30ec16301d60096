import type { ValueLayers } from '../../../runtime/value-texels.ts'
import type { Channels } from '../../material/channels.ts'
import type { ValueKind, WrinkleTextures } from '../../material/wrinkle-textures.ts'

/** The layers' other maps, by kind. */
export type Values = Readonly<Partial<Record<ValueKind, ValueLayers>>>

/** What edits a shader for the layers' other maps, and for materials that light in steps. */
export interface ShaderChannels extends Channels {
  add(values: Values, shader: EditedShader): AddedChannels
}

export interface EditedShader {
  isToon: boolean
  /** The variable of the mixed normal. */
  normal: string
}

/** Its parts. */
export interface AddedChannels {
  declarations: string
  /** First in `main`, behind the influence. */
  begin: string
  /** Behind the mixed normal, beside `furrowOwn`. */
  tint: string
  /** Mixes into the material's own maps where it reads them; without a map its own value is 1. */
  mixOthers(fragment: string): string
}

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
