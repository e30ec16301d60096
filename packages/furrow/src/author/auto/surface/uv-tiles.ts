import { uvArea } from '../../../math/triangle.ts'
import { islandsOf } from '../../skin/islands.ts'
import type { Skin } from '../../skin/surface.ts'

/** Smaller fractions of `crossing` are set to 0, because islands often extend slightly beyond the texture. */
const OVERHANG = 0.01

/**
 * Moves each UV island into 0..1 by an integer offset. The mesh looks the same, because renderers repeat the texture.
 *
 * @returns the moved skin, or the same object if all UVs are inside 0..1. `crossing` is the fraction of the UV area whose
 *   triangles still extend beyond the texture.
 */
export function moveToFirstTile(skin: Skin): { skin: Skin; crossing: number } {
  const { uvs, indices } = skin
  if (!isOutside(uvs)) return { skin, crossing: 0 }
  const islandOf = islandsOf(indices, uvs.length / 2)
  const moved = Float64Array.from(uvs)
  for (let k = 0; k < 2; k++) {
    const low = new Float64Array(uvs.length / 2).fill(Infinity)
    const high = new Float64Array(uvs.length / 2).fill(-Infinity)
    for (const [vertex, island] of islandOf.entries()) {
      low[island] = Math.min(low[island], uvs[2 * vertex + k])
      high[island] = Math.max(high[island], uvs[2 * vertex + k])
    }
    for (const [vertex, island] of islandOf.entries())
      moved[2 * vertex + k] = uvs[2 * vertex + k] - Math.floor((low[island] + high[island]) / 2)
  }
  const crossing = fractionOutside(moved, indices)
  return { skin: { ...skin, uvs: moved }, crossing: crossing > OVERHANG ? crossing : 0 }
}

function isOutside(uvs: ArrayLike<number>): boolean {
  for (let i = 0; i < uvs.length; i++) if (uvs[i] < 0 || uvs[i] > 1) return true
  return false
}

/** Returns the UV area of triangles that are partly or completely outside 0..1, as a fraction of the UV area of all triangles. */
function fractionOutside(uvs: ArrayLike<number>, indices: ArrayLike<number>): number {
  let [outside, total] = [0, 0]
  for (let t = 0; t + 2 < indices.length; t += 3) {
    const [a, b, c] = [indices[t], indices[t + 1], indices[t + 2]]
    const area = uvArea(uvs, a, b, c)
    total += area
    if ([a, b, c].some((i) => isOutside([uvs[2 * i], uvs[2 * i + 1]]))) outside += area
  }
  return total > 0 ? outside / total : 0
}
