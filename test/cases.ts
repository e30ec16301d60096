import type { Area, Layer, LayerKind, RgbaImage, WrinkleSet } from 'furrow'

/** Returns an image of random bytes. Independent texels are the hardest case for tests of sampling. */
export function randomImage(random: () => number, width: number, height = width): RgbaImage {
  return { width, height, data: Uint8Array.from({ length: width * height * 4 }, () => random() * 256) }
}

/** Returns a map of random normals within 45 degrees of the surface normal. */
export function randomNormals(random: () => number, size: number): RgbaImage {
  const image = randomImage(random, size)
  for (let i = 0; i < size * size; i++) {
    const [x, y] = [random() - 0.5, random() - 0.5]
    const z = Math.sqrt(1 - x * x - y * y)
    image.data.set(
      [x, y, z, 1].map((value) => Math.round((value * 0.5 + 0.5) * 255)),
      i * 4,
    )
  }
  return image
}

export function randomAreas(random: () => number, count: number, size: number): Area[] {
  return Array.from({ length: count }, (_, i) => ({
    name: `area${i}`,
    combine: random() < 0.25 ? ('max' as const) : ('sum' as const),
    weights: {
      width: size,
      height: size,
      data: Uint8Array.from({ length: size * size }, () => random() * 256),
    },
  }))
}

export function randomSet(random: () => number, count: number, areaSize: number, mapSize = 16): WrinkleSet {
  return {
    layers: [layer('skin', 'replace', randomNormals(random, mapSize))],
    areas: randomAreas(random, count, areaSize),
  }
}

export function layer(name: string, kind: LayerKind, normal: RgbaImage): Layer {
  return { name, kind, normal }
}

/** Returns the JSON of the smallest wrinkle set, which uses one image as normal map and as area. */
export function setOf(image: string): object {
  return {
    version: 1,
    layers: [{ name: 'expression', kind: 'replace', normal: image }],
    areas: [{ name: 'forehead', image }],
  }
}
