import type { GrayImage } from '../../core/types.ts'
import { smoothstep } from '../../math/scalar.ts'
import type { HeightMap } from '../strokes/height.ts'
import { profile, REACH } from '../strokes/profile.ts'
import { type Chart, unroll } from './chart.ts'
import type { Crease, CreasedRegion } from './crease.ts'
import { NearCreases } from './near.ts'
import { seenShare } from './seen.ts'
import type { Surface } from './surface.ts'
import type { SkinTexels } from './texels.ts'

/** Exponent with which creases are joined, as in `strokesToHeight`: crossing ones are as deep as the deeper. */
const JOIN = 6
/** How much of the light a valley loses, per share of its depth in its width. */
const SHADE = 1.1
/** Share of the light that it loses at most. */
const DARKEST = 0.75
/** Difference of the distances to the lines of two areas, in millimetres, over which one gives way to the other. */
const BORDER = 4

/** A surface and the texels of a map that it covers. */
export interface Canvas {
  surface: Surface
  texels: SkinTexels
}

/** The relief of some regions, and how open to the light it is. */
export interface DrawnLayer {
  /** Millimetres above (+) or below (-) the smooth skin. */
  relief: HeightMap
  /** 255 = open. */
  occlusion: GrayImage
}

/** Draws creases as a height map. Distances are measured in space, so that seams of the texture are no seams of the skin. */
export function drawCreases(canvas: Canvas, creases: readonly Crease[]): DrawnLayer {
  const { size } = canvas.texels
  const relief = new Float32Array(size * size)
  const occlusion = new Uint8Array(size * size).fill(255)
  const near = new NearCreases(
    creases,
    creases.map(({ halfWidths }) => REACH * halfWidths.reduce((a, b) => Math.max(a, b), 0)),
  )
  visitNear(canvas, near, (texel, x, y, z, normal) => {
    let [valley, bank, shade] = [0, 0, 0]
    near.visit(x, y, z, normal[0]!, normal[1]!, normal[2]!, (index, distance, piece, share, side) => {
      const crease = creases[index]!
      const depth = between(crease.depths, piece, share)
      const halfWidth = between(crease.halfWidths, piece, share)
      if (depth === 0) return
      const shoulder = crease.shoulder[side > 0 ? 1 : 0]
      const height = depth * profile(distance / halfWidth, shoulder, crease.softness)
      if (height < 0) {
        valley += (-height) ** JOIN
        shade = Math.max(shade, (-height / halfWidth) * SHADE)
      } else bank += height ** JOIN
    })
    relief[texel] = bank ** (1 / JOIN) - valley ** (1 / JOIN)
    occlusion[texel] = Math.round(255 * (1 - Math.min(DARKEST, shade)))
  })
  return {
    relief: { width: size, height: size, data: relief },
    occlusion: { width: size, height: size, data: occlusion },
  }
}

/**
 * The areas of regions on one layer: each lies round its own lines, and gives way where another's are nearer.
 *
 * @param chart of a face, where skin that is not seen from outside has no weight.
 * @returns weights, 255 = fully visible.
 */
export function drawAreas(canvas: Canvas, regions: readonly CreasedRegion[], chart?: Chart): GrayImage[] {
  const { size } = canvas.texels
  const images = regions.map(() => new Uint8Array(size * size))
  // Regions that share their lines share an owner.
  const owners = regions.map(({ creases }) => regions.findIndex((other) => other.creases === creases))
  const lines = regions.flatMap(({ creases }, i) =>
    owners[i] === i ? creases.map((crease) => ({ crease, owner: i })) : [],
  )
  const reachOf = (i: number) => regions[i]!.region.reach + regions[i]!.region.feather
  const near = new NearCreases(
    lines.map(({ crease }) => crease),
    lines.map(({ owner }) => 2 * reachOf(owner)),
  )
  const distances = new Float64Array(regions.length)
  visitNear(canvas, near, (texel, x, y, z, normal) => {
    distances.fill(Infinity)
    near.visit(x, y, z, normal[0]!, normal[1]!, normal[2]!, (line, distance) => {
      const { owner } = lines[line]!
      distances[owner] = Math.min(distances[owner]!, distance)
    })
    if (regions.every((_, i) => distances[owners[i]!]! >= reachOf(i))) return
    const spot = unroll(x, y, z)
    const seen = chart ? seenShare(chart, x, y, z, normal) : 1
    for (const [i, { region }] of regions.entries()) {
      const own = distances[owners[i]!]!
      if (own >= reachOf(i)) continue
      let other = Infinity
      for (let k = 0; k < distances.length; k++) if (k !== owners[i]) other = Math.min(other, distances[k]!)
      const inside = 1 - smoothstep((own - region.reach) / region.feather)
      const mine = other === Infinity ? 1 : smoothstep((other - own) / BORDER + 0.5)
      images[i]![texel] = Math.round(255 * inside * mine * seen * (region.share?.(spot) ?? 1))
    }
  })
  return images.map((data) => ({ width: size, height: size, data }))
}

/** Visits the texels that have creases near them, with their place and normal. */
function visitNear(
  { surface, texels }: Canvas,
  near: NearCreases,
  visit: (texel: number, x: number, y: number, z: number, normal: Float64Array) => void,
): void {
  const { points, normals, corners } = surface
  const normal = new Float64Array(3)
  const place = new Float64Array(3)
  const low = new Float64Array(3)
  const high = new Float64Array(3)
  const isWanted = (triangle: number) => {
    for (let k = 0; k < 3; k++) {
      const values = [0, 1, 2].map((j) => points[3 * corners[3 * triangle + j]! + k]!)
      low[k] = Math.min(...values)
      high[k] = Math.max(...values)
    }
    return near.isNear(low, high)
  }
  texels.visit(isWanted, (texel, triangle, a, b, c) => {
    const [p, q, r] = [
      3 * corners[3 * triangle]!,
      3 * corners[3 * triangle + 1]!,
      3 * corners[3 * triangle + 2]!,
    ]
    // Beyond an island places lie in the triangle's plane, but normals stay those of its edge.
    const [near1, near2, near3] = [Math.max(a, 0), Math.max(b, 0), Math.max(c, 0)]
    for (let k = 0; k < 3; k++) {
      place[k] = a * points[p + k]! + b * points[q + k]! + c * points[r + k]!
      normal[k] = near1 * normals[p + k]! + near2 * normals[q + k]! + near3 * normals[r + k]!
    }
    visit(texel, place[0]!, place[1]!, place[2]!, normal)
  })
}

function between(values: Float64Array, piece: number, share: number): number {
  return values[piece]! + share * (values[piece + 1]! - values[piece]!)
}
