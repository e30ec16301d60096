import { type AutoWrinkles, autoWrinkles, CLOTH_KINDS } from 'furrow/author'
import { describe, expect, it } from 'vitest'
import { activationsOf, withJoints } from './models.ts'
import { bothSleeves, type SleeveOptions, sleeve } from './sleeve.ts'

const SETTINGS = { size: 256, areaSize: 64, cloth: 'shirt' } as const
const RADIUS = 55
/** Length of the sleeve in millimetres. */
const LENGTH = 520
const skin = sleeve()
const made = autoWrinkles(skin, SETTINGS)
const STEPS = 200

describe('a sleeve', () => {
  it('folds at its elbow, in one area that follows the compression', () => {
    expect(made.emptyReason).toBeUndefined()
    expect(made.jointAreas.map(({ name }) => name)).toEqual(['LeftForeArm flexion'])
    const [{ lines, error, compression }] = made.jointAreas as [AutoWrinkles['jointAreas'][number]]
    expect(lines).toBeGreaterThan(5)
    expect(error).toBeLessThan(0.2)
    expect(compression).toBeGreaterThan(0.1)
  })

  it('rises and never sinks, because the arm is below it', () => {
    const { data } = made.layers[0]!.heights
    expect(Math.min(...data)).toBe(0)
    expect(Math.max(...data)).toBeGreaterThan(3)
    for (const { depth } of made.layers[0]!.strokes) expect(depth).toBeLessThan(0)
  })

  it('makes up the lost length within 15%', () => {
    const { taken, lost } = lengthsOf(made)
    expect(taken / lost).toBeGreaterThan(0.85)
    expect(taken / lost).toBeLessThan(1.15)
  })

  it('has no folds at its hems and at the tip of the elbow', () => {
    const { width, height, data } = made.jointAreas[0]!.weights
    const column = (x: number) => Array.from({ length: height }, (_, y) => data[y * width + x]!)
    expect(Math.max(...column(Math.round(0.03 * width)), ...column(Math.round(0.97 * width)))).toBe(0)
    const heights = made.layers[0]!.heights
    const tallest = (v: number) => {
      const row = Math.round(v * heights.height)
      return Math.max(...heights.data.subarray(row * heights.width, (row + 1) * heights.width))
    }
    // The forearm flexes forwards, which is at a quarter of the texture.
    expect(tallest(0.26)).toBeGreaterThan(2 * tallest(0.74))
  })

  it('changes smoothly while the elbow turns through its range, and only if it flexes', () => {
    const activations = activationsOf(skin, made)
    const { name, drivers } = made.jointAreas[0]!
    const [{ joints, axis, curve }] = drivers as [(typeof drivers)[number]]
    const last = curve[curve.length - 1]![0]
    let before = 0
    for (let step = 0; step <= STEPS; step++) {
      const angle = (last * step) / STEPS
      const now = activations([[joints[1], axis!, angle]])[name]!
      expect(Math.abs(now - before)).toBeLessThan(0.03)
      before = now
    }
    expect(before).toBeCloseTo(1, 2)
    expect(activations([[joints[1], axis!, -0.4]])[name]).toBe(0)
  })

  it('is the same for the same seed, and differs for another one', () => {
    const [again, other] = [autoWrinkles(skin, SETTINGS), autoWrinkles(skin, { ...SETTINGS, seed: 7 })]
    expect(again.layers[0]!.normal.data).toEqual(made.layers[0]!.normal.data)
    expect(other.layers[0]!.normal.data).not.toEqual(made.layers[0]!.normal.data)
  })
})

it('stiffer cloth has wider and fewer folds', () => {
  const folds = CLOTH_KINDS.map((cloth) => {
    const { layers } = autoWrinkles(skin, { ...SETTINGS, cloth })
    const widths = layers[0]!.strokes.map(({ width }) => width).sort((a, b) => a - b)
    return { width: widths[widths.length >> 1]!, count: widths.length }
  })
  for (let i = 1; i < folds.length; i++) {
    expect(folds[i]!.width).toBeGreaterThan(1.15 * folds[i - 1]!.width)
    expect(folds[i]!.count).toBeLessThanOrEqual(folds[i - 1]!.count)
  }
})

it('maps are as large as the folds need', () => {
  const sizeOf = (cloth: (typeof CLOTH_KINDS)[number], size: number) =>
    autoWrinkles(skin, { ...SETTINGS, cloth, size }).layers[0]!.normal.width
  expect(sizeOf('silk', 1024)).toBe(512)
  expect(sizeOf('leather', 1024)).toBe(256)
  expect(sizeOf('leather', 128)).toBe(128)
})

describe('the folds do not depend on', () => {
  it.each<[string, SleeveOptions]>([
    ['the unit of length', { scale: 100 }],
    ['the size of triangles', { around: 64, along: 100 }],
  ])('%s', (_, options) => {
    const other = autoWrinkles(sleeve(options), SETTINGS)
    expect(Math.abs(other.jointAreas[0]!.lines - made.jointAreas[0]!.lines)).toBeLessThan(5)
    const { taken, lost } = lengthsOf(other)
    expect(Math.abs(taken / lost - 1)).toBeLessThan(0.15)
  })
})

describe('an unusual skeleton', () => {
  it('with 300 more joints gives the same folds', () => {
    const { joints } = skin.skeleton!
    const more = Array.from({ length: 300 }, (_, i) => ({ ...joints[0]!, name: `extra ${i}`, parent: 0 }))
    const skeleton = { ...skin.skeleton!, joints: [...joints, ...more] }
    expect(autoWrinkles({ ...skin, skeleton }, SETTINGS).layers[0]!.strokes).toEqual(made.layers[0]!.strokes)
  })

  it('with 8 influences per vertex gives the same folds', () => {
    const { influences, indices, weights, ...skeleton } = skin.skeleton!
    const count = indices.length / influences
    const spread = (values: ArrayLike<number>) =>
      Array.from({ length: 8 * count }, (_, i) => (i % 8 < 2 ? values[2 * Math.floor(i / 8) + (i % 8)]! : 0))
    const eight = { ...skeleton, influences: 8, indices: spread(indices), weights: spread(weights) }
    expect(autoWrinkles({ ...skin, skeleton: eight }, SETTINGS).layers[0]!.strokes).toEqual(
      made.layers[0]!.strokes,
    )
  })

  it('with an elbow of size 0 gives a reason', () => {
    const flat = withJoints(skin, (joint) =>
      joint.name === 'LeftForeArm'
        ? { ...joint, bind: Array.from(joint.bind, (value, i) => (i < 12 ? 0 : value)) }
        : joint,
    )
    expect(autoWrinkles(flat, SETTINGS).emptyReason).toMatch(/no joint/)
  })

  it('with unknown names gives a reason', () => {
    const unknown = sleeve({ joints: ['a', 'b', 'c'] })
    expect(autoWrinkles(unknown, SETTINGS).emptyReason).toMatch(/no joint/)
  })
})

it('two sleeves that share texels get the folds of one, which each elbow activates by half', () => {
  const both = bothSleeves()
  const shared = autoWrinkles(both, SETTINGS)
  expect(shared.jointAreas).toHaveLength(1)
  const [{ name, drivers }] = shared.jointAreas as [AutoWrinkles['jointAreas'][number]]
  expect(drivers.map(({ joints }) => joints[1]).sort()).toEqual(['LeftForeArm', 'RightForeArm'])
  const activations = activationsOf(both, shared)
  const bends = drivers.map(
    ({ joints, axis, curve }) => [joints[1], axis!, curve[curve.length - 1]![0]] as const,
  )
  for (const bend of bends) expect(activations([bend])[name]).toBeCloseTo(0.5, 2)
  expect(activations(bends)[name]).toBeCloseTo(1, 2)
})

it('a sleeve of 200,000 triangles folds in under 30 seconds of CPU time', () => {
  const before = process.cpuUsage()
  const dense = autoWrinkles(sleeve({ around: 320, along: 313 }), SETTINGS)
  const { user, system } = process.cpuUsage(before)
  expect(dense.jointAreas[0]!.lines).toBeGreaterThan(5)
  expect((user + system) / 1e6).toBeLessThan(30)
})

it('an unknown kind of cloth is an error that lists the kinds', () => {
  expect(() => autoWrinkles(skin, { ...SETTINGS, cloth: 'tin' as never })).toThrow(
    /silk, shirt, denim, leather/,
  )
})

/**
 * Integrates over the crook of the sleeve: the length that the relief adds to compressed cloth, and the length that the cloth loses. The cloth
 * there loses more than folds take up, so the lost length is the limit.
 */
function lengthsOf({ layers, jointAreas }: AutoWrinkles): { taken: number; lost: number } {
  const { width, height, data } = layers[0]!.heights
  const { compression } = jointAreas[0]!
  const step = LENGTH / (0.96 * width)
  const around = (2 * Math.PI * RADIUS) / (0.96 * height)
  let [taken, lost] = [0, 0]
  // Texels within 40 degrees of the crook and 45 mm of the elbow lose more than the limit.
  const [middle, reach] = [0.25, 40 / 360]
  for (let y = Math.round((middle - reach) * height); y < (middle + reach) * height; y++) {
    const centre = (ELBOW_AT * 0.96 + 0.02) * width
    for (let x = Math.round(centre - 45 / step); x < centre + 45 / step; x++) {
      const i = y * width + x
      const along = (data[i + 1]! - data[i - 1]!) / (2 * step)
      const across = (data[i + width]! - data[i - width]!) / (2 * around)
      const left = 1 - compression
      taken += Math.sqrt(left * left + along * along + across * across) - left
      lost += compression
    }
  }
  return { taken, lost }
}

/** Position of the elbow along the sleeve, 0..1. */
const ELBOW_AT = (0.48 - 0.22) / 0.52
