import { skinOf } from 'furrow/internal'
import { expect, it } from 'vitest'
import type { VectorData } from '../../../packages/furrow/src/auto/character.ts'

const vectors = (array: VectorData['array'], stride: number, isNormalized = false): VectorData => ({
  array,
  stride,
  start: 0,
  isNormalized,
})

it('up to eight weights per vertex have the sum 1, although three.js scales the first four alone', () => {
  const count = 3
  const skin = skinOf({
    label: '',
    names: [],
    placement: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
    joints: [0, 1, 2].map((i) => ({ name: `joint ${i}`, parent: i - 1, bind: [] })),
    isLit: true,
    frame: 'derivative',
    parts: [
      {
        count,
        positions: vectors(new Float32Array(3 * count), 3),
        uvs: vectors(new Float32Array(2 * count), 2),
        targets: [],
        isRelative: true,
        influences: [
          {
            joints: vectors(Uint8Array.of(0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0), 4),
            // The first vertex had the weights 0.3 and 0.1, and the second one only a weight in the second set.
            weights: vectors(Float32Array.of(0.75, 0.25, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0), 4),
          },
          {
            joints: vectors(Uint8Array.of(2, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0), 4),
            weights: vectors(Uint8Array.of(153, 0, 0, 0, 255, 0, 0, 0, 0, 0, 0, 0), 4, true),
          },
        ],
      },
    ],
  })
  const { influences, indices, weights } = skin.skeleton!
  expect(influences).toBe(8)
  const byJoint = Array.from({ length: count }, (_, vertex) => {
    const sums = [0, 0, 0]
    for (let k = 8 * vertex; k < 8 * vertex + 8; k++) sums[indices[k]!]! += weights[k]!
    return sums.map((sum) => Number(sum.toFixed(6)))
  })
  expect(byJoint).toEqual([
    [0.3, 0.1, 0.6],
    [0, 0, 1],
    [0, 1, 0],
  ])
})
