import type { Skin } from 'furrow/author'
import { RIGS, type SkeletonOptions, skeletonOf } from './rigs.ts'

const [AROUND, ALONG] = [48, 40]
const [LOW, HIGH] = [0.98, 1.36]

/**
 * Returns a shirt without sleeves around the trunk of a person, in metres. Its texture is the unrolled shirt: u runs from the back over the
 * person's left, the front and the right, and v from the hem upwards.
 */
export function torso(options: SkeletonOptions = {}): Skin {
  const skeleton = skeletonOf(RIGS.Mixamo!, options)
  const { scale = 1 } = options
  const [hips, spine, chest] = [0, 1, 2]
  const [positions, uvs, indices, weights, influences]: number[][] = [[], [], [], [], []]
  for (let i = 0; i <= ALONG; i++) {
    for (let k = 0; k <= AROUND; k++) {
      const [s, t] = [i / ALONG, k / AROUND]
      const y = LOW + s * (HIGH - LOW)
      const angle = 2 * Math.PI * (t === 1 ? 0 : t)
      positions.push(0.165 * scale * Math.sin(angle), scale * y, -0.115 * scale * Math.cos(angle))
      uvs.push(0.02 + 0.96 * t, 0.02 + 0.96 * s)
      // Each joint takes over around its position.
      const [low, high] = [1.1, 1.25].map((at) => Math.min(1, Math.max(0, (y - at) / 0.1 + 0.5))) as [
        number,
        number,
      ]
      weights.push(1 - low, low - high, high)
      influences.push(hips, spine, chest)
    }
  }
  const row = AROUND + 1
  for (let i = 0; i < ALONG; i++)
    for (let k = 0; k < AROUND; k++) {
      const a = i * row + k
      indices.push(a, a + row, a + 1, a + 1, a + row, a + row + 1)
    }
  return {
    positions,
    uvs,
    indices,
    targets: [],
    skeleton: { ...skeleton, influences: 3, indices: influences, weights },
  }
}
