import type { Skin } from 'furrow/author'

/** Vertex of a tube. */
export interface TubePoint {
  position: readonly [x: number, y: number, z: number]
  uv: readonly [u: number, v: number]
  /** Joints that move the vertex, with weights whose sum is 1. */
  shares: readonly (readonly [joint: number, weight: number])[]
}

/** Surface without a skeleton, with the joints of its vertices. */
export interface Tube {
  positions: number[]
  uvs: number[]
  indices: number[]
  shares: TubePoint['shares'][]
}

/**
 * Builds an open tube. Its last column of vertices lies on the first one.
 *
 * @param point returns the vertex at a fraction along the tube and a fraction around it. Seen from the end at which `along` is 1, `around`
 *   grows counterclockwise, so that the outside is visible.
 */
export function tube(
  around: number,
  along: number,
  point: (along: number, around: number) => TubePoint,
): Tube {
  const built: Tube = { positions: [], uvs: [], indices: [], shares: [] }
  for (let i = 0; i <= along; i++)
    for (let k = 0; k <= around; k++) {
      const { uv } = point(i / along, k / around)
      const { position, shares } = point(i / along, (k % around) / around)
      built.positions.push(...position)
      built.uvs.push(...uv)
      built.shares.push(shares)
    }
  const row = around + 1
  for (let i = 0; i < along; i++)
    for (let k = 0; k < around; k++) {
      const a = i * row + k
      built.indices.push(a, a + 1, a + row, a + 1, a + row + 1, a + row)
    }
  return built
}

/** Joins tubes to one skin. */
export function skinOf(tubes: readonly Tube[], joints: NonNullable<Skin['skeleton']>['joints']): Skin {
  const shares = tubes.flatMap((each) => each.shares)
  const influences = Math.max(...shares.map(({ length }) => length))
  const padded = (value: (share: TubePoint['shares'][number]) => number) =>
    shares.flatMap((own) => Array.from({ length: influences }, (_, i) => (own[i] ? value(own[i]) : 0)))
  const firsts = tubes.map((_, i) => tubes.slice(0, i).reduce((sum, each) => sum + each.shares.length, 0))
  return {
    positions: tubes.flatMap(({ positions }) => positions),
    uvs: tubes.flatMap(({ uvs }) => uvs),
    indices: tubes.flatMap(({ indices }, i) => indices.map((index) => index + firsts[i]!)),
    targets: [],
    skeleton: {
      joints,
      influences,
      indices: padded(([joint]) => joint),
      weights: padded(([, weight]) => weight),
    },
  }
}
