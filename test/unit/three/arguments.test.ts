import { parseDrivers, registerDriver } from 'furrow'
import {
  activationTrack,
  addArea,
  addDrivers,
  addMuscles,
  ExpressionPlayer,
  FaceScores,
  RecomputedNormals,
  removeArea,
  scaleLayer,
  updateArea,
  updateLayer,
  Wrinkles,
} from 'furrow/three'
import { RecomputedNormals as RecomputedOnGpu } from 'furrow/webgpu'
import { describe, expect, it } from 'vitest'
import { expectRefused, face, plain, set } from './refused.ts'

/** What plain JavaScript may pass. */
const any = (value: unknown) => value as never

/** Calls, and what their errors begin with. */
type Calls = [call: string, start: RegExp, run: () => unknown][]

describe('wrong arguments', () => {
  const { mesh, wrinkles } = face()
  const [area] = set().areas
  const { normal } = set().layers[0]
  const player = new ExpressionPlayer(mesh, wrinkles, [
    { name: 'rest', targets: { jawOpen: 0 }, activations: {} },
  ])
  const calls: Calls = [
    [
      'mode = bogus',
      /^Wrinkles.mode: unknown mode, got "bogus", allowed: default, paper, composed, off; /,
      () => {
        wrinkles.mode = any('bogus')
      },
    ],
    [
      'mode = null',
      /^Wrinkles.mode: unknown mode, got "null"/,
      () => {
        wrinkles.mode = any(null)
      },
    ],
    [
      'clock = null',
      /^Wrinkles.clock: /,
      () => {
        wrinkles.clock = any(null)
      },
    ],
    ['addArea(null)', /^addArea: an area, got "null"/, () => addArea(wrinkles, any(null))],
    [
      'addArea without weights',
      /^addArea: weights of area "b", got "undefined"/,
      () => addArea(wrinkles, any({ name: 'b' })),
    ],
    [
      'addArea without data',
      /^addArea area "b": data of an image/,
      () => addArea(wrinkles, { name: 'b', weights: any({ width: 2, height: 2 }) }),
    ],
    [
      'addArea with NaN',
      /^addArea: activation of area "b", got NaN/,
      () => addArea(wrinkles, { ...area, name: 'b', activation: Number.NaN }),
    ],
    [
      'addArea with a rule of its own',
      /^addArea: combine of area "b", got "min", allowed: sum or max/,
      () => addArea(wrinkles, { ...area, name: 'b', combine: any('min') }),
    ],
    ['removeArea(null)', /^Wrinkles: unknown area, got null/, () => removeArea(wrinkles, any(null))],
    [
      'setActivation of no area',
      /^Wrinkles: unknown area, got null/,
      () => wrinkles.setActivation(any(null), 1),
    ],
    [
      'setActivation to text',
      /^Wrinkles: activation of "area0", got "1"/,
      () => wrinkles.setActivation('area0', any('1')),
    ],
    [
      'setActivation to null',
      /^Wrinkles: activation of "area0", got "null"/,
      () => wrinkles.setActivation('area0', any(null)),
    ],
    [
      'setActivation of no instance',
      /^Wrinkles.setActivation: no such instance, got 1, allowed: 0 to 0/,
      () => wrinkles.setActivation('area0', 1, 1),
    ],
    [
      'getActivation of no instance',
      /^Wrinkles.getActivation: no such instance, got -1/,
      () => wrinkles.getActivation('area0', -1),
    ],
    [
      'setRestingActivation to text',
      /^Wrinkles: activation of "area0"/,
      () => wrinkles.setRestingActivation('area0', any('x')),
    ],
    [
      'getRestingActivation of no instance',
      /^Wrinkles.getRestingActivation: no such instance, got NaN/,
      () => wrinkles.getRestingActivation('area0', Number.NaN),
    ],
    [
      'setActivations(null)',
      /^Wrinkles.setActivations: values/,
      () => wrinkles.setActivations(any(null), any(null)),
    ],
    [
      'setActivations with too few',
      /^Wrinkles.setActivations: values, got 1, allowed: one for each of 2 names/,
      () => wrinkles.setActivations(['a', 'b'], new Float32Array(1)),
    ],
    ['inputs.set(null)', /^Wrinkles.inputs: name of an input/, () => wrinkles.inputs.set(any(null), 1)],
    [
      'inputs.set to NaN',
      /^Wrinkles.inputs: value of "age" is NaN/,
      () => wrinkles.inputs.set('age', Number.NaN),
    ],
    [
      'inputs.set of no instance',
      /^Wrinkles.inputs: no such instance, got 4/,
      () => wrinkles.inputs.set('snow', 1, 4),
    ],
    ['addMesh(null)', /^Wrinkles.addMesh: a mesh, got "null"/, () => wrinkles.addMesh(any(null))],
    ['update({})', /^Wrinkles.update: a renderer/, () => wrinkles.update(any({}))],
    ['onDispose(1)', /^Wrinkles.onDispose: /, () => wrinkles.onDispose(any(1))],
    [
      'createInfluenceMaterial(null)',
      /^Wrinkles: unknown area, got null/,
      () => wrinkles.createInfluenceMaterial(any(null)),
    ],
    ['new Wrinkles(null)', /^Wrinkles: a mesh, got "null"/, () => new Wrinkles(any(null), set())],
    ['new Wrinkles without a mesh', /^Wrinkles: a mesh/, () => new Wrinkles(any({}), set())],
    [
      'new Wrinkles without a set',
      /^Wrinkles: a wrinkle set, got "null"/,
      () => new Wrinkles(plain(), any(null)),
    ],
    [
      'new Wrinkles with a layer of null',
      /^Wrinkles: a layer, got "null"/,
      () => new Wrinkles(plain(), { ...set(), layers: [any(null)] }),
    ],
    [
      'new Wrinkles with an unknown kind',
      /^Wrinkles: kind of layer "skin", got "glue"/,
      () => new Wrinkles(plain(), { ...set(), layers: [{ ...set().layers[0], kind: any('glue') }] }),
    ],
    [
      'new Wrinkles without normals',
      /^Wrinkles: normals of layer "skin"/,
      () => new Wrinkles(plain(), { ...set(), layers: [{ ...set().layers[0], normal: any(null) }] }),
    ],
    [
      'areaSize NaN',
      /^Wrinkles: areaSize, got NaN, allowed: 2 to 8192/,
      () => new Wrinkles(plain(), set(), { areaSize: Number.NaN }),
    ],
    ['fadeBelow -1', /^Wrinkles: fadeBelow, got -1/, () => new Wrinkles(plain(), set(), { fadeBelow: -1 })],
    ['addDrivers(null)', /^addDrivers: wrinkles/, () => addDrivers(any(null), [])],
    ['addDrivers of null', /^addDrivers: drivers/, () => addDrivers(wrinkles, any(null))],
    ['addDrivers of a list of null', /^addDrivers: drivers/, () => addDrivers(wrinkles, [any(null)])],
    [
      'addDrivers of half a driver',
      /^addDrivers: a driver lacks fields.*parseDrivers/,
      () => addDrivers(wrinkles, [{ type: 'morph', area: 'area0' }]),
    ],
    ['updateArea(null)', /^updateArea: wrinkles/, () => updateArea(any(null), 'area0', area.weights)],
    [
      'updateArea of an unknown area',
      /^Wrinkles: unknown area, got "scar", allowed: "area0", "area1"/,
      () => updateArea(wrinkles, 'scar', area.weights),
    ],
    [
      'updateArea without weights',
      /^updateArea: weights of area "area0", got "null"/,
      () => updateArea(wrinkles, 'area0', any(null)),
    ],
    [
      'updateArea with too few bytes',
      /^updateArea area "area0": gray image data of the wrong length, got "3 bytes", allowed: 4 bytes/,
      () => updateArea(wrinkles, 'area0', { width: 2, height: 2, data: new Uint8Array(3) }),
    ],
    ['updateLayer(null)', /^updateLayer: wrinkles/, () => updateLayer(any(null), 'skin', { normal })],
    [
      'updateLayer of an unknown layer',
      /^updateLayer: unknown layer, got "scar", allowed: "skin"; /,
      () => updateLayer(wrinkles, 'scar', { normal }),
    ],
    [
      'updateLayer of null',
      /^updateLayer: images, got "null", allowed: normal, baseColor, roughness, occlusion/,
      () => updateLayer(wrinkles, 'skin', any(null)),
    ],
    [
      'updateLayer of unknown maps',
      /^updateLayer: images, got "normal, height", allowed: normal, /,
      () => updateLayer(wrinkles, 'skin', any({ normal, height: normal })),
    ],
    [
      'updateLayer of a map that the layer lacks',
      /^updateLayer layer "skin" roughness: the layer has no such map, allowed: normal; create /,
      () => updateLayer(wrinkles, 'skin', { normal, roughness: area.weights }),
    ],
    [
      'updateLayer of null as a map',
      /^updateLayer layer "skin" normal: image, got "null"/,
      () => updateLayer(wrinkles, 'skin', any({ normal: null })),
    ],
    [
      'updateLayer with an image of another size',
      /^updateLayer layer "skin" normal: size, got "1 x 1", allowed: 16 x 16, as before/,
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
      `updateLayer in the region ${JSON.stringify(region)}`,
      /^updateLayer layer "skin" normal: region, got .*, allowed: 0 <= x0 <= x1 <= 16, 0 <= y0 <= y1 <= 16, in whole texels/,
      () => updateLayer(wrinkles, 'skin', { normal }, any(region)),
    ]),
    ['scaleLayer(null)', /^scaleLayer: wrinkles/, () => scaleLayer(any(null), 'skin', { normalScale: 2 })],
    [
      'scaleLayer of an unknown layer',
      /^scaleLayer: unknown layer, got "scar", allowed: "skin"; /,
      () => scaleLayer(wrinkles, 'scar', { normalScale: 2 }),
    ],
    ['scaleLayer by null', /^scaleLayer: scale, got "null"/, () => scaleLayer(wrinkles, 'skin', any(null))],
    [
      'scaleLayer by NaN',
      /^scaleLayer: normalScale of layer "skin", got NaN/,
      () => scaleLayer(wrinkles, 'skin', { normalScale: Number.NaN }),
    ],
    ['addMuscles(null)', /^addMuscles: a mesh/, () => addMuscles(any(null), [])],
    ['addMuscles of null', /^addMuscles: muscles/, () => addMuscles(mesh, any(null))],
    ['parseDrivers(1)', /^parseDrivers: /, () => parseDrivers(1, [])],
    ['registerDriver(null)', /^registerDriver: a definition/, () => registerDriver(any(null))],
    [
      'registerDriver without read',
      /^registerDriver: a definition/,
      () => registerDriver(any({ type: 'x' })),
    ],
    [
      'new ExpressionPlayer(null)',
      /^ExpressionPlayer: a face/,
      () => new ExpressionPlayer(any(null), wrinkles),
    ],
    [
      'new ExpressionPlayer without wrinkles',
      /^ExpressionPlayer: the wrinkles/,
      () => new ExpressionPlayer(mesh, any(null)),
    ],
    [
      'new ExpressionPlayer with malformed expressions',
      /^ExpressionMix: an expression/,
      () => new ExpressionPlayer(mesh, wrinkles, [any({ name: 'a' })]),
    ],
    ['play(null)', /^ExpressionMix: an expression/, () => player.play(any(null))],
    ['play for NaN seconds', /^ExpressionMix: time/, () => player.play('rest', Number.NaN)],
    [
      'play with an unknown easing',
      /^ExpressionMix: easing, got "bounce", allowed: linear, /,
      () => player.play('rest', 1, any('bounce')),
    ],
    [
      'update by NaN',
      /^ExpressionMix: seconds/,
      () => {
        player.play('rest', 1)
        player.update(Number.NaN)
      },
    ],
    [
      'FaceScores of no face',
      /^FaceScores: a face/,
      () => new FaceScores(any(null)).set([{ categoryName: 'jawOpen', score: 1 }]),
    ],
    ['FaceScores.set(null)', /^FaceScores: scores/, () => new FaceScores(mesh).set(any(null))],
    ['FaceScores.set of null', /^FaceScores: a score/, () => new FaceScores(mesh).set([any(null)])],
    ['new RecomputedNormals(null)', /^RecomputedNormals: a mesh/, () => new RecomputedNormals(any(null))],
    [
      'new RecomputedNormals(null) on the GPU',
      /^RecomputedNormals: a mesh/,
      () => new RecomputedOnGpu(any(null)),
    ],
    [
      'RecomputedNormals on the GPU by another renderer',
      /^RecomputedNormals of furrow\/webgpu: a renderer, got "Object", allowed: WebGPURenderer/,
      () => new RecomputedOnGpu(mesh).update(any({})),
    ],
    [
      'activationTrack(null)',
      /^activationTrack: a mesh/,
      () => activationTrack(any(null), 'area0', [0], [1]),
    ],
    [
      'activationTrack with too few values',
      /^activationTrack: values, got 1, allowed: one for each of 2 times/,
      () => activationTrack(mesh, 'area0', [0, 1], [1]),
    ],
  ]

  it.each(calls)('%s is refused in one line', (_, start, run) => {
    expectRefused(run, start)
    expect(wrinkles.mode).toBe('default')
    expect(wrinkles.areaNames).toEqual(['area0', 'area1'])
    expect(wrinkles.getActivation('area0')).toBe(0)
    expect(mesh.morphTargetInfluences).toEqual([0])
  })

  it('clamps several activations at once, NaN included', () => {
    const { wrinkles } = face()
    wrinkles.setActivations(['area0', 'area1'], Float32Array.of(Number.NaN, 7))
    expect([wrinkles.getActivation('area0'), wrinkles.getActivation('area1')]).toEqual([0, 1])
  })
})
