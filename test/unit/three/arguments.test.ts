import { parseDrivers, registerDriver } from 'furrow'
import {
  activationTrack,
  addArea,
  addDrivers,
  addMuscles,
  ExpressionPlayer,
  FaceTracker,
  RecomputedNormals,
  removeArea,
  scaleLayer,
  updateArea,
  updateLayer,
  Wrinkles,
} from 'furrow/three'
import { RecomputedNormals as RecomputedOnGpu, Wrinkles as WebGPUWrinkles } from 'furrow/webgpu'
import { describe, expect, it } from 'vitest'
import { expectRefused, face, plain, set } from './refused.ts'

/** Allows a test to pass a value that only plain JavaScript can pass. */
const any = (value: unknown) => value as never

/** Calls, each with the start of its error. */
type Calls = [start: RegExp, run: () => unknown][]

describe('invalid arguments are refused with a message of one line', () => {
  const { mesh, wrinkles } = face()
  const [area] = set().areas
  const { normal } = set().layers[0]
  const player = new ExpressionPlayer(mesh, wrinkles, [
    { name: 'rest', targets: { jawOpen: 0 }, activations: {} },
  ])
  const calls: Calls = [
    [
      /^Wrinkles.mode: invalid mode, got "bogus", allowed: default, paper, composed, off; /,
      () => {
        wrinkles.mode = any('bogus')
      },
    ],
    [
      /^Wrinkles.mode: invalid mode, got "null"/,
      () => {
        wrinkles.mode = any(null)
      },
    ],
    [
      /^Wrinkles.clock: /,
      () => {
        wrinkles.clock = any(null)
      },
    ],
    [/^addArea: invalid area, got "null"/, () => addArea(wrinkles, any(null))],
    [/^addArea: invalid weights of area "b", got "undefined"/, () => addArea(wrinkles, any({ name: 'b' }))],
    [
      /^addArea area "b": invalid image data/,
      () => addArea(wrinkles, { name: 'b', weights: any({ width: 2, height: 2 }) }),
    ],
    [
      /^addArea: invalid activation of area "b", got NaN/,
      () => addArea(wrinkles, { ...area, name: 'b', activation: Number.NaN }),
    ],
    [
      /^addArea: invalid combine of area "b", got "min", allowed: sum or max/,
      () => addArea(wrinkles, { ...area, name: 'b', combine: any('min') }),
    ],
    [/^Wrinkles: unknown area, got null/, () => removeArea(wrinkles, any(null))],
    [/^Wrinkles: unknown area, got null/, () => wrinkles.setActivation(any(null), 1)],
    [/^Wrinkles: invalid activation of "area0", got "1"/, () => wrinkles.setActivation('area0', any('1'))],
    [
      /^Wrinkles: invalid activation of "area0", got "null"/,
      () => wrinkles.setActivation('area0', any(null)),
    ],
    [
      /^Wrinkles.setActivation: no such instance, got 1, allowed: 0 to 0/,
      () => wrinkles.setActivation('area0', 1, 1),
    ],
    [/^Wrinkles.getActivation: no such instance, got -1/, () => wrinkles.getActivation('area0', -1)],
    [/^Wrinkles: invalid activation of "area0"/, () => wrinkles.setRestingActivation('area0', any('x'))],
    [
      /^Wrinkles.getRestingActivation: no such instance, got NaN/,
      () => wrinkles.getRestingActivation('area0', Number.NaN),
    ],
    [
      /^Wrinkles.setActivations: invalid number of values/,
      () => wrinkles.setActivations(any(null), any(null)),
    ],
    [
      /^Wrinkles.setActivations: invalid number of values, got 1, allowed: at least 2, one per name/,
      () => wrinkles.setActivations(['a', 'b'], new Float32Array(1)),
    ],
    [/^Wrinkles.inputs: invalid name of an input/, () => wrinkles.inputs.set(any(null), 1)],
    [/^Wrinkles.inputs: value of "age" is NaN/, () => wrinkles.inputs.set('age', Number.NaN)],
    [/^Wrinkles.inputs: no such instance, got 4/, () => wrinkles.inputs.set('snow', 1, 4)],
    [/^Wrinkles.addMesh: invalid mesh, got "null"/, () => wrinkles.addMesh(any(null))],
    [/^Wrinkles.update: invalid renderer/, () => wrinkles.update(any({}))],
    [/^Wrinkles.onDispose: /, () => wrinkles.onDispose(any(1))],
    [/^Wrinkles: unknown area, got null/, () => wrinkles.createInfluenceMaterial(any(null))],
    [/^Wrinkles: invalid mesh, got "null"/, () => new Wrinkles(any(null), set())],
    [/^Wrinkles: invalid mesh, got "null"/, () => new WebGPUWrinkles(any(null), set())],
    [/^Wrinkles: invalid mesh/, () => new Wrinkles(any({}), set())],
    [/^Wrinkles: invalid wrinkle set, got "null"/, () => new Wrinkles(plain(), any(null))],
    [/^Wrinkles: invalid layer, got "null"/, () => new Wrinkles(plain(), { ...set(), layers: [any(null)] })],
    [
      /^Wrinkles: invalid kind of layer "skin", got "glue"/,
      () => new Wrinkles(plain(), { ...set(), layers: [{ ...set().layers[0], kind: any('glue') }] }),
    ],
    [
      /^Wrinkles: invalid normal of layer "skin"/,
      () => new Wrinkles(plain(), { ...set(), layers: [{ ...set().layers[0], normal: any(null) }] }),
    ],
    [
      /^Wrinkles: invalid areaSize, got NaN, allowed: 2 to 8192/,
      () => new Wrinkles(plain(), set(), { areaSize: Number.NaN }),
    ],
    [/^Wrinkles: invalid fadeBelow, got -1/, () => new Wrinkles(plain(), set(), { fadeBelow: -1 })],
    [/^addDrivers: invalid wrinkles/, () => addDrivers(any(null), [])],
    [/^addDrivers: invalid drivers/, () => addDrivers(wrinkles, any(null))],
    [/^addDrivers: invalid drivers/, () => addDrivers(wrinkles, [any(null)])],
    [
      /^addDrivers: a driver has missing fields.*parseDrivers/,
      () => addDrivers(wrinkles, [{ type: 'morph', area: 'area0' }]),
    ],
    [/^updateArea: invalid wrinkles/, () => updateArea(any(null), 'area0', area.weights)],
    [
      /^Wrinkles: unknown area, got "scar", allowed: "area0", "area1"/,
      () => updateArea(wrinkles, 'scar', area.weights),
    ],
    [
      /^updateArea: invalid weights of area "area0", got "null"/,
      () => updateArea(wrinkles, 'area0', any(null)),
    ],
    [
      /^updateArea area "area0": wrong length of gray image data, got "3 bytes", allowed: 4 bytes/,
      () => updateArea(wrinkles, 'area0', { width: 2, height: 2, data: new Uint8Array(3) }),
    ],
    [/^updateLayer: invalid wrinkles/, () => updateLayer(any(null), 'skin', { normal })],
    [
      /^updateLayer: unknown layer, got "scar", allowed: "skin"; /,
      () => updateLayer(wrinkles, 'scar', { normal }),
    ],
    [
      /^updateLayer: invalid images, got "null", allowed: normal, baseColor, roughness, occlusion/,
      () => updateLayer(wrinkles, 'skin', any(null)),
    ],
    [
      /^updateLayer: invalid images, got "normal, height", allowed: normal, /,
      () => updateLayer(wrinkles, 'skin', any({ normal, height: normal })),
    ],
    [
      /^updateLayer layer "skin" roughness: the layer has no such map, allowed: normal; create /,
      () => updateLayer(wrinkles, 'skin', { normal, roughness: area.weights }),
    ],
    [
      /^updateLayer layer "skin" normal: invalid image, got "null"/,
      () => updateLayer(wrinkles, 'skin', any({ normal: null })),
    ],
    [
      /^updateLayer layer "skin" normal: invalid size, got "1 x 1", allowed: 16 x 16; /,
      () => updateLayer(wrinkles, 'skin', { normal: { width: 1, height: 1, data: new Uint8Array(4) } }),
    ],
    ...[
      { x0: -1, y0: 0, x1: 4, y1: 4 },
      { x0: 0, y0: 0, x1: 17, y1: 4 },
      { x0: 5, y0: 0, x1: 4, y1: 4 },
      { x0: 0, y0: 0.5, x1: 4, y1: 4 },
      { x0: 0 },
      7,
    ].map((region): Calls[number] => [
      /^updateLayer layer "skin" normal: invalid region, got .*, allowed: 0 <= x0 <= x1 <= 16, 0 <= y0 <= y1 <= 16, in whole texels/,
      () => updateLayer(wrinkles, 'skin', { normal }, any(region)),
    ]),
    [/^scaleLayer: invalid wrinkles/, () => scaleLayer(any(null), 'skin', { normalScale: 2 })],
    [
      /^scaleLayer: unknown layer, got "scar", allowed: "skin"; /,
      () => scaleLayer(wrinkles, 'scar', { normalScale: 2 }),
    ],
    [/^scaleLayer: invalid scale, got "null"/, () => scaleLayer(wrinkles, 'skin', any(null))],
    [
      /^scaleLayer: invalid normalScale of layer "skin", got NaN/,
      () => scaleLayer(wrinkles, 'skin', { normalScale: Number.NaN }),
    ],
    [/^addMuscles: invalid mesh/, () => addMuscles(any(null), [])],
    [/^addMuscles: invalid muscles/, () => addMuscles(mesh, any(null))],
    [/^parseDrivers: /, () => parseDrivers(1, [])],
    [/^registerDriver: invalid definition/, () => registerDriver(any(null))],
    [/^registerDriver: invalid definition/, () => registerDriver(any({ type: 'x' }))],
    [/^ExpressionPlayer: invalid face/, () => new ExpressionPlayer(any(null), wrinkles)],
    [/^ExpressionPlayer: invalid wrinkles/, () => new ExpressionPlayer(mesh, any(null))],
    [/^ExpressionMix: invalid expression/, () => new ExpressionPlayer(mesh, wrinkles, [any({ name: 'a' })])],
    [/^ExpressionMix: invalid expression/, () => player.play(any(null))],
    [/^ExpressionMix: duration/, () => player.play('rest', Number.NaN)],
    [
      /^ExpressionMix: invalid easing, got "bounce", allowed: linear, /,
      () => player.play('rest', 1, any('bounce')),
    ],
    [
      /^ExpressionMix: invalid delta/,
      () => {
        player.play('rest', 1)
        player.update(Number.NaN)
      },
    ],
    [/^FaceTracker: invalid face/, () => new FaceTracker(any(null)).set({ jawOpen: 1 })],
    [/^FaceTracker: invalid scores/, () => new FaceTracker(mesh).set(any(null))],
    [/^FaceTracker: invalid score/, () => new FaceTracker(mesh).set([any(null)])],
    [/^FaceTracker: invalid seconds/, () => new FaceTracker(mesh).set({ jawOpen: 0 }, Number.NaN)],
    [/^FaceTracker: invalid kind/, () => new FaceTracker(mesh).record(any('smile'))],
    [/^FaceTracker: invalid seconds/, () => new FaceTracker(mesh).record('neutral', 0)],
    [
      /^FaceTracker: invalid mirror/,
      () => {
        new FaceTracker(mesh).mirror = any(1)
      },
    ],
    [/^RecomputedNormals: invalid mesh/, () => new RecomputedNormals(any(null))],
    [/^RecomputedNormals: invalid mesh/, () => new RecomputedOnGpu(any(null))],
    [
      /^RecomputedNormals of furrow\/webgpu: invalid renderer, got "Object", allowed: WebGPURenderer/,
      () => new RecomputedOnGpu(mesh).update(any({})),
    ],
    [/^activationTrack: invalid mesh/, () => activationTrack(any(null), 'area0', [0], [1])],
    [
      /^activationTrack: invalid number of values, got 1, allowed: one for each of 2 times/,
      () => activationTrack(mesh, 'area0', [0, 1], [1]),
    ],
  ]

  it.each(calls)('%s', (start, run) => {
    expectRefused(run, start)
    expect(wrinkles.mode).toBe('default')
    expect(wrinkles.areaNames).toEqual(['area0', 'area1'])
    expect(wrinkles.getActivation('area0')).toBe(0)
    expect(mesh.morphTargetInfluences).toEqual([0])
  })

  it('clamps activations that are set together, including NaN', () => {
    const { wrinkles } = face()
    wrinkles.setActivations(['area0', 'area1'], Float32Array.of(Number.NaN, 7))
    expect([wrinkles.getActivation('area0'), wrinkles.getActivation('area1')]).toEqual([0, 1])
  })
})
