import { PAIR } from '../../../runtime/paired-maps.ts'
import type { ArrayTexture } from '../array-texture.ts'
import type { WrinkleTextures } from '../wrinkle-textures.ts'

/** A slice of the first layer's visibility, blood, or both. */
export interface FirstValues {
  /** What it has, the first of both. */
  kind: (typeof PAIR)[number]
  texture: ArrayTexture
  slice: number
}

/** That of a set; null where it has none, where other kinds of maps are in its array, or where it takes alpha. */
export function firstValues({ values }: WrinkleTextures): FirstValues | null {
  const kind = PAIR.find((paired) => typeof values[paired]?.slices[0] === 'number')
  if (!kind) return null
  const { texture, slices } = values[kind]!
  const sharing = Object.entries(values).filter(([, maps]) => maps.texture === texture)
  const isReadable = sharing.every(([other, { channel }]) => isPaired(other) && channel < 3)
  return isReadable ? { kind, texture, slice: slices[0]! } : null
}

function isPaired(kind: string): boolean {
  return PAIR.some((paired) => paired === kind)
}
