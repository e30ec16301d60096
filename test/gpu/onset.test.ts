import { MToonMaterial } from '@pixiv/three-vrm-materials-mtoon'
import { MToonNodeMaterial } from '@pixiv/three-vrm-materials-mtoon/nodes'
import type { Area, GrayImage, Layer, WrinkleSet } from 'furrow'
import { reference } from 'furrow/internal'
import { scaleLayer, updateLayer, type WrinklesOptions } from 'furrow/three'
import {
  Color,
  DirectionalLight,
  InstancedMesh,
  type Material,
  Matrix4,
  type Mesh,
  MeshLambertMaterial,
  MeshStandardMaterial,
  Scene,
} from 'three'
import { describe, expect, it } from 'vitest'
import { layer, randomAreas, randomNormals } from '../cases.ts'
import { seeded } from '../random.ts'
import { absorbed } from './absorbed.ts'
import { largestDifference } from './difference.ts'
import { casesOn, harnessOn, RENDERERS, square, squareCamera } from './harness.ts'
import { type Kind, MAP, randomLayer } from './layer-values.ts'
import { ball, heightSet, sceneOf, sideCamera } from './relief/ball.ts'
import { differing, FEW } from './relief/differing.ts'

const AREAS = 4

/** Layers with and without an onset map, in every combination with the maps that share its texture. */
const LAYERS = {
  all: ['occlusion', 'blood'],
  alone: [],
  pair: ['blood'],
  none: ['blood'],
} as const satisfies Record<string, Kind[]>
const NAMES = Object.keys(LAYERS)

/** Bytes up to 200, because a larger onset magnifies the rounding errors of the influence map beyond the tolerance. */
const onsetMap = (random: () => number): GrayImage => ({
  width: MAP,
  height: MAP,
  data: Uint8Array.from({ length: MAP * MAP }, () => random() * 200),
})

const uniform = (value: number, side = 1): GrayImage => ({
  width: side,
  height: side,
  data: new Uint8Array(side * side).fill(value),
})

describe.each(RENDERERS)('onset maps on %s', (name) => {
  const cases = casesOn(name)
  const harness = harnessOn(name)
  const light = () => {
    const light = new DirectionalLight(0xffffff, 3)
    light.position.set(0.3, 0.2, 1)
    return light
  }

  /** Renders a square of one colour with wrinkles. */
  function faceOf(layers: Layer[], areas: Area[], color = new Color(0.71, 0.43, 0.337)) {
    const mesh = square(new MeshLambertMaterial({ color }))
    const wrinkles = new harness.Wrinkles(mesh, { layers, areas }, { areaSize: MAP })
    const scene = new Scene().add(mesh, light())
    return {
      wrinkles,
      picture: () => harness.render(scene, squareCamera(), MAP),
      activate: (values: readonly number[]) => {
        for (const [i, value] of values.entries()) wrinkles.setActivation(areas[i].name, value)
      },
      dispose: () => {
        wrinkles.dispose()
        mesh.geometry.dispose()
      },
    }
  }

  it(`delay influence as in the reference in ${cases} random cases`, async () => {
    const random = seeded(41)
    let release = () => {}
    let largestEffect = 0
    for (let i = 0; i < cases; i++) {
      const layers = Object.entries(LAYERS).map(([layer, kinds]) => ({
        ...randomLayer(random, layer, kinds),
        bloodAmplitude: random() * 2,
        ...(layer !== 'none' && { onset: onsetMap(random), onsetStrength: random() < 0.5 ? 1 : random() }),
      }))
      const areas = randomAreas(random, AREAS, MAP).map((area, k) => ({ ...area, layer: NAMES[k % 4] }))
      const activations = areas.map(() => (random() < 0.2 ? 0 : random()))
      const color = new Color(random(), random(), random()).multiplyScalar(0.5)
      const face = faceOf(layers, areas, color)
      const plain = await face.picture()
      face.activate(activations)
      const shown = await face.picture()
      const exact = absorbed(plain, layers, areas, activations)
      expect(largestDifference(shown, exact)).toBeLessThanOrEqual(2 / 255)
      const undelayed = layers.map(({ onset: _, ...layer }) => layer)
      const without = absorbed(plain, undelayed, areas, activations)
      largestEffect = Math.max(largestEffect, largestDifference(without, exact))
      release()
      release = face.dispose
    }
    expect(largestEffect).toBeGreaterThan(32 / 255)
    release()
  })

  it('change no bit where influence is 1, nor with strength 0', async () => {
    const random = seeded(42)
    const kinds = ['baseColor', 'occlusion', 'blood'] as const
    const own = { ...randomLayer(random, 'skin', kinds), normal: randomNormals(random, MAP), normalScale: 1 }
    const areas: Area[] = [{ name: 'all', weights: uniform(255, MAP) }]
    const without = faceOf([own], areas)
    const delayed = faceOf([{ ...own, onset: onsetMap(random) }], areas)
    for (const face of [without, delayed]) face.activate([1])
    expect(await delayed.picture()).toEqual(await without.picture())
    for (const face of [without, delayed]) face.activate([0.4])
    const [expected, shown] = [await without.picture(), await delayed.picture()]
    expect(largestDifference(shown, expected)).toBeGreaterThan(16 / 255)
    scaleLayer(delayed.wrinkles, 'skin', { onsetStrength: 0 })
    expect(await delayed.picture()).toEqual(expected)
    for (const { dispose } of [without, delayed]) dispose()
  })

  it('can be replaced by updateLayer', async () => {
    const random = seeded(43)
    const own = randomLayer(random, 'skin', ['occlusion', 'blood'])
    const areas = randomAreas(random, 1, MAP)
    const [first, second] = [onsetMap(random), onsetMap(random)]
    const face = faceOf([{ ...own, onset: first }], areas)
    const other = faceOf([{ ...own, onset: second }], areas)
    for (const { activate } of [face, other]) activate([0.7])
    const expected = await other.picture()
    expect(largestDifference(await face.picture(), expected)).toBeGreaterThan(16 / 255)
    updateLayer(face.wrinkles, 'skin', { onset: second })
    expect(largestDifference(await face.picture(), expected)).toBeLessThanOrEqual(1 / 255)
    for (const { dispose } of [face, other]) dispose()
  })

  /** Onset and activation of a face. An area with weight 1 then looks as if it had no onset map and the activation `DELAYED`. */
  const ONSET = 128
  const ACTIVATION = 0.55
  const DELAYED = reference.onsetInfluence(ACTIVATION, ONSET / 255)

  const toon = () => {
    const Toon = name === 'webgl' ? MToonMaterial : MToonNodeMaterial
    return new Toon({ color: new Color(0.9, 0.7, 0.6) } as never) as unknown as Material
  }
  it.each<[string, WrinklesOptions, number, (() => Material)?]>([
    ['in the default mode', {}, 1],
    ['in the composed mode', { mode: 'composed' }, 1],
    ['with tiled texture coordinates', {}, 2],
    ['in MToon', {}, 1, toon],
  ])('delay normals %s', async (_, options, scale, create) => {
    const own = layer('skin', 'detail', randomNormals(seeded(44), MAP))
    const areas: Area[] = [{ name: 'all', weights: uniform(255, 2) }]
    const show = async (layers: Layer[], activation: number) => {
      const mesh = square(create?.() ?? new MeshStandardMaterial({ roughness: 0.6 }), scale)
      const wrinkles = new harness.Wrinkles(mesh, { layers, areas }, options)
      wrinkles.setActivation('all', activation)
      const picture = await harness.render(new Scene().add(mesh, light()), squareCamera(), 2 * MAP)
      wrinkles.dispose()
      return picture
    }
    const expected = await show([own], DELAYED)
    const delayed = [{ ...own, onset: uniform(ONSET, 4) }]
    expect(largestDifference(await show(delayed, ACTIVATION), expected)).toBeLessThanOrEqual(2 / 255)
    expect(largestDifference(await show([own], ACTIVATION), expected)).toBeGreaterThan(4 / 255)
  })

  it('delay each instance of a crowd by its own influence', async () => {
    const own = layer('skin', 'detail', randomNormals(seeded(45), MAP))
    const areas: Area[] = [{ name: 'all', weights: uniform(255, 2) }]
    const show = async (layers: Layer[], activations: readonly number[]) => {
      const { geometry, material } = square(new MeshStandardMaterial({ roughness: 0.6 }))
      const mesh = new InstancedMesh(geometry, material, 2)
      for (const i of [0, 1])
        mesh.setMatrixAt(i, new Matrix4().makeScale(0.5, 1, 1).setPosition(i - 0.5, 0, 0))
      const wrinkles = new harness.Wrinkles(mesh as Mesh, { layers, areas })
      for (const i of [0, 1]) wrinkles.setActivation('all', activations[i], i)
      const picture = await harness.render(new Scene().add(mesh, light()), squareCamera(), 2 * MAP)
      wrinkles.dispose()
      return picture
    }
    const expected = await show([own], [DELAYED, 1])
    const delayed = await show([{ ...own, onset: uniform(ONSET, 4) }], [ACTIVATION, 1])
    expect(largestDifference(delayed, expected)).toBeLessThanOrEqual(2 / 255)
  })

  it('delay heights', async () => {
    const show = async (activation: number, onset?: GrayImage) => {
      const mesh = ball()
      const { layers, areas } = heightSet()
      const set: WrinkleSet = { layers: [{ ...layers[0], ...(onset && { onset }) }], areas }
      const wrinkles = new harness.Wrinkles(mesh, set, { relief: 'on' })
      wrinkles.setActivation('all', activation)
      await wrinkles.reliefReady()
      const picture = await harness.renderBytes(sceneOf(mesh), sideCamera(0.15), 256)
      wrinkles.dispose()
      return picture
    }
    const expected = await show(DELAYED)
    expect(differing(await show(ACTIVATION, uniform(ONSET, 8)), expected)).toBeLessThan(FEW)
    expect(differing(await show(ACTIVATION), expected)).toBeGreaterThan(100)
  })
})
