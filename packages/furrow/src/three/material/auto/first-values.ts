import { PAIR } from '../../../runtime/paired-maps.ts'
import type { ArrayTexture } from '../array-texture.ts'
import type { WrinkleTextures } from '../wrinkle-textures.ts'

/** A slice of the first layer's visibility, blood, or both. */
export interface FirstValues {
  texture: ArrayTexture
  slice: number
}

/** That of a set; null where it has none, where other kinds of maps are in its array, or where it takes alpha. */
export function firstValues({ values }: WrinkleTextures): FirstValues | null {
  const { texture, slices: [slice] = [] } =
    PAIR.map((kind) => values[kind]).find((maps) => maps && maps.slices[0] !== null) ?? {}
  if (!texture || slice == null) return null
  const sharing = Object.entries(values).filter(([, maps]) => maps.texture === texture)
  const isReadable = sharing.every(([kind, { channel }]) => isPaired(kind) && channel < 3)
  return isReadable ? { texture, slice } : null
}

function isPaired(kind: string): boolean {
  return PAIR.some((paired) => paired === kind)
}
