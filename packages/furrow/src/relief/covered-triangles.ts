import type { ImageArray } from '../core/pack.ts'
import { rasterize } from '../math/rasterize.ts'
import { uvToTexels } from '../math/triangle.ts'
import type { CoarseMesh } from './coarse-mesh.ts'

/**
 * Finds the triangles that areas cover.
 *
 * @param areas one slice per area, weights in the first channel.
 * @param slices those that matter.
 * @returns for each triangle 1 if any of these areas has a weight above 0 on it, and otherwise 0.
 */
export function coveredTriangles(
  { uvs, triangles }: CoarseMesh,
  areas: ImageArray,
  slices: readonly number[],
): Uint8Array {
  const { width, height } = areas
  const mask = widen(unite(areas, slices), width, height)
  const covered = new Uint8Array(Math.floor(triangles.length / 3))
  const corners = new Float64Array(6)
  const visit = (column: number, row: number) => mask[clampTo(column, width) + clampTo(row, height) * width]
  for (let t = 0; t < covered.length; t++) {
    uvToTexels(corners, uvs, triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2], width, height)
    if (!corners.every(Number.isFinite)) continue
    moveIntoTexture(corners, width, height)
    let any = 0
    // A triangle smaller than a texel covers no centre: its corners have some.
    for (let k = 0; k < 6; k += 2) any |= visit(Math.round(corners[k]), Math.round(corners[k + 1]))
    const box = [0, 0, width - 1, height - 1] as const
    if (!any) rasterize(corners, 0, (column, row) => (any |= visit(column, row)), box)
    covered[t] = any
  }
  return covered
}

/** 1 where any of some slices is above 0. */
function unite({ width, height, channels, data }: ImageArray, slices: readonly number[]): Uint8Array {
  const size = width * height
  const mask = new Uint8Array(size)
  for (const slice of slices) {
    for (let i = 0; i < size; i++) if (data[(slice * size + i) * channels] > 0) mask[i] = 1
  }
  return mask
}

/** Adds the neighbours of every texel: as far as bilinear filtering spreads it. */
function widen(mask: Uint8Array, width: number, height: number): Uint8Array {
  const wide = new Uint8Array(mask.length)
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      if (!mask[x + y * width]) continue
      for (let j = Math.max(0, y - 1); j <= Math.min(height - 1, y + 1); j++) {
        wide.fill(1, Math.max(0, x - 1) + j * width, Math.min(width - 1, x + 1) + 1 + j * width)
      }
    }
  }
  return wide
}

/** Texture coordinates repeat: moves a triangle by whole textures, so that its centre is inside. */
function moveIntoTexture(corners: Float64Array, width: number, height: number): void {
  for (const [axis, size] of [width, height].entries()) {
    const centre = (corners[axis] + corners[axis + 2] + corners[axis + 4]) / 3
    const moved = Math.floor((centre + 0.5) / size) * size
    for (let k = axis; k < 6; k += 2) corners[k] -= moved
  }
}

function clampTo(value: number, size: number): number {
  return Math.min(Math.max(value, 0), size - 1)
}
