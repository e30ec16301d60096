import type { GrayImage, TensionDriver } from 'furrow'
import {
  DriverProgram,
  measuredSource,
  planDrivers,
  sampleTriangles,
  TensionMeasurement,
  type TensionSample,
} from 'furrow/internal'
import { Euler, Matrix4, Vector3 } from 'three'
import { describe, expect, it } from 'vitest'
import { ramp } from '../../drivers.ts'
import { seeded } from '../../random.ts'

const RULER = ramp(-1, 1)
const full: GrayImage = { width: 4, height: 4, data: new Uint8Array(16).fill(255) }
const driver = (measure: TensionDriver['measure'], area = 'sheet'): TensionDriver => ({
  type: 'tension',
  area,
  measure,
  curve: RULER,
})

/** Returns a sheet of 1 x 1 in the plane z = 0, with `side` x `side` squares. `wobble` shifts inner points randomly. */
function sheet(side: number, wobble = 0) {
  const random = seeded(side)
  const [positions, uvs, triangles]: number[][] = [[], [], []]
  for (let y = 0; y <= side; y++) {
    for (let x = 0; x <= side; x++) {
      const [u, v] = [x, y].map((place) =>
        place > 0 && place < side ? (place + wobble * (random() - 0.5)) / side : place / side,
      )
      positions.push(u, v, 0)
      uvs.push(u, v)
    }
  }
  for (let y = 0; y < side; y++) {
    for (let x = 0; x < side; x++) {
      const a = y * (side + 1) + x
      triangles.push(a, a + 1, a + side + 2, a, a + side + 2, a + side + 1)
    }
  }
  return { positions, uvs, triangles }
}

type Sheet = ReturnType<typeof sheet>

/** Moves every point of a sheet, and returns the value that a tension driver measures. */
function measure(
  rest: Sheet,
  measure: TensionDriver['measure'],
  move: (point: Vector3) => Vector3,
  count = 24,
) {
  const triangles = sampleTriangles(rest, full, count)
  expect(triangles).toHaveLength(3 * count)
  const now = rest.positions.slice()
  for (let i = 0; i < now.length; i += 3) move(new Vector3().fromArray(rest.positions, i)).toArray(now, i)
  const { activations, measured } = drive(
    [driver(measure)],
    [{ area: 'sheet', triangles }],
    rest.positions,
    now,
  )
  expect(activations[0]).toBeCloseTo(measured[0] / 2 + 0.5, 5)
  return measured[0]
}

/** Evaluates tension drivers at new positions. Returns their measured values and activations. */
function drive(
  drivers: TensionDriver[],
  samples: TensionSample[],
  rest: ArrayLike<number>,
  now: ArrayLike<number>,
) {
  const plan = planDrivers(drivers)
  const tension = new TensionMeasurement(plan.inputs.tension, samples, rest)
  const program = new DriverProgram(plan, { tension: measuredSource(tension.missing) })
  const state = program.createState()
  tension.measure(now, state.inputs.tension)
  program.evaluate(state)
  return { activations: state.activations, measured: state.inputs.tension, missing: program.missing }
}

describe('tension drivers', () => {
  const turn = new Matrix4().makeRotationFromEuler(new Euler(0.4, 1.2, -2)).setPosition(3, -1, 7)

  it.each([1, 2, 5, 16, 40])('report 0.20 for %d squares per side, shortened by 20%% along x', (side) => {
    const shorten = (point: Vector3) => point.multiply(new Vector3(0.8, 1, 1))
    expect(measure(sheet(side), 'compression', shorten)).toBeCloseTo(0.2, 9)
    expect(
      measure(sheet(side, 0.6), 'compression', (point) => shorten(point).applyMatrix4(turn)),
    ).toBeCloseTo(0.2, 6)
  })

  it('report compression and stretch correctly in any direction', () => {
    for (const angle of [0.3, 1, 2.4]) {
      const there = new Matrix4().makeRotationZ(angle)
      const along = new Matrix4().makeScale(1.3, 0.9, 1)
      const move = there.clone().multiply(along).multiply(there.clone().invert())
      expect(measure(sheet(6, 0.5), 'compression', (point) => point.applyMatrix4(move))).toBeCloseTo(0.1, 6)
      expect(measure(sheet(6, 0.5), 'stretch', (point) => point.applyMatrix4(move))).toBeCloseTo(0.3, 6)
    }
  })

  it('report 0 for a rigid motion', () => {
    for (const kind of ['compression', 'stretch'] as const) {
      expect(Math.abs(measure(sheet(7, 0.6), kind, (point) => point.applyMatrix4(turn)))).toBeLessThan(1e-7)
    }
  })

  it('report 0 for folding without a change of length', () => {
    const fold = (point: Vector3) => new Vector3(Math.min(point.x, 0.5), point.y, Math.max(0, point.x - 0.5))
    expect(Math.abs(measure(sheet(8), 'compression', fold, 64))).toBeLessThan(1e-7)
  })

  it('report the mean over the area', () => {
    // The compression along y increases linearly, from 0 at y = 0 to 40% at y = 1.
    const fan = (point: Vector3) => point.set(point.x, point.y * (1 - 0.2 * point.y), 0)
    expect(measure(sheet(40), 'compression', fan, 400)).toBeCloseTo(0.2, 2)
  })

  it('have signed measures: compression is negative if the skin grows, and stretch if it shrinks', () => {
    const grow = (point: Vector3) => point.multiplyScalar(1.25)
    expect(measure(sheet(4), 'compression', grow)).toBeCloseTo(-0.25, 9)
    expect(measure(sheet(4), 'stretch', (point) => point.multiplyScalar(0.5))).toBeCloseTo(-0.5, 9)
  })

  it('use external measurements, except for areas without triangles', () => {
    const plan = planDrivers([driver('compression'), driver('stretch'), driver('compression', 'gone')])
    const program = new DriverProgram(plan, { tension: measuredSource([[], [], ['triangles']]) })
    const state = program.createState()
    state.inputs.tension.set([-0.8, -0.6, 0.5])
    program.evaluate(state)
    // The activations by the two drivers of the area add up.
    expect(state.activations[0]).toBeCloseTo(0.1 + 0.2, 6)
    expect(state.activations[1]).toBe(0)
  })

  it('ignore areas that cover nothing, and degenerate triangles', () => {
    const rest = sheet(1)
    const triangles = [0, 0, 0, 0, 1, 1, ...rest.triangles]
    const { activations, measured, missing } = drive(
      [driver('compression'), driver('compression', 'gone')],
      [{ area: 'sheet', triangles }],
      rest.positions,
      rest.positions.map((value, i) => (i % 3 === 0 ? value * 0.7 : value)),
    )
    expect(missing).toEqual(['triangles of a driver of area "gone"'])
    expect(measured[0]).toBeCloseTo(0.3, 9)
    expect(activations[1]).toBe(0)
  })
})

describe('tension along a direction of the texture', () => {
  /** Returns the tension of a sheet along several directions of its texture, after a function has moved its points. */
  function along(
    directions: readonly (readonly [number, number])[],
    rest: Sheet,
    move: (point: Vector3) => Vector3,
    kind: TensionDriver['measure'] = 'compression',
  ): number[] {
    const now = rest.positions.slice()
    for (let i = 0; i < now.length; i += 3) move(new Vector3().fromArray(rest.positions, i)).toArray(now, i)
    const plan = planDrivers(directions.map(([u, v]) => ({ ...driver(kind), direction: [u, v] })))
    const samples = [{ area: 'sheet', triangles: rest.triangles }]
    const tension = new TensionMeasurement(plan.inputs.tension, samples, rest.positions, rest.uvs)
    const out = new Float64Array(directions.length)
    tension.measure(now, out)
    return [...out]
  }
  const turn = new Matrix4().makeRotationFromEuler(new Euler(0.4, 1.2, -2)).setPosition(3, -1, 7)
  const shorten = (point: Vector3) => point.multiply(new Vector3(0.8, 1, 1)).applyMatrix4(turn)

  it('depends on the direction: skin that is shortened along u keeps its length along v', () => {
    const [u, back, v, diagonal] = along([[1, 0], [-3, 0], [0, 0.2], [1, 1]], sheet(6, 0.5), shorten) // biome-ignore format: one line
    expect(u).toBeCloseTo(0.2, 9)
    expect(back).toBeCloseTo(0.2, 9)
    expect(v).toBeCloseTo(0, 9)
    expect(diagonal).toBeCloseTo(1 - Math.sqrt((0.8 ** 2 + 1) / 2), 9)
  })

  it('is signed, and follows a turned, mirrored or sheared texture', () => {
    const rest = sheet(5, 0.4)
    const mapped = (map: (u: number, v: number) => [number, number]) => ({
      ...rest,
      uvs: rest.uvs.flatMap((_, i) => (i % 2 === 0 ? map(rest.uvs[i], rest.uvs[i + 1]) : [])),
    })
    const turned = mapped((u, v) => [0.3 - v, 0.1 + u])
    expect(along([[0, 1]], turned, shorten, 'stretch')[0]).toBeCloseTo(-0.2, 9)
    expect(along([[1, 0]], turned, shorten, 'stretch')[0]).toBeCloseTo(0, 9)
    const mirrored = mapped((u, v) => [1 - u, v])
    expect(along([[1, 0]], mirrored, shorten)[0]).toBeCloseTo(0.2, 9)
    // A step along u is a step along the diagonal of the sheet, because v has to stay constant.
    const sheared = mapped((u, v) => [u, v - u])
    expect(along([[1, 0]], sheared, shorten)[0]).toBeCloseTo(1 - Math.sqrt((0.8 ** 2 + 1) / 2), 9)
  })

  it('leaves out triangles without area in the texture', () => {
    const rest = sheet(2)
    const uvs = rest.uvs.map((value, i) => (i < 6 ? 0 : value))
    expect(along([[1, 0]], { ...rest, uvs }, shorten)[0]).toBeCloseTo(0.2, 9)
    expect(along([[1, 0]], { ...rest, uvs: rest.uvs.map(() => 0) }, shorten)[0]).toBe(0)
  })
})

describe('sampleTriangles', () => {
  it('picks triangles with a probability that follows their weight, and none without weight', () => {
    const left: GrayImage = { width: 2, height: 1, data: Uint8Array.of(255, 0) }
    const mesh = sheet(10)
    const chosen = sampleTriangles(mesh, left, 50)
    for (const vertex of chosen) expect(mesh.positions[3 * vertex]).toBeLessThanOrEqual(0.5 + 1e-9)
    expect(new Set(chosen).size).toBeGreaterThan(30)
    expect(sampleTriangles(mesh, { width: 1, height: 1, data: Uint8Array.of(0) }, 50)).toHaveLength(0)
  })

  it('skips NaN positions', () => {
    const mesh = sheet(3)
    mesh.positions[0] = Number.NaN
    expect([...sampleTriangles(mesh, full, 200)]).not.toContain(0)
  })
})
