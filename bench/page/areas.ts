import type { Area, GrayImage } from 'furrow'

/**
 * Creates `count` areas from a face's areas. Returns the first `count` areas if the face has enough. Otherwise cuts each area into overlapping
 * vertical strips. The strips of an area sum to the area, so cutting does not change which pixels have wrinkles.
 *
 * @param originals area maps of the face.
 * @param count at most `originals.length`, or a multiple of it.
 * @param layers names of layers, assigned to the areas in turn.
 * @throws Error if `count` is larger than `originals.length` and not a multiple of it.
 */
export function divideAreas(
  originals: readonly GrayImage[],
  count: number,
  layers: readonly string[],
): Area[] {
  const strips = Math.max(1, count / originals.length)
  if (!Number.isInteger(strips)) {
    throw new Error(
      `bench: cannot divide areas evenly, got ${count} areas of ${originals.length}; request a multiple`,
    )
  }
  return Array.from({ length: count }, (_, i) => ({
    name: `area${i}`,
    layer: layers[i % layers.length],
    weights: strip(originals[Math.floor(i / strips)], i % strips, strips),
  }))
}

/** Returns strip `index` of an area that is divided into `strips` strips. Each strip overlaps half of each adjacent strip. */
function strip({ width, height, data }: GrayImage, index: number, strips: number): GrayImage {
  const columns = [...Array(width).keys()].filter((x) => hasWeight(data, x, width, height))
  const [first, last] = [columns[0], columns[columns.length - 1]]
  const weights = data.map((weight, i) => {
    const position = (((i % width) - first + 0.5) / (last - first + 1)) * strips - 0.5
    const clamped = Math.min(Math.max(position, 0), strips - 1)
    return Math.round(weight * Math.max(0, 1 - Math.abs(clamped - index)))
  })
  return { width, height, data: weights }
}

function hasWeight(data: Uint8Array, x: number, width: number, height: number): boolean {
  for (let y = 0; y < height; y++) if (data[y * width + x] > 0) return true
  return false
}
