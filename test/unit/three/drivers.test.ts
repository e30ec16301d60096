import type { WrinkleDriver } from 'furrow'
import { addDrivers, ExpressionPlayer, removeArea, setDrivers, Wrinkles } from 'furrow/three'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { link, morph, ramp, STRAIGHT } from '../../drivers.ts'
import { drivenFace } from './driven-face.ts'

afterEach(() => vi.restoreAllMocks())

describe('addDrivers', () => {
  it('adds the activations by blendshapes, joints, tension and age to the resting activations', () => {
    const { mesh, head, wrinkles, activations } = drivenFace([
      morph('brow', [link('browDownLeft', 0.5)]),
      morph('nose', 'jawOpen'),
      {
        type: 'bone',
        area: 'neck',
        joints: ['chest', 'head'],
        measure: 'angle',
        axis: [1, 0, 0],
        curve: STRAIGHT,
      },
      { type: 'tension', area: 'brow', measure: 'compression', curve: STRAIGHT },
      { type: 'age', area: 'nose', curve: ramp(20, 70, 0.5) },
    ])
    expect(activations()).toEqual([0, 0.2, 0])
    mesh.morphTargetInfluences![0] = 0.6
    mesh.morphTargetInfluences![1] = 0.1
    head.rotation.x = 0.4
    wrinkles.inputs.set('age', 50)
    // The square is 30% narrower. Tension gives 0.3, and the blendshape 0.5 * 0.6.
    expect(activations()).toEqual([0.6, 0.6, 0.4])
    // The activations stay when the whole mesh moves.
    mesh.position.set(1, 2, 3)
    mesh.rotation.y = 2
    expect(activations()).toEqual([0.6, 0.6, 0.4])
    wrinkles.setRestingActivation('neck', 0.25)
    expect(activations()).toEqual([0.6, 0.6, 0.65])
    expect(wrinkles.getRestingActivation('neck')).toBe(0.25)
  })

  it.each([
    ['names are numbers out of order', ['7', '3', 'jawOpen'], '3', 1],
    ['several blendshapes have one name', ['jawOpen', 'jawOpen', 'browDownLeft'], 'browDownLeft', 2],
    ['another has the same name, by its index', ['jawOpen', 'jawOpen', 'browDownLeft'], '0', 0],
  ])('reads the weight of the right blendshape if %s', (_, targets, name, index) => {
    const { mesh, activations } = drivenFace([morph('brow', name)], targets)
    expect(activations()[0]).toBe(0)
    mesh.morphTargetInfluences![index] = 0.5
    expect(activations()[0]).toBe(0.5)
  })

  it('keeps existing drivers, but setDrivers replaces them', () => {
    const [brow, nose, neck] = [
      morph('brow', 'browDownLeft'),
      morph('nose', 'jawOpen'),
      morph('neck', 'jawOpen'),
    ]
    const { mesh, wrinkles, activations } = drivenFace([brow])
    mesh.morphTargetInfluences!.fill(0.5)
    addDrivers(wrinkles, [nose])
    expect(wrinkles.drivers).toEqual([brow, nose])
    expect(activations()).toEqual([0.5, 0.7, 0])
    setDrivers(wrinkles, [neck])
    expect(wrinkles.drivers).toEqual([neck])
    // An area without drivers keeps its last activation.
    expect(activations()).toEqual([0.5, 0.7, 0.5])
    setDrivers(wrinkles, [])
    expect(wrinkles.drivers).toEqual([])
  })

  it('keeps existing drivers unchanged if a new one is malformed', () => {
    const brow = morph('brow', 'browDownLeft')
    const { mesh, wrinkles, activations } = drivenFace([brow])
    expect(() => addDrivers(wrinkles, [{ type: 'morph', area: 'nose' }])).toThrow(
      /got "morph"; pass the drivers through/,
    )
    expect(() => setDrivers(wrinkles, [{ type: 'morph', area: 'nose' }])).toThrow(
      /^setDrivers: a driver has missing fields/,
    )
    expect(wrinkles.drivers).toEqual([brow])
    mesh.morphTargetInfluences!.fill(0.5)
    expect(activations()).toEqual([0.5, 0.2, 0])
  })

  it('are shared by wrinkles of another mesh, which can get others', () => {
    const { mesh, wrinkles } = drivenFace([morph('brow', 'browDownLeft')])
    const copy = mesh.clone()
    copy.material = mesh.material.clone()
    const own = new Wrinkles(copy, wrinkles)
    expect(own.drivers).toEqual(wrinkles.drivers)
    addDrivers(own, [morph('neck', 'jawOpen')])
    expect(wrinkles.drivers).toHaveLength(1)
    copy.morphTargetInfluences!.fill(0.5)
    own.update()
    expect([own.getActivation('brow'), own.getActivation('neck')]).toEqual([0.5, 0.5])
    wrinkles.update()
    expect(wrinkles.getActivation('brow')).toBe(0)
  })

  it('measures a joint driver from the bind pose if both its joints are bones, whatever other drivers use', () => {
    const rotation = (area: string, from: string): WrinkleDriver => ({
      type: 'bone',
      area,
      joints: [from, 'head'],
      measure: 'angle',
      curve: STRAIGHT,
    })
    // The mesh is not a bone, so the driver that uses it measures from the current pose.
    const { mesh, head, wrinkles, activations } = drivenFace([])
    mesh.name = 'body'
    head.rotation.x = 0.4
    mesh.updateMatrixWorld(true)
    addDrivers(wrinkles, [rotation('brow', 'chest'), rotation('neck', 'body')])
    expect(activations()).toEqual([0.4, 0.2, 0])
    head.rotation.x = 0.7
    expect(activations()).toEqual([0.7, 0.2, 0.3])
  })

  it('does not change areas without a driver', () => {
    const { wrinkles, activations } = drivenFace([morph('brow', 'browDownLeft')])
    wrinkles.setActivation('neck', 0.9)
    wrinkles.setActivation('brow', 0.9)
    expect(activations()).toEqual([0, 0.2, 0.9])
    wrinkles.driven = false
    wrinkles.setActivation('brow', 0.9)
    expect(activations()).toEqual([0.9, 0.2, 0.9])
  })

  it('in areas without other drivers, age adds to the activations that are set, and delays follow them', () => {
    const { wrinkles, activations } = drivenFace([
      { type: 'age', area: 'brow', curve: ramp(20, 70, 0.5) },
      { type: 'time', area: 'neck', attack: 0.1, release: 0.1 },
    ])
    let milliseconds = 0
    wrinkles.clock = { now: () => milliseconds }
    wrinkles.inputs.set('age', 70)
    wrinkles.setActivation('brow', 0.3)
    for (let i = 0; i < 3; i++) expect(activations()).toEqual([0.8, 0.2, 0])
    wrinkles.setActivation('neck', 1)
    milliseconds += 100
    expect(activations()[2]).toBeCloseTo(1 - Math.exp(-1), 3)
    expect([wrinkles.isDriven('brow'), wrinkles.isDriven('neck')]).toEqual([false, false])
  })

  it('repeated presets on an aging face do not drift', () => {
    const { mesh, wrinkles, activations } = drivenFace([
      { type: 'age', area: 'brow', curve: ramp(20, 70, 0.5) },
    ])
    wrinkles.inputs.set('age', 70)
    const player = new ExpressionPlayer(mesh, wrinkles, [
      { name: 'rest', targets: {}, activations: {} },
      { name: 'frown', targets: { jawOpen: 1 }, activations: { brow: 0.4 } },
    ])
    for (let i = 0; i < 3; i++) {
      player.play('frown', 0.1)
      player.update(1)
      expect(activations()[0]).toBe(0.9)
      player.play('rest', 0.1)
      player.update(1)
      expect(activations()[0]).toBe(0.5)
    }
  })

  it('a preset activates areas like the blendshapes that it sets', () => {
    const drivers = [morph('brow', [link('browDownLeft', 0.5)]), morph('neck', 'jawOpen')]
    const [played, set] = [drivenFace(drivers), drivenFace(drivers)]
    new ExpressionPlayer(played.mesh, played.wrinkles, [
      { name: 'frown', targets: { browDownLeft: 0.7, jawOpen: 0.2 }, activations: { brow: 1, neck: 1 } },
    ]).play('frown', 0)
    set.mesh.morphTargetInfluences![0] = 0.7
    set.mesh.morphTargetInfluences![1] = 0.2
    expect(played.activations()).toEqual([0.35, 0.2, 0.2])
    expect(set.activations()).toEqual([0.35, 0.2, 0.2])
  })

  it('delays an activation by the clock, but not in the first frame', () => {
    const { mesh, wrinkles, activations } = drivenFace([
      morph('brow', 'browDownLeft'),
      { type: 'time', area: 'brow', attack: 0.1, release: 0.4 },
    ])
    let milliseconds = 5000
    wrinkles.clock = { now: () => milliseconds }
    mesh.morphTargetInfluences![0] = 0.5
    expect(activations()[0]).toBe(0.5)
    mesh.morphTargetInfluences![0] = 1
    milliseconds += 100
    expect(activations()[0]).toBeCloseTo(1 - 0.5 * Math.exp(-1), 3)
    mesh.morphTargetInfluences![0] = 0
    const from = activations()[0]!
    milliseconds += 400
    expect(activations()[0]).toBeCloseTo(from * Math.exp(-1), 3)
  })

  it('keeps the preset expressions for players', () => {
    const { wrinkles } = drivenFace([
      {
        type: 'expression',
        name: 'doubt',
        targets: [{ name: 'jawOpen', weight: 0.3 }],
        activations: [{ area: 'nose', activation: 1 }],
      },
    ])
    expect(wrinkles.expressions).toEqual([
      { name: 'doubt', targets: { jawOpen: 0.3 }, activations: { nose: 1 } },
    ])
  })

  it.each<[string, WrinkleDriver, string, string[]?]>([
    ['a target', morph('nose', 'trunkUp'), 'target \\"trunkUp\\" of a driver of area \\"nose\\"'],
    ['all targets', morph('nose', 'jawOpen'), 'target \\"jawOpen\\" of a driver of area \\"nose\\"', []],
    [
      'a joint',
      { type: 'bone', area: 'nose', joints: ['head', 'tail'], measure: 'angle', curve: STRAIGHT },
      'joint \\"tail\\" of a driver of area \\"nose\\"',
    ],
    ['a type', { type: 'weather', area: 'nose' }, 'driver of type \\"weather\\"'],
    [
      'an area that drives itself',
      { type: 'area', area: 'nose', areas: [{ name: 'nose', weight: 1 }], rule: 'sum', curve: STRAIGHT },
      'area \\"nose\\" (cyclic)',
    ],
  ])('warns once of %s, and runs the other drivers', (_, driver, message, targets) => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const { head, activations } = drivenFace(
      [driver, { type: 'bone', area: 'neck', joints: ['chest', 'head'], measure: 'angle', curve: STRAIGHT }],
      targets,
    )
    head.rotation.z = 0.3
    for (let i = 0; i < 3; i++) expect(activations()).toEqual([0, 0.2, 0.3])
    expect(warn).toHaveBeenCalledTimes(1)
    expect(warn.mock.calls[0][0]).toContain(message)
  })

  it('warns once about drivers of a removed area, and the other drivers still work', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const { mesh, wrinkles, activations } = drivenFace([
      morph('brow', 'browDownLeft'),
      morph('nose', [link('browDownLeft', 0.5)]),
    ])
    mesh.morphTargetInfluences![0] = 0.5
    expect(activations()).toEqual([0.5, 0.45, 0])
    removeArea(wrinkles, 'brow')
    for (let i = 0; i < 3; i++) expect(activations()).toEqual([null, 0.45, 0])
    expect(warn).toHaveBeenCalledTimes(1)
    expect(warn.mock.calls[0][0]).toContain('area \\"brow\\"')
  })

  it('inputs start from the values of their drivers, and can be set before their drivers are added', () => {
    const age: WrinkleDriver = {
      type: 'age',
      area: 'brow',
      curve: [
        [20, 0.1],
        [70, 0.6],
      ],
    }
    const { wrinkles, activations } = drivenFace([
      age,
      { ...age, type: 'input', name: 'stress', area: 'neck' },
    ])
    expect([wrinkles.inputs.get('age'), wrinkles.inputs.get('stress'), wrinkles.inputs.get('cold')]).toEqual([
      20, 0, 0,
    ])
    expect(wrinkles.inputs.names).toEqual(['age', 'stress'])
    expect(activations()).toEqual([0.1, 0.2, 0.1])
    wrinkles.inputs.set('stress', 45)
    wrinkles.inputs.set('cold', 1)
    expect(activations()).toEqual([0.1, 0.2, 0.35])
    addDrivers(wrinkles, [{ ...age, type: 'input', name: 'cold', area: 'nose', curve: STRAIGHT }])
    expect(activations()[1]).toBe(1)
  })

  it('update() updates the activations without drawing', () => {
    const { mesh, wrinkles } = drivenFace([morph('brow', 'browDownLeft')])
    mesh.morphTargetInfluences![0] = 0.7
    expect(wrinkles.getActivation('brow')).toBe(0)
    wrinkles.update()
    expect(wrinkles.getActivation('brow')).toBeCloseTo(0.7, 6)
  })
})
