import type { Skin } from 'furrow/author'

/** A sleeve around an arm along +X, in metres. */
export interface SleeveOptions {
  radius?: number
  /** Number of vertices around and along the sleeve. */
  around?: number
  along?: number
  /** Factor on all positions. */
  scale?: number
  joints?: readonly [upper: string, lower: string, end: string]
}

const [START, ELBOW, END] = [0.2, 0.48, 0.74]

/** Returns a tube of cloth that two joints move. Its texture is the unrolled tube. */
export function sleeve({
  radius = 0.055,
  around = 40,
  along = 60,
  scale = 1,
  joints = ['LeftArm', 'LeftForeArm', 'LeftHand'],
}: SleeveOptions = {}): Skin {
  const [positions, uvs, indices, weights, influences]: number[][] = [[], [], [], [], []]
  for (let i = 0; i <= along; i++) {
    for (let k = 0; k <= around; k++) {
      const [s, t] = [i / along, k / around]
      const x = START + 0.02 + s * (END - START - 0.02)
      const angle = 2 * Math.PI * t
      positions.push(scale * x, scale * (1.4 + radius * Math.cos(angle)), scale * radius * Math.sin(angle))
      uvs.push(0.02 + 0.96 * s, 0.02 + 0.96 * t)
      const lower = Math.min(1, Math.max(0, (x - ELBOW) / 0.05 + 0.5))
      weights.push(1 - lower, lower)
      influences.push(1, 2)
    }
  }
  const row = around + 1
  for (let i = 0; i < along; i++)
    for (let k = 0; k < around; k++) {
      const a = i * row + k
      indices.push(a, a + 1, a + row, a + 1, a + row + 1, a + row)
    }
  const bind = (x: number) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, scale * x, scale * 1.4, 0, 1]
  const [upper, lower, end] = joints
  return {
    positions: closed(positions, row),
    uvs,
    indices,
    targets: [],
    skeleton: {
      joints: [
        { name: 'Spine', parent: -1, bind: bind(0) },
        { name: upper, parent: 0, bind: bind(START) },
        { name: lower, parent: 1, bind: bind(ELBOW) },
        { name: end, parent: 2, bind: bind(END) },
      ],
      influences: 2,
      indices: influences,
      weights,
    },
  }
}

/** Returns a left and a right sleeve that share all texels. */
export function bothSleeves(): Skin {
  const { skeleton, ...left } = sleeve()
  const { joints, influences, indices, weights } = skeleton!
  const [count, row] = [left.positions.length / 3, joints.length - 1]
  const other = (joint: number) => (joint === 0 ? 0 : joint + row)
  const mirrored = joints.slice(1).map(({ name, parent, bind }) => ({
    name: name.replace('Left', 'Right'),
    parent: other(parent),
    bind: Array.from(bind, (value, i) => (i === 12 ? -value : value)),
  }))
  // Mirroring reverses the order of corners.
  const reversed = Array.from(left.indices, (_, i) => left.indices[i - (i % 3) + 2 - (i % 3)]! + count)
  return {
    positions: [
      ...Array.from(left.positions),
      ...Array.from(left.positions, (value, i) => (i % 3 === 0 ? -value : value)),
    ],
    uvs: [...Array.from(left.uvs), ...Array.from(left.uvs)],
    indices: [...Array.from(left.indices), ...reversed],
    targets: [],
    skeleton: {
      joints: [...joints, ...mirrored],
      influences,
      indices: [...Array.from(indices), ...Array.from(indices, other)],
      weights: [...Array.from(weights), ...Array.from(weights)],
    },
  }
}

/** Gives the last vertex of each ring the position of the first one, so that they are merged. */
function closed(positions: number[], row: number): number[] {
  for (let first = 0; first < positions.length; first += 3 * row)
    for (let k = 0; k < 3; k++) positions[first + 3 * (row - 1) + k] = positions[first + k]!
  return positions
}
