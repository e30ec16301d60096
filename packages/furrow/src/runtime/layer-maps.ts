import { type ImageArray, packColours, packGrays } from '../core/pack.ts'
import type { GrayImage, RgbaImage } from '../core/types.ts'

/** Kinds of maps that a layer may have besides its normals. */
export const VALUE_KINDS = ['baseColor', 'roughness', 'occlusion', 'blood'] as const
export type ValueKind = (typeof VALUE_KINDS)[number]

/** The images of one kind of map, of all layers, as one array. */
export interface PackedMaps {
  images: ImageArray
  /** Slice of each layer's map; null for a layer that has none. */
  slices: readonly (number | null)[]
  /** Channel of single-channel maps. */
  channel: number
}

/**
 * Packs the images of one kind.
 *
 * @param maps of each layer; undefined for a layer that has none.
 * @throws FurrowError when their sizes differ.
 */
export function packMaps(
  maps: readonly (RgbaImage | GrayImage | undefined)[],
  kind: 'normal' | ValueKind,
): PackedMaps {
  const present = maps.filter((map) => map !== undefined)
  const pack = kind === 'normal' || kind === 'baseColor' ? packColours : packGrays
  let next = 0
  return {
    images: pack(present, `Wrinkles ${kind} maps of the layers`),
    slices: maps.map((map) => (map ? next++ : null)),
    channel: 0,
  }
}
