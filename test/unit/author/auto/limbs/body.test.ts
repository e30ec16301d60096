import { findBody } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { FINGERS, PIGTAILS, RIGS, SKIRTS, type SkeletonOptions, skeletonOf, TWISTS } from './rigs.ts'

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

/** Names that say nothing, in an order that says nothing either. */
const rename = (_: string, i: number) => `node${(7 * i) % 97}`

describe.each(Object.keys(RIGS))('a skeleton of %s with meaningless names', (name) => {
  it.each(VARIANTS)('%s has the same hands, neck, elbows, knees and trunk', (_, options) => {
    const rig = RIGS[name]!
    const known = findBody(skeletonOf(rig, options))
    const { hands, neck, limbs, trunk } = findBody(skeletonOf(rig, { ...options, rename }))
    expect(neck).toEqual(known.neck)
    expect(trunk).toEqual(known.trunk)
    expect(hands).toHaveLength(2)
    for (const hand of hands) {
      const same = known.hands.find(({ wrist }) => wrist === hand.wrist)!
      expect(hand.fingers).toEqual(same.fingers)
    }
    const withoutSides = known.limbs.map((limb) => ({ ...limb, side: undefined }))
    expect(limbs).toHaveLength(4)
    expect(limbs).toEqual(expect.arrayContaining(withoutSides))
  })

  it('has the same elbows and knees without fingers', () => {
    const [known, nameless] = [{}, { rename }].map((options) =>
      findBody(skeletonOf(RIGS[name]!, { ...options, fingers: false })).limbs.map(({ kind, hinge }) => [
        kind,
        hinge,
      ]),
    )
    expect(nameless).toEqual(expect.arrayContaining(known!))
    expect(nameless).toHaveLength(4)
  })

  it('has the same elbows and knees with twist joints, skirts and pigtails', () => {
    const rig = { ...RIGS[name]!, extra: [...TWISTS, ...SKIRTS, ...PIGTAILS] }
    const [known, nameless] = [skeletonOf(rig), skeletonOf(rig, { rename })].map((skeleton) =>
      findBody(skeleton).limbs.map(({ kind, hinge }) => [kind, hinge]),
    )
    expect(nameless).toEqual(expect.arrayContaining(known!))
    expect(nameless).toHaveLength(4)
  })
})

it('the trunk of a person has the joints from the legs to the arms', () => {
  const skeleton = skeletonOf(RIGS.Mixamo!)
  const { base, chain } = findBody(skeleton).trunk!
  expect([base, ...chain].map((joint) => skeleton.joints[joint]!.name)).toEqual([
    'mixamorig:Hips',
    'mixamorig:Spine',
    'mixamorig:Spine2',
  ])
})

it('a dog has no elbows, no knees and no trunk', () => {
  // A dog is a person whose spine is horizontal.
  const dog = skeletonOf(RIGS.Mixamo!, { rename, fingers: false })
  const joints = dog.joints.map((joint, i) => {
    const bind = Array.from(joint.bind)
    const isTrunk = i < 5
    if (isTrunk) [bind[13], bind[14]] = [1, bind[13]! - 1]
    else if (Math.abs(bind[12]!) > 0.15 || bind[13]! > 1.2)
      [bind[12], bind[13], bind[14]] = [0.1 * Math.sign(bind[12]!), 1.1 - Math.abs(bind[12]!), 0.4]
    return { ...joint, bind }
  })
  const { limbs, trunk } = findBody({ ...dog, joints })
  expect(limbs).toEqual([])
  expect(trunk).toBeUndefined()
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
    trunk: undefined,
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
