import { findBody } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { FINGERS, RIGS, type SkeletonOptions, skeletonOf } from './rigs.ts'

const VARIANTS: [string, SkeletonOptions][] = [
  ['in a T pose', {}],
  ['in an A pose', { armsDown: 45 }],
  ['whose joints have arbitrary axes', { turned: true }],
  ['in centimetres', { scale: 100 }],
]

describe.each(Object.entries(RIGS))('a skeleton of %s', (_, rig) => {
  it.each(VARIANTS)('%s has two hands, a neck, two elbows and two knees', (_, options) => {
    const skeleton = skeletonOf(rig, options)
    const nameOf = (joint: number) => skeleton.joints[joint]!.name
    const { hands, neck, limbs } = findBody(skeleton)
    expect(hands.map(({ side }) => side)).toEqual(['left', 'right'])
    for (const { side, wrist, fingers } of hands) {
      expect(nameOf(wrist)).toBe(rig.name('hand', side!))
      expect([...fingers.keys()]).toEqual(FINGERS)
      for (const [finger, joints] of fingers)
        expect(joints.map(nameOf)).toEqual([1, 2, 3].map((k) => rig.name(`${finger}${k}`, side!)))
    }
    expect(neck!.chain.map(nameOf)).toEqual([rig.name('neck', ''), rig.name('head', '')])
    expect(nameOf(neck!.base)).toBe(rig.name('chest', ''))
    expect(
      limbs.map(({ kind, start, hinge, end, ...limb }) => ({
        kind,
        side: limb.side,
        joints: [start, hinge, end!].map(nameOf),
      })),
    ).toEqual(
      (['elbow', 'knee'] as const).flatMap((kind) =>
        (['left', 'right'] as const).map((side) => ({
          kind,
          side,
          joints: (kind === 'elbow'
            ? ['upperArm', 'lowerArm', 'hand']
            : ['upperLeg', 'lowerLeg', 'foot']
          ).map((part) => rig.name(part, side)),
        })),
      ),
    )
  })
})

describe('a skeleton with meaningless names', () => {
  it.each(VARIANTS)('%s has the same hands and the same neck', (_, options) => {
    const rig = RIGS.Mixamo!
    const known = findBody(skeletonOf(rig, options))
    const { hands, neck } = findBody(skeletonOf(rig, { ...options, rename: (_, i) => `node${(7 * i) % 97}` }))
    expect(neck).toEqual(known.neck)
    expect(hands).toHaveLength(2)
    for (const hand of hands) {
      const same = known.hands.find(({ wrist }) => wrist === hand.wrist)!
      expect(hand.fingers).toEqual(same.fingers)
    }
  })
})

it('a skeleton of a table has no hands and no neck', () => {
  const legs = ['a', 'b', 'c', 'd'].flatMap((leg, i) =>
    [0, 1].map((k) => ({
      name: `${leg}${k}`,
      parent: k === 0 ? 0 : 2 * i + 1,
      bind: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, i % 2, 1 - 0.1 * k, i >> 1, 1],
    })),
  )
  const joints = [
    { name: 'top', parent: -1, bind: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, 1, 0.5, 1] },
    ...legs,
  ]
  const indices = joints.map((_, i) => i)
  expect(findBody({ joints, influences: 1, indices, weights: indices.map(() => 1) })).toEqual({
    hands: [],
    neck: undefined,
    limbs: [],
  })
})

it('a forearm in two parts without an upper arm has no elbow', () => {
  const arm = ['lowerarm01.L', 'lowerarm02.L', 'wrist.L'].map((name, i) => ({
    name,
    parent: i - 1,
    bind: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.15 * i, 1, 0, 1],
  }))
  const indices = arm.map((_, i) => i)
  const weights = indices.map(() => 1)
  expect(findBody({ joints: arm, influences: 1, indices, weights }).limbs).toEqual([])
})
