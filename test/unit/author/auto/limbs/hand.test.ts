import { type AutoWrinkles, autoWrinkles, type Skin } from 'furrow/author'
import { Matrix4 } from 'three'
import { describe, expect, it } from 'vitest'
import { activationsOf, shippedSkin, withJoints } from './models.ts'

const SETTINGS = { size: 64, areaSize: 32 }
const skin = await shippedSkin('hand')
const hand = autoWrinkles(skin, SETTINGS)
const STEPS = 200

const namesOf = ({ jointAreas }: AutoWrinkles) => jointAreas.map(({ name }) => name)
const linesOf = ({ jointAreas }: AutoWrinkles) => jointAreas.map(({ lines }) => lines)

describe('a hand that joints move', () => {
  it('gets creases at every joint of the fingers, in the palm and at the wrist', () => {
    const names = namesOf(hand)
    for (const finger of [2, 3, 4, 5]) {
      for (const joint of [1, 2, 3]) expect(names).toContain(`finger${finger}-${joint}.L flexion`)
      for (const joint of [2, 3]) expect(names).toContain(`finger${finger}-${joint}.L back`)
    }
    for (const part of ['distal crease', 'proximal crease', 'thenar crease', 'flexion', 'extension'])
      expect(names).toContain(`wrist.L ${part}`)
    expect(hand.layers.length).toBeLessThanOrEqual(4)
    expect(hand.warnings).toEqual([expect.stringMatching(/^creases of hands or neck look coarse/)])
    expect(hand.emptyReason).toBeUndefined()
  })

  it('has drivers that follow the compression of the skin', () => {
    for (const { name, error } of hand.jointAreas) expect(error, name).toBeLessThan(0.25)
  })

  it('changes smoothly while each joint turns through its range', () => {
    const activations = activationsOf(skin, hand)
    for (const { name, drivers } of hand.jointAreas) {
      for (const { joints, axis, curve } of drivers) {
        const [[first], [last]] = [curve[0]!, curve[curve.length - 1]!]
        let before = activations([[joints[1], axis!, first]])
        for (let step = 1; step <= STEPS; step++) {
          const angle = first + ((last - first) * step) / STEPS
          const now = activations([[joints[1], axis!, angle]])
          for (const [area, value] of Object.entries(now)) {
            // A wrist passes from flexion to extension, whose range is shorter.
            const most = Math.abs(angle) < last / 16 ? 0.035 : 0.03
            expect(Math.abs(value - before[area]!), `${name} moves ${area}`).toBeLessThan(most)
          }
          before = now
        }
        expect(before[name]).toBeGreaterThan(drivers.length > 1 ? 0.3 : -1)
      }
    }
  })

  it('is creased at rest, creases fully in a fist, and its knuckles become smooth', () => {
    const activations = activationsOf(skin, hand)
    const rest = activations([])
    const fist = activations(
      hand.jointAreas
        .flatMap(({ name, drivers }) =>
          /flexion|crease/.test(name) && !/^wrist.L flexion/.test(name)
            ? drivers
                .slice(0, 1)
                .map(({ joints, axis, curve }) => [joints[1], axis!, curve[curve.length - 1]![0]] as const)
            : [],
        )
        .filter(([joint], i, all) => all.findIndex(([other]) => other === joint) === i),
    )
    expect(rest['finger3-2.L flexion']).toBeCloseTo(0.4, 2)
    expect(rest['finger3-2.L back']).toBe(1)
    expect(fist['finger3-2.L flexion']).toBeGreaterThan(0.99)
    expect(fist['finger3-2.L back']).toBe(0)
    expect(fist['wrist.L distal crease']).toBeGreaterThan(0.99)
  })

  it('is the same for the same seed, and differs for another one', () => {
    const [again, other] = [autoWrinkles(skin, SETTINGS), autoWrinkles(skin, { ...SETTINGS, seed: 7 })]
    expect(again.layers[0]!.normal.data).toEqual(hand.layers[0]!.normal.data)
    expect(other.layers[0]!.normal.data).not.toEqual(hand.layers[0]!.normal.data)
  })
})

describe('the creases of a hand do not depend on', () => {
  const meaningless = withJoints(skin, (joint, i) => ({ ...joint, name: `node ${(5 * i) % 23}` }))
  const turned = withJoints(skin, (joint, i) => ({
    ...joint,
    bind: new Matrix4()
      .fromArray([...(joint.bind as number[])])
      .multiply(new Matrix4().makeRotationX(i))
      .toArray(),
  }))

  it.each([
    ['the names of joints', meaningless],
    ['the axes of joints', turned],
    ['the unit of length', scaled(skin, 100)],
  ])('%s', (_, changed) => {
    const made = autoWrinkles(changed, SETTINGS)
    expect(made.emptyReason).toBeUndefined()
    expect(made.jointAreas).toHaveLength(hand.jointAreas.length)
    // Names of joints are part of the seed of a hand.
    if (changed !== meaningless) expect(linesOf(made)).toEqual(linesOf(hand))
    const activations = activationsOf(changed, made)
    expect(Object.values(activations([])).map((value) => Math.round(100 * value))).toEqual(
      Object.values(activationsOf(skin, hand)([])).map((value) => Math.round(100 * value)),
    )
  })
})

describe('a skeleton that is not usual', () => {
  it('with 300 more joints gives the same creases', () => {
    const { joints } = skin.skeleton!
    const more = Array.from({ length: 300 }, (_, i) => ({ ...joints[0]!, name: `extra ${i}`, parent: 0 }))
    const made = autoWrinkles(
      { ...skin, skeleton: { ...skin.skeleton!, joints: [...joints, ...more] } },
      SETTINGS,
    )
    expect(linesOf(made)).toEqual(linesOf(hand))
  })

  it('with a joint of size 0 still gives creases', () => {
    const flat = withJoints(skin, (joint) =>
      joint.name === 'finger3-2.L'
        ? { ...joint, bind: [...(joint.bind as number[])].map((v, i) => (i < 12 ? 0 : v)) }
        : joint,
    )
    const made = autoWrinkles(flat, SETTINGS)
    expect(namesOf(made).length).toBeGreaterThan(20)
    expect(namesOf(made)).not.toContain('finger3-2.L flexion')
    for (const { drivers } of made.jointAreas)
      for (const { axis } of drivers)
        expect(axis!.every(Number.isFinite) && Math.hypot(...axis!) > 0).toBe(true)
  })

  it('without a hand and a neck gives a reason', () => {
    const { joints } = skin.skeleton!
    const root = {
      ...skin.skeleton!,
      joints: joints.slice(0, 1),
      indices: new Uint16Array(skin.skeleton!.indices.length),
    }
    expect(autoWrinkles({ ...skin, skeleton: root }, SETTINGS).emptyReason).toBe(
      'no joint of a hand, a neck, an elbow, a knee or a waist folds the surface',
    )
  })
})

describe('two hands that share texels', () => {
  const both = withMirrorImage(skin)
  const made = autoWrinkles(both, SETTINGS)

  it('get the creases of one hand, which the joints of both activate by half', () => {
    expect(linesOf(made)).toEqual(linesOf(hand))
    const activations = activationsOf(both, made)
    const { axis } = made.jointAreas.find(({ name }) => name === 'finger3-2.L flexion')!.drivers[0]!
    const area = (bends: Parameters<typeof activations>[0]) => activations(bends)['finger3-2.L flexion']!
    expect(area([])).toBeCloseTo(0.4, 2)
    expect(area([['finger3-2.L', axis!, 1.9]])).toBeCloseTo(0.7, 2)
  })
})

/** Adds the mirror image of a hand, with the same texture coordinates and its own joints. */
function withMirrorImage({ positions, uvs, indices, skeleton, targets }: Skin): Skin {
  const count = positions.length / 3
  const { joints, influences, ...own } = skeleton!
  const flip = (bind: ArrayLike<number>) =>
    Array.from(bind, (value, i) => (i % 4 === 0 ? -value : value)).map((value, i) => (i < 4 ? -value : value))
  const mirrored = joints.map(({ name, parent, bind }) => ({
    name: name.replace(/L$/, 'R'),
    parent: parent < 0 ? parent : parent + joints.length,
    bind: flip(bind),
  }))
  const reversed = Array.from(indices, (_, i) => indices[i - (i % 3) + 2 - (i % 3)]! + count)
  return {
    positions: [
      ...Array.from(positions),
      ...Array.from(positions, (value, i) => (i % 3 === 0 ? -value : value)),
    ],
    uvs: [...Array.from(uvs), ...Array.from(uvs)],
    indices: [...Array.from(indices), ...reversed],
    targets,
    skeleton: {
      joints: [...joints, ...mirrored],
      influences,
      indices: [...Array.from(own.indices), ...Array.from(own.indices, (joint) => joint + joints.length)],
      weights: [...Array.from(own.weights), ...Array.from(own.weights)],
    },
  }
}

/** Returns a skin in another unit of length. */
function scaled({ positions, skeleton, ...skin }: Skin, factor: number): Skin {
  const place = (bind: ArrayLike<number>) =>
    Array.from(bind, (value, i) => (i % 4 === 3 ? value : factor * value))
  return {
    ...skin,
    positions: Array.from(positions, (value) => factor * value),
    skeleton: {
      ...skeleton!,
      joints: skeleton!.joints.map((joint) => ({ ...joint, bind: place(joint.bind) })),
    },
  }
}
