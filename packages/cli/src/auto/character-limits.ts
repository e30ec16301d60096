import type { Skin } from 'furrow/author'
import { triangleNormal } from 'furrow/internal'
import type { embedWrinkles } from 'furrow-files'

type PackedWrinkles = Parameters<typeof embedWrinkles>[2]

/** Maximum number of areas, and maximum size of the maps in bytes, that `furrow auto` adds to a character. */
export const CHARACTER_LIMITS = { areas: 160, bytes: 12 * 1024 * 1024 } as const

/** Counts the areas and maps that a character gets. */
export class CharacterBudget {
  #areas = 0
  #bytes = 0

  /**
   * Counts the wrinkles of one more surface. The first surface always fits.
   *
   * @returns the reason, a clause for a message, if they would exceed a limit. They are not counted then.
   */
  add(packed: PackedWrinkles): string | undefined {
    const [areas, bytes] = [this.#areas + packed.areas.length, this.#bytes + mapBytes(packed)]
    if (this.#areas > 0 && areas > CHARACTER_LIMITS.areas)
      return `larger surfaces use most of the ${CHARACTER_LIMITS.areas} areas of a character`
    if (this.#areas > 0 && bytes > CHARACTER_LIMITS.bytes)
      return `larger surfaces use most of the ${CHARACTER_LIMITS.bytes >> 20} MB for the maps of a character; choose a smaller --size`
    ;[this.#areas, this.#bytes] = [areas, bytes]
    return undefined
  }
}

/** Returns the size of all images in bytes. Layers and areas can share images. */
function mapBytes({ layers, areas }: PackedWrinkles): number {
  const maps = layers.flatMap(({ normal, baseColor, roughness, occlusion, height, blood, onset }) => [
    normal,
    baseColor,
    roughness,
    occlusion,
    height,
    blood,
    onset,
  ])
  const images = [...maps, ...areas.map(({ image }) => image)].flatMap((image) => image?.bytes ?? [])
  return [...new Set(images)].reduce((sum, { length }) => sum + length, 0)
}

/** Returns the area of a surface in the square of its unit. The largest surface of a character takes the most pixels on the screen. */
export function surfaceArea({ positions, indices }: Pick<Skin, 'positions' | 'indices'>): number {
  const normal = new Float64Array(3)
  let area = 0
  for (let t = 0; t + 2 < indices.length; t += 3) {
    triangleNormal(normal, positions, indices[t], indices[t + 1], indices[t + 2])
    area += Math.hypot(...normal) / 2
  }
  return area
}
