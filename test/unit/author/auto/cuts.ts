import type { Skin } from 'furrow/author'

/** Point on a seam of the UV layout: one position in space with two UVs. */
export interface CutPoint {
  /** The triangles on both sides of the seam, each with the UV of the point in this triangle. */
  sides: readonly [CutSide, CutSide]
}

export interface CutSide {
  triangle: number
  uv: readonly [number, number]
}

/** Number of intervals into which points divide an edge. */
const STEPS = 8

/**
 * Finds points on all UV seams: edges along which two triangles meet in space, within a thousandth of a millimetre, but not in the texture.
 *
 * @param skin skin in metres.
 */
export function findCuts({ positions, uvs, indices }: Skin): CutPoint[] {
  const keys = Array.from({ length: positions.length / 3 }, (_, vertex) =>
    [0, 1, 2].map((k) => Math.round(1e6 * positions[3 * vertex + k])).join(' '),
  )
  const uvOf = (vertex: number) => [uvs[2 * vertex], uvs[2 * vertex + 1]] as const
  const isSame = (a: number, b: number) => `${uvOf(a)}` === `${uvOf(b)}`
  const known = new Map<string, { triangle: number; from: number; to: number }>()
  const points: CutPoint[] = []
  for (let i = 0; i < indices.length; i++) {
    const triangle = Math.floor(i / 3)
    const [from, to] = [indices[i], indices[3 * triangle + ((i + 1) % 3)]]
    const other = known.get(`${keys[to]} ${keys[from]}`)
    known.set(`${keys[from]} ${keys[to]}`, { triangle, from, to })
    if (!other || (isSame(from, other.to) && isSame(to, other.from))) continue
    for (let step = 0; step <= STEPS; step++) {
      const t = step / STEPS
      points.push({
        sides: [
          { triangle, uv: lerpUv(uvOf(from), uvOf(to), t) },
          { triangle: other.triangle, uv: lerpUv(uvOf(other.to), uvOf(other.from), t) },
        ],
      })
    }
  }
  return points
}

function lerpUv([a, b]: readonly [number, number], [c, d]: readonly [number, number], t: number) {
  return [a + t * (c - a), b + t * (d - b)] as const
}

/** Maps UVs to UVs. */
export type UvTransform = (u: number, v: number) => readonly [number, number]

/** Shrinks the layout, to leave space around it. */
export const shrink: UvTransform = (u, v) => [0.1 + 0.8 * u, 0.1 + 0.8 * v]
/** Rotates the left half of a shrunk layout by 180 degrees. In a map of 512 x 512, texel centres move to texel centres. */
export const halfTurn: UvTransform = (u, v) => [280 / 512 - u, 1 - v]
/** Rotates the left half of a shrunk layout by 90 degrees, and scales it by 0.45. */
export const quarterTurn: UvTransform = (u, v) => [0.05 + 0.45 * (0.9 - v), 0.9 - 0.45 * (u - 0.1)]

/**
 * Returns a skin with its layout shrunk, and the same skin with the layout cut into two islands.
 *
 * @param isSecond tells whether a triangle belongs to the second island.
 * @param transform moves the second island.
 */
export function cutInTwo(skin: Skin, isSecond: (triangle: number) => boolean, transform: UvTransform) {
  const vertices = skin.positions.length / 3
  const at = (i: number) => shrink(skin.uvs[2 * i], skin.uvs[2 * i + 1])
  const first = Array.from({ length: vertices }, (_, i) => at(i))
  const second = first.map(([u, v]) => transform(u, v))
  const twice = (values: ArrayLike<number>) =>
    Float64Array.from({ length: 2 * values.length }, (_, i) => values[i % values.length])
  const indices = Uint32Array.from(skin.indices, (vertex, i) =>
    isSecond(Math.floor(i / 3)) ? vertex + vertices : vertex,
  )
  const whole: Skin = { ...skin, uvs: first.flat() }
  const cut: Skin = {
    positions: twice(skin.positions),
    uvs: [...first, ...second].flat(),
    indices,
    targets: skin.targets.map(({ name, offsets }) => ({ name, offsets: twice(offsets) })),
  }
  return { whole, cut }
}
