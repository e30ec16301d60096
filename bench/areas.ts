import type { Area, GrayImage } from 'furrow'

/**
 * As many areas as a case asks for, made of a face's own: the first ones, or each cut into upright strips that blend into
 * each other, as if every muscle fibre had an area. The strips of an area sum to it, so that however many areas there are
 * the same pixels wrinkle.
 *
 * @param own of the face; their number divides `count`, or is larger.
 * @param layers names of the layers; the areas take turns.
 */
export function divideAreas(own: readonly GrayImage[], count: number, layers: readonly string[]): Area[] {
  const strips = Math.max(1, count / own.length)
  if (!Number.isInteger(strips)) {
    throw new Error(`bench: no way to make ${count} areas of ${own.length}; ask for a multiple`)
  }
  return Array.from({ length: count }, (_, i) => ({
    name: `area${i}`,
    layer: layers[i % layers.length],
    weights: strip(own[Math.floor(i / strips)], i % strips, strips),
  }))
}

/** One of some strips of an area, as wide as the area's own extent allows; neighbours overlap by half. */
function strip({ width, height, data }: GrayImage, index: number, strips: number): GrayImage {
  const columns = [...Array(width).keys()].filter((x) => hasWeight(data, x, width, height))
  const [first, last] = [columns[0], columns[columns.length - 1]]
  const weights = data.map((weight, i) => {
    const across = (((i % width) - first + 0.5) / (last - first + 1)) * strips - 0.5
    const place = Math.min(Math.max(across, 0), strips - 1)
    return Math.round(weight * Math.max(0, 1 - Math.abs(place - index)))
  })
  return { width, height, data: weights }
}

function hasWeight(data: Uint8Array, x: number, width: number, height: number): boolean {
  for (let y = 0; y < height; y++) if (data[y * width + x] > 0) return true
  return false
}
