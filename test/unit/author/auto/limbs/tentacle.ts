import type { Skin } from 'furrow/author'

const [AROUND, ALONG] = [32, 80]
const STEP = 0.12
const COUNT = 5

export interface TentacleOptions {
  /** Depth of the cross-section as a fraction of its width: 1 for a tube, 0 for a ribbon. */
  depth?: number
  /** Rotations that animations show for each joint: packed quaternions. */
  rotations?: readonly number[]
}

/** Returns a tube along +Y in metres, which a chain of five joints moves. Its texture is the unrolled tube. */
export function tentacle({ depth = 1, rotations }: TentacleOptions = {}): Skin {
  const [positions, uvs, indices, weights, influences]: number[][] = [[], [], [], [], []]
  const length = STEP * COUNT
  for (let i = 0; i <= ALONG; i++) {
    for (let k = 0; k <= AROUND; k++) {
      const [s, t] = [i / ALONG, k / AROUND]
      const angle = 2 * Math.PI * (t === 1 ? 0 : t)
      positions.push(0.05 * Math.sin(angle), s * length, 0.05 * depth * Math.cos(angle))
      uvs.push(0.02 + 0.96 * t, 0.02 + 0.96 * s)
      // Joints take over around their positions, which are STEP apart.
      const at = Math.min(COUNT - 1, Math.max(0, (s * length) / STEP - 0.5))
      const first = Math.min(COUNT - 2, Math.floor(at))
      const share = Math.min(1, Math.max(0, (at - first - 0.5) / 0.6 + 0.5))
      weights.push(1 - share, share)
      influences.push(first, first + 1)
    }
  }
  const row = AROUND + 1
  for (let i = 0; i < ALONG; i++)
    for (let k = 0; k < AROUND; k++) {
      const a = i * row + k
      indices.push(a, a + 1, a + row, a + 1, a + row + 1, a + row)
    }
  const joints = Array.from({ length: COUNT }, (_, i) => ({
    name: `link ${i}`,
    parent: i - 1,
    bind: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, i * STEP, 0, 1],
    ...(rotations && { rotations }),
  }))
  return {
    positions,
    uvs,
    indices,
    targets: [],
    skeleton: { joints, influences: 2, indices: influences, weights },
  }
}
