import type { PackedWrinkles } from './embed.ts'

/** Returns the total size of the images of packed wrinkles in bytes. A shared image counts once. */
export function imageBytes({ layers, areas }: Pick<PackedWrinkles, 'layers' | 'areas'>): number {
  const maps = layers.flatMap(({ normal, baseColor, roughness, occlusion, height, blood, onset }) => {
    return [normal, baseColor, roughness, occlusion, height, blood, onset]
  })
  const images = new Set([...maps, ...areas.map(({ image }) => image)].map((image) => image?.bytes))
  return [...images].reduce((sum, bytes) => sum + (bytes?.length ?? 0), 0)
}
