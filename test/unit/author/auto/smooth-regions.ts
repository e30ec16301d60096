import { readFileSync } from 'node:fs'
import type { Skin } from 'furrow/author'
import type { SkinSurface } from 'furrow/internal'
import { coverTexels } from '../../../../packages/furrow/src/author/cover-texels.ts'

/**
 * Regions of a face that must not have wrinkles, as indices of surface points. They are found without the code under test.
 *
 * - `eyes` and `lips`: the skin inside an opening of the mesh, such as the rims and insides of lids and lips. This skin is connected with the
 *   border of the opening. It is hidden from the front, or its normals point backwards.
 * - `ears`: points around the tip of an ear. The tip is the point farthest to the side, at most 60 mm above or below the eyes. The region's points are
 *   more than 55 mm from the middle of the head. Relative to the tip, they are at most 30 mm in front, 30 mm above and 50 mm below. An
 *   adult's ear is 63 mm high.
 */
export interface SmoothRegions {
  eyes: Set<number>
  lips: Set<number>
  ears: Set<number>
}

/**
 * Finds the regions of a face that must not have wrinkles.
 *
 * @param surface skin in millimetres: x to the person's left, y up, z forwards, origin between the eyes.
 */
export function smoothRegions(surface: SkinSurface): SmoothRegions {
  const { points, normals, neighbourStarts, neighbours } = surface
  const isHidden = hiddenFromFront(surface)
  const regions: SmoothRegions = { eyes: new Set(), lips: new Set(), ears: earsOf(points) }
  for (const border of openingsOf(surface)) {
    const [, height, depth] = [0, 1, 2].map(
      (k) => border.reduce((sum, point) => sum + points[3 * point + k], 0) / border.length,
    )
    if (depth < -40) continue
    const inside = new Set(border)
    for (const point of inside) {
      for (const next of neighbours.subarray(neighbourStarts[point], neighbourStarts[point + 1]))
        if (isHidden[next] || normals[3 * next + 2] < 0) inside.add(next)
    }
    for (const point of inside) (height > -30 ? regions.eyes : regions.lips).add(point)
  }
  return regions
}

/** Returns the points along each closed border of the surface. */
function openingsOf({ corners, adjacent }: SkinSurface): number[][] {
  const next = new Map<number, number>()
  for (let i = 0; i < corners.length; i++) {
    if (adjacent[i] < 0) next.set(corners[i], corners[3 * Math.floor(i / 3) + ((i + 1) % 3)])
  }
  const openings: number[][] = []
  for (const first of next.keys()) {
    const border: number[] = []
    for (let point: number | undefined = first; point !== undefined; ) {
      const end = next.get(point)
      if (end !== undefined) border.push(point)
      next.delete(point)
      point = end
    }
    if (border.length > 0) openings.push(border)
  }
  return openings
}

/** Width of the depth map of the face seen from the front, texels. */
const SIDE = 1024
/** Width of a texel of the depth map, millimetres. */
const TEXEL = 0.5
/** Minimum distance between a hidden point and the skin in front of it, millimetres. */
const IN_FRONT = 1.5

/** Returns 1 for each point that other skin hides from the front, otherwise 0. */
function hiddenFromFront({ points, corners }: SkinSurface): Uint8Array {
  const count = points.length / 3
  const uvs = Float64Array.from({ length: 2 * count }, (_, i) => {
    const coordinate = points[3 * Math.floor(i / 2) + (i % 2)]
    return 0.5 + (i % 2 ? -coordinate : coordinate) / (SIDE * TEXEL)
  })
  const foremost = new Float32Array(SIDE * SIDE).fill(-Infinity)
  for (let t = 0; t < corners.length; t += 3) {
    const [p, q, r] = [corners[t], corners[t + 1], corners[t + 2]]
    coverTexels(uvs, [p, q, r], SIDE, SIDE, (texel, a, b, c) => {
      const z = a * points[3 * p + 2] + b * points[3 * q + 2] + c * points[3 * r + 2]
      if (z > foremost[texel]) foremost[texel] = z
    })
  }
  return Uint8Array.from({ length: count }, (_, i) => {
    const [column, row] = [0, 1].map((k) => Math.floor(uvs[2 * i + k] * SIDE))
    return foremost[row * SIDE + column] - points[3 * i + 2] > IN_FRONT ? 1 : 0
  })
}

function earsOf(points: Float64Array): Set<number> {
  const all = Array.from({ length: points.length / 3 }, (_, i) => i)
  const ears = [1, -1].flatMap((side) => {
    const out = (i: number) => (Math.abs(points[3 * i + 1]) < 60 ? side * points[3 * i] : 0)
    const tip = all.reduce((best, i) => (out(i) > out(best) ? i : best))
    return all.filter((i) => {
      const [across, up, forwards] = [0, 1, 2].map((k) => points[3 * i + k] - (k && points[3 * tip + k]))
      return side * across > 55 && forwards < 30 && up > -50 && up < 30
    })
  })
  return new Set(ears)
}

/** Returns the triangles whose three corners are in a set of points. */
export function trianglesIn({ corners, skinTriangles }: SkinSurface, points: ReadonlySet<number>): number[] {
  return [...skinTriangles.keys()].filter((t) => [0, 1, 2].every((k) => points.has(corners[3 * t + k])))
}

/** Finds the points of the shipped face's ears. Reads the outline of the hair from the script that builds the face. */
export function shippedEars({ uvs }: Skin, { pointOf }: SkinSurface): Set<number> {
  const landmarks = readFileSync(
    new URL('../../../../faces/builder/person/landmarks.py', import.meta.url),
    'utf8',
  )
  const [, list] = /^HAIR = \[([^\]]*?),?\s*\]/m.exec(landmarks) ?? []
  const hair: [number, number][] = JSON.parse(`[${list.replaceAll('(', '[').replaceAll(')', ']')}]`)
  // The outline of the hair goes down in front of the ear, up and over the ear, and down behind it.
  const front = hair.reduce((best, [, v], i) => (i < 20 && v > hair[best][1] ? i : best), 0)
  const back = hair.findIndex(([u, v], i) => i > front && u > hair[front][0] && v > hair[front][1])
  const outline = hair.slice(front, back + 1)
  const isInside = (u: number, v: number) =>
    outline.reduce((inside, [u2, v2], i) => {
      const [u1, v1] = outline[(i + outline.length - 1) % outline.length]
      const crosses = v1 > v !== v2 > v && u < u1 + ((u2 - u1) * (v - v1)) / (v2 - v1)
      return crosses ? !inside : inside
    }, false)
  const ears = new Set<number>()
  for (const [vertex, point] of pointOf.entries()) {
    const u = uvs[2 * vertex]
    if (isInside(Math.max(u, 1 - u), uvs[2 * vertex + 1])) ears.add(point)
  }
  return ears
}
