import type { Area } from 'furrow'
import { seeded } from '../test/random.ts'

/** Side of an area in texels. */
const SIDE = 128
/** Radius of a blob as a share of the map: from a crow's foot to half a forehead. */
const RADIUS = { least: 0.04, most: 0.1 }

/**
 * Areas as soft round blobs, the same ones in every run.
 *
 * @param places u, v of points of the face, 0..1, of which each blob picks its middle.
 * @param layers names of the layers; the areas take turns.
 */
export function createBlobs(count: number, places: Float32Array, layers: readonly string[]): Area[] {
  const random = seeded(1)
  return Array.from({ length: count }, (_, i) => {
    const place = Math.floor(random() * (places.length / 2))
    const radius = RADIUS.least + random() * (RADIUS.most - RADIUS.least)
    return {
      name: `area${i}`,
      layer: layers[i % layers.length],
      weights: { width: SIDE, height: SIDE, data: blob(places[place * 2], places[place * 2 + 1], radius) },
    }
  })
}

/** Falls from 255 in the middle to 0 at the radius, with a level start and end. */
function blob(u: number, v: number, radius: number): Uint8Array {
  const data = new Uint8Array(SIDE * SIDE)
  for (let i = 0; i < data.length; i++) {
    const [x, y] = [((i % SIDE) + 0.5) / SIDE, (Math.floor(i / SIDE) + 0.5) / SIDE]
    const near = Math.max(0, 1 - Math.hypot(x - u, y - v) / radius)
    data[i] = Math.round(255 * near * near * (3 - 2 * near))
  }
  return data
}
