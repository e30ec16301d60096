import type { embedWrinkles } from 'furrow-files'

type PackedWrinkles = Parameters<typeof embedWrinkles>[2]

/** Returns the size of all images in bytes. Layers and areas can share images. */
export function mapBytes({ layers, areas }: Pick<PackedWrinkles, 'layers' | 'areas'>): number {
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
