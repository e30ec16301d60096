import { readFileSync } from 'node:fs'
import { driversOf, type MuscleDriver, muscleOffsets, parseDrivers } from 'furrow'
import { targetArea } from 'furrow/author'
import { readFaceMesh } from 'furrow-files/node'
import { Vector3 } from 'three'
import { beforeAll, describe, expect, it } from 'vitest'
import { driven } from '../../driven.ts'
import { seeded } from '../../random.ts'

const muscle = (more: Partial<MuscleDriver>): MuscleDriver => ({
  type: 'muscle',
  name: 'm',
  kind: 'linear',
  origin: [1, 2, 3],
  insertion: [1, 2, 5],
  angle: 0.5,
  width: 0.4,
  inner: 0.8,
  outer: 1.2,
  strength: 0.3,
  ...more,
})

const offset = (own: MuscleDriver, x: number, y: number, z: number) => [
  ...muscleOffsets(own, [1 + x, 2 + y, 3 + z]),
]
const near = (found: number[], expected: number[]) => {
  for (let k = 0; k < 3; k++) expect(found[k]).toBeCloseTo(expected[k], 6)
}

describe('muscleOffsets', () => {
  it('a linear muscle pulls towards its origin: most near its end, and nothing at the origin and beyond the end', () => {
    const linear = muscle({})
    // The pull is strongest at 0.8 of the muscle's length, which is 2.
    near(offset(linear, 0, 0, 1.6), [0, 0, -0.48])
    // Halfway to this point the factor is sin(45 degrees).
    near(offset(linear, 0, 0, 0.8), [0, 0, -0.3 * 0.8 * Math.SQRT1_2])
    // Halfway from 0.8 to 1.2 of the length, where the pull ends, the factor is cos(45 degrees).
    near(offset(linear, 0, 0, 2), [0, 0, -0.3 * 2 * Math.SQRT1_2])
    near(offset(linear, 0, 0, 2.4), [0, 0, 0])
    near(offset(linear, 0, 0, -1), [0, 0, 0])
    near(offset(linear, 0, 0, 0), [0, 0, 0])
    // A point 0.3 radians off the axis, at a distance of 1.6.
    const [x, z] = [1.6 * Math.sin(0.3), 1.6 * Math.cos(0.3)]
    const inside = (Math.cos(0.3) - Math.cos(0.5)) / (1 - Math.cos(0.5))
    near(offset(linear, x, 0, z), [-0.3 * inside * x, 0, -0.3 * inside * z])
    near(offset(linear, 1.6 * Math.sin(0.51), 0, 1.6 * Math.cos(0.51)), [0, 0, 0])
  })

  it('a sheet muscle pulls evenly', () => {
    const sheet = muscle({ kind: 'sheet' })
    near(offset(sheet, 0, 0, 1.6), [0, 0, -0.6])
    near(offset(sheet, 0.2, 0, 1.6), [0, 0, -0.6 * Math.SQRT1_2])
    near(offset(sheet, 0, 0.4, 1.6), [0, 0, 0])
    near(offset(sheet, 0, 0, 2), [0, 0, -0.6 * Math.SQRT1_2])
  })

  it('a sphincter closes on its centre', () => {
    const ring = muscle({ kind: 'sphincter' })
    near(offset(ring, 0.3, 0, 0), [-0.09, 0, 0])
    near(offset(ring, 0, 0, 1.5), [0, 0, -0.45])
    near(offset(ring, 0, 0, 2), [0, 0, -0.6 * Math.SQRT1_2])
    near(offset(ring, 0, 0.48, 0), [0, 0, 0])
  })

  it('moves nothing outside its zone, for random muscles', () => {
    const random = seeded(5)
    const vector = (): [number, number, number] => [random(), random(), random()]
    for (let i = 0; i < 200; i++) {
      const own = muscle({
        origin: vector(),
        insertion: vector(),
        angle: 0.1 + random(),
        width: 0.05 + random() / 4,
      })
      const points = Float64Array.from({ length: 300 }, random)
      const offsets = muscleOffsets(own, points)
      const axis = new Vector3(...own.insertion).sub(new Vector3(...own.origin))
      for (let k = 0; k < points.length; k += 3) {
        const from = new Vector3().fromArray(points, k).sub(new Vector3(...own.origin))
        const inZone = from.length() < own.outer * axis.length() && from.angleTo(axis) < own.angle
        const moved = offsets[k] !== 0 || offsets[k + 1] !== 0 || offsets[k + 2] !== 0
        expect(moved && !inZone).toBe(false)
      }
    }
  })
})

it('activates its area by the contraction', () => {
  const muscles = [muscle({ name: 'zygomaticMajorLeft', area: 'cheek' }), muscle({ name: 'bare' })]
  expect(driven(muscles, ['zygomaticMajorLeft']).activations({ weights: [0.37] })).toEqual({
    cheek: expect.closeTo(0.37, 6),
  })
})

describe.each(['human', 'human-2'])('the muscles of %s', (name) => {
  const json: { area?: string }[] = JSON.parse(readFileSync(`faces/${name}/muscles.json`, 'utf8'))
  const drivers = parseDrivers(
    json,
    json.flatMap(({ area }) => area ?? []),
  )
  const muscles = driversOf('muscle', drivers)
  let mesh: Awaited<ReturnType<typeof readFaceMesh>>['mesh']

  beforeAll(async () => {
    mesh = (await readFaceMesh(`faces/${name}.glb`, 'test')).mesh
  })

  it('exist on the left and the right, and form the six basic expressions', () => {
    expect(muscles.length).toBeGreaterThanOrEqual(18)
    const names = muscles.map((own) => own.name)
    for (const left of names.filter((own) => own.endsWith('Left')))
      expect(names).toContain(left.replace('Left', 'Right'))
    const expressions = driversOf('expression', drivers)
    expect(expressions.map((own) => own.name)).toEqual([
      'neutral',
      'happiness',
      'surprise',
      'anger',
      'sadness',
      'fear',
      'disgust',
    ])
    for (const { targets } of expressions) for (const target of targets) expect(names).toContain(target.name)
  })

  it.each(muscles.map((own) => [own.name, own] as const))(
    '%s has an area that covers the skin it moves, and nothing of the other side',
    (_, own) => {
      const offsets = muscleOffsets(own, mesh.positions)
      const area = targetArea(mesh, offsets, 128)
      const at = (i: number) => {
        const [u, v] = [mesh.uvs[2 * i], mesh.uvs[2 * i + 1]]
        const texel = (place: number) => Math.min(Math.floor(place * area.width), area.width - 1)
        return area.data[texel(v) * area.width + texel(u)]
      }
      const moved = [...Array(offsets.length / 3).keys()].filter(
        (i) => Math.hypot(offsets[3 * i], offsets[3 * i + 1], offsets[3 * i + 2]) > 0,
      )
      expect(moved.length).toBeGreaterThan(20)
      expect(moved.filter((i) => at(i) > 0).length / moved.length).toBeGreaterThanOrEqual(0.95)
      expect(Math.max(...area.data)).toBeGreaterThan(150)
      if (own.name !== 'zygomaticMajorLeft') return
      // u > 0.5 is the person's left.
      for (let y = 0; y < area.height; y++) {
        for (let x = 0; x < area.width / 2; x++) expect(area.data[y * area.width + x]).toBe(0)
      }
      // Allows a tenth of a millimetre beyond the middle.
      for (const i of moved) expect(mesh.positions[3 * i]).toBeGreaterThan(-1e-4)
    },
  )
})
