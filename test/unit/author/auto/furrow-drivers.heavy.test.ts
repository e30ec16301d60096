import type { GrayImage, TensionDriver } from 'furrow'
import { type AutoWrinkles, autoWrinkles, type Skin } from 'furrow/author'
import {
  curveAt,
  DriverProgram,
  measuredSource,
  planDrivers,
  reference,
  sampleTriangles,
  TensionMeasurement,
} from 'furrow/internal'
import { beforeAll, describe, expect, test } from 'vitest'
import { poseOf } from '../../../../packages/furrow/src/author/auto/surface/pose.ts'
import { driven } from '../../../driven.ts'
import { seeded } from '../../../random.ts'
import { skinAt } from '../../../skin-at.ts'
import { FACES, prepareFace } from './faces.ts'

type Pose = Readonly<Record<string, number>>

/** Triangles to sample per area. `ALL` gives an accurate mean compression and stretch. `FEW` is the number that tension drivers use on the CPU. */
const [ALL, FEW] = [4096, 16]
const POSES = 60

const both = (name: string, weight = 1) => ({ [`${name}Left`]: weight, [`${name}Right`]: weight })
const EXPRESSIONS: Record<string, Pose> = {
  frown: { ...both('browDown'), ...both('noseSneer', 0.6), ...both('eyeSquint', 0.4) },
  smile: { ...both('mouthSmile', 0.9), ...both('cheekSquint', 0.8), ...both('eyeSquint', 0.3) },
  surprise: { browInnerUp: 1, ...both('browOuterUp'), jawOpen: 0.6 },
  open: { jawOpen: 1 },
}

describe.each(FACES)('fine furrows of %s', (_, path) => {
  let skin: Skin
  let wrinkles: AutoWrinkles
  beforeAll(async () => {
    skin = await skinAt(path)
    wrinkles = autoWrinkles(skin, { size: 2048, furrows: true, age: 50 })
  })

  const areas = () => wrinkles.furrows!.areas
  const names = () => skin.targets.map(({ name }) => name)

  function deformed(pose: Pose): Float64Array {
    const positions = Float64Array.from(skin.positions)
    for (const { name, offsets } of skin.targets) {
      const weight = pose[name] ?? 0
      if (weight !== 0) for (let i = 0; i < positions.length; i++) positions[i] += weight * offsets[i]
    }
    return positions
  }

  /** Returns a function that measures compression and stretch of each area in a pose, as tension drivers do. */
  function tension(count: number) {
    const mesh = { positions: skin.positions, uvs: skin.uvs, triangles: skin.indices }
    const inputs = areas().flatMap(({ name: area }) =>
      (['compression', 'stretch'] as const).map((measure) => ({ kind: 'tension' as const, area, measure })),
    )
    const samples = areas().map(({ name, weights }) => ({
      area: name,
      triangles: sampleTriangles(mesh, weights, count),
    }))
    const measurement = new TensionMeasurement(inputs, samples, skin.positions)
    return (pose: Pose) => {
      const values = new Float64Array(inputs.length)
      measurement.measure(deformed(pose), values)
      return values
    }
  }

  /** Returns the activations from the blendshape drivers of the automatic wrinkles. */
  function byBlendshapes(pose: Pose): Record<string, number> {
    const weights = Float32Array.from(names(), (name) => pose[name] ?? 0)
    return driven(
      areas().map(({ driver }) => driver),
      names(),
    ).activations({ weights })
  }

  /** Returns the activations from two tension drivers per area: compression deepens the furrows, stretch smooths them. */
  function byTension(values: Float64Array): Record<string, number> {
    const drivers = areas().flatMap(({ name, driver: { curve } }): TensionDriver[] => {
      const [[pulled, smooth], [, rest], [squeezed]] = curve
      return [
        {
          type: 'tension',
          area: name,
          measure: 'compression',
          curve: [
            [0, 0],
            [squeezed, 1 - rest],
          ],
        },
        {
          type: 'tension',
          area: name,
          measure: 'stretch',
          curve: [
            [0, rest],
            [-pulled, smooth],
          ],
        },
      ]
    })
    const plan = planDrivers(drivers)
    const program = new DriverProgram(plan, { tension: measuredSource(drivers.map(() => [])) })
    const state = program.createState()
    state.inputs.tension.set(values)
    program.evaluate(state)
    return Object.fromEntries(plan.areaNames.map((name, i) => [name, state.activations[i]]))
  }

  test('follow the strain of combined poses more closely than tension drivers would', () => {
    const random = seeded(17)
    const [all, few] = [tension(ALL), tension(FEW)]
    const squares = { blendshapes: 0, tension: 0, sampled: 0 }
    for (let n = 0; n < POSES; n++) {
      const pose: Record<string, number> = {}
      for (let k = 2 + Math.floor(5 * random()); k > 0; k--)
        pose[names()[Math.floor(random() * names().length)]] = 0.3 + 0.7 * random()
      const measured = all(pose)
      const found = {
        blendshapes: byBlendshapes(pose),
        tension: byTension(measured),
        sampled: byTension(few(pose)),
      }
      for (const [i, { name, driver }] of areas().entries()) {
        // The curve gives the activation for the fraction of surface area that the skin loses: about compression minus stretch.
        const exact = curveAt(driver.curve, measured[2 * i] - measured[2 * i + 1])
        for (const by of ['blendshapes', 'tension', 'sampled'] as const)
          squares[by] += (found[by][name] - exact) ** 2
      }
    }
    const rms = (by: keyof typeof squares) => Math.sqrt(squares[by] / POSES / areas().length)
    expect(rms('blendshapes')).toBeLessThan(0.03)
    expect(rms('tension')).toBeGreaterThan(2 * rms('blendshapes'))
    expect(rms('sampled')).toBeGreaterThan(2 * rms('blendshapes'))
  })

  test('tilt normals more on squeezed skin, and less on stretched skin, than at rest', () => {
    const all = tension(ALL)
    const rest = tilts({})
    const seen = { squeezed: 0, pulled: 0 }
    const { find } = prepareFace(skin).face
    for (const expression of Object.values(EXPRESSIONS)) {
      const pose = Object.fromEntries(
        [...poseOf(find, expression)].map(([i, weight]) => [names()[i], weight]),
      )
      const measured = all(pose)
      const posed = tilts(pose)
      for (const [i, { name }] of areas().entries()) {
        const lost = measured[2 * i] - measured[2 * i + 1]
        const ratio = posed[i] / rest[i]
        if (lost > 0.03) seen.squeezed++
        if (lost < -0.03) seen.pulled++
        if (lost > 0.03) expect(ratio, name).toBeGreaterThan(1.15)
        if (lost < -0.03) expect(ratio, name).toBeLessThan(0.95)
      }
    }
    expect(seen.squeezed).toBeGreaterThan(3)
    expect(seen.pulled).toBeGreaterThan(3)
  })

  /** Returns, for each area, the mean tangent of the angle by which the fine furrows tilt normals in a pose. */
  function tilts(pose: Pose): number[] {
    const { normal } = wrinkles.layers.at(-1)!
    const activations = byBlendshapes(pose)
    return areas().map(({ name, weights }) => {
      let [sum, count] = [0, 0]
      for (const [texel, weight] of weights.data.entries()) {
        if (weight < 200) continue
        for (const rgb of pixelsUnder(texel, weights, normal)) {
          const detail = {
            normal: reference.unpackNormal(rgb),
            influence: activations[name],
            kind: 'detail' as const,
          }
          const [x, y, z] = reference.mixNormals([0, 0, 1], [detail])
          sum += Math.hypot(x, y) / z
          count++
        }
      }
      return sum / count
    })
  }
})

/** Takes a texel of a smaller image, and yields the colours, 0..1, of the texels that it covers in a larger image. */
function* pixelsUnder(texel: number, { width }: GrayImage, image: GrayImage) {
  const factor = image.width / width
  const [x0, y0] = [(texel % width) * factor, Math.floor(texel / width) * factor]
  for (let y = y0; y < y0 + factor; y++) {
    for (let x = x0; x < x0 + factor; x++) {
      const first = 4 * (y * image.width + x)
      yield [0, 1, 2].map((k) => image.data[first + k] / 255)
    }
  }
}
