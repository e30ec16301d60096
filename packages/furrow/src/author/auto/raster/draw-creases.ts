import type { GrayImage } from '../../../core/types.ts'
import { lerp } from '../../../math/scalar.ts'
import type { SkinTexels } from '../../skin/skin-texels.ts'
import type { HeightMap } from '../../strokes/height.ts'
import { CreaseGrid } from '../../strokes/line-grid.ts'
import { visitTexelsNearCreases } from '../../strokes/near-lines.ts'
import { profile, REACH } from '../../strokes/profile.ts'
import type { Crease } from '../lines/crease.ts'

/** Exponent with which creases are joined, as in `strokesToHeight`: where they cross they are as deep as the deeper one. */
const JOIN = 6
/** Fraction of the light that a valley loses, per depth in half widths. */
const SHADE = 1.1
/** Fraction of the light that it loses at most. */
const MAX_SHADE = 0.75

/** The relief of some creases, and how open to the light it is. */
export interface DrawnCreases {
  /** Millimetres above (+) or below (-) the smooth skin. */
  relief: HeightMap
  /** 255 = open. */
  occlusion: GrayImage
}

/** Draws creases as a height map. Distances are measured in space, so that UV seams leave no mark. */
export function drawCreases(texels: SkinTexels, creases: readonly Crease[]): DrawnCreases {
  const { size } = texels
  const relief = new Float32Array(size * size)
  const occlusion = new Uint8Array(size * size).fill(255)
  const grid = new CreaseGrid(
    creases,
    creases.map(({ halfWidths }) => REACH * halfWidths.reduce((a, b) => Math.max(a, b), 0)),
  )
  visitTexelsNearCreases(texels, grid, (texel, x, y, z, normal) => {
    let [valley, bank, shade] = [0, 0, 0]
    grid.visit(x, y, z, normal[0], normal[1], normal[2], (index, distance, segment, t, side) => {
      const { depths, halfWidths, shoulder, softness } = creases[index]
      const depth = lerp(depths[segment], depths[segment + 1], t)
      const halfWidth = lerp(halfWidths[segment], halfWidths[segment + 1], t)
      if (depth === 0) return
      const height = depth * profile(distance / halfWidth, shoulder[side > 0 ? 1 : 0], softness)
      if (height < 0) {
        valley += (-height) ** JOIN
        shade = Math.max(shade, (-height / halfWidth) * SHADE)
      } else bank += height ** JOIN
    })
    relief[texel] = bank ** (1 / JOIN) - valley ** (1 / JOIN)
    occlusion[texel] = Math.round(255 * (1 - Math.min(MAX_SHADE, shade)))
  })
  return {
    relief: { width: size, height: size, data: relief },
    occlusion: { width: size, height: size, data: occlusion },
  }
}
