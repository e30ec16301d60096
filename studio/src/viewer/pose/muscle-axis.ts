import type { GrayImage } from 'furrow'
import type { Mesh } from 'three'

/** Length of a muscle, metres, similar to the muscle of the forehead. */
const LENGTH = 0.03

type Vector = [number, number, number]

/**
 * Suggests both ends of a muscle that pulls an area upwards: the middle of the area, and a point above it.
 *
 * @returns null if the area covers no vertex of the skin.
 */
export function muscleAxis(
  { geometry }: Mesh,
  { width, height, data }: GrayImage,
): { origin: Vector; insertion: Vector } | null {
  const [positions, uvs] = [geometry.getAttribute('position'), geometry.getAttribute('uv')]
  const middle: Vector = [0, 0, 0]
  let total = 0
  for (let i = 0; i < positions.count; i++) {
    const column = Math.min(width - 1, Math.max(0, Math.floor(uvs.getX(i) * width)))
    const row = Math.min(height - 1, Math.max(0, Math.floor(uvs.getY(i) * height)))
    const weight = data[row * width + column]
    total += weight
    middle[0] += weight * positions.getX(i)
    middle[1] += weight * positions.getY(i)
    middle[2] += weight * positions.getZ(i)
  }
  if (total === 0) return null
  const insertion = middle.map((sum) => millimetre(sum / total)) as Vector
  return { insertion, origin: [insertion[0], millimetre(insertion[1] + LENGTH), insertion[2]] }
}

function millimetre(metres: number): number {
  return Math.round(metres * 1000) / 1000
}
