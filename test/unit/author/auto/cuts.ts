import type { Skin } from 'furrow/author'

/** A place on an edge at which the texture is cut: one in space, two in the texture. */
export interface CutPlace {
  /** The triangle on each side, and where the place lies in its texture. */
  sides: readonly [CutSide, CutSide]
}

export interface CutSide {
  triangle: number
  uv: readonly [number, number]
}

/** Places on each cut edge: its ends and some between. */
const STEPS = 8

/** Places on all edges at which triangles meet in space, to a thousandth of a millimetre, but not in the texture. Positions in metres. */
export function findCuts({ positions, uvs, indices }: Skin): CutPlace[] {
  const keys = Array.from({ length: positions.length / 3 }, (_, vertex) =>
    [0, 1, 2].map((k) => Math.round(1e6 * positions[3 * vertex + k]!)).join(' '),
  )
  const uvOf = (vertex: number) => [uvs[2 * vertex]!, uvs[2 * vertex + 1]!] as const
  const isSame = (a: number, b: number) => `${uvOf(a)}` === `${uvOf(b)}`
  const known = new Map<string, { triangle: number; from: number; to: number }>()
  const places: CutPlace[] = []
  for (let i = 0; i < indices.length; i++) {
    const triangle = Math.floor(i / 3)
    const [from, to] = [indices[i]!, indices[3 * triangle + ((i + 1) % 3)]!]
    const other = known.get(`${keys[to]} ${keys[from]}`)
    known.set(`${keys[from]} ${keys[to]}`, { triangle, from, to })
    if (!other || (isSame(from, other.to) && isSame(to, other.from))) continue
    for (let step = 0; step <= STEPS; step++) {
      const share = step / STEPS
      places.push({
        sides: [
          { triangle, uv: mixed(uvOf(from), uvOf(to), share) },
          { triangle: other.triangle, uv: mixed(uvOf(other.to), uvOf(other.from), share) },
        ],
      })
    }
  }
  return places
}

function mixed([a, b]: readonly [number, number], [c, d]: readonly [number, number], share: number) {
  return [a + share * (c - a), b + share * (d - b)] as const
}

/** Where a place of a texture is laid. */
export type Lay = (u: number, v: number) => readonly [number, number]

/** A little smaller, so that there is room round the island. */
export const shrink: Lay = (u, v) => [0.1 + 0.8 * u, 0.1 + 0.8 * v]
/** The left half of what was shrunk, turned by 180 degrees; texels of maps of 512 lie on the skin as they did. */
export const halfTurn: Lay = (u, v) => [280 / 512 - u, 1 - v]
/** The same, by 90 degrees and smaller. */
export const quarterTurn: Lay = (u, v) => [0.05 + 0.45 * (0.9 - v), 0.9 - 0.45 * (u - 0.1)]

/**
 * A skin whose texture is one island, and the same cut in two.
 *
 * @param isSecond whether a triangle belongs to the second island.
 * @param lay lays down the second island.
 */
export function cutInTwo(skin: Skin, isSecond: (triangle: number) => boolean, lay: Lay) {
  const vertices = skin.positions.length / 3
  const at = (i: number) => shrink(skin.uvs[2 * i]!, skin.uvs[2 * i + 1]!)
  const first = Array.from({ length: vertices }, (_, i) => at(i))
  const second = first.map(([u, v]) => lay(u, v))
  const twice = (values: ArrayLike<number>) =>
    Float64Array.from({ length: 2 * values.length }, (_, i) => values[i % values.length]!)
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
