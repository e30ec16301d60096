import type { WrinkleDriver } from 'furrow'
import { addDrivers, ExpressionPlayer } from 'furrow/three'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { face, morph, STRAIGHT } from './driven-face.ts'

afterEach(() => vi.restoreAllMocks())

describe('addDrivers', () => {
  it('adds blendshapes, joints, tension and age to what is at rest', () => {
    const { mesh, head, wrinkles, activations } = face([
      morph('brow', 'browDownLeft', 0.5),
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
      {
        type: 'age',
        area: 'nose',
        curve: [
          [20, 0],
          [70, 0.5],
        ],
      },
    ])
    expect(activations()).toEqual([0, 0.2, 0])
    mesh.morphTargetInfluences![0] = 0.6
    mesh.morphTargetInfluences![1] = 0.1
    head.rotation.x = 0.4
    wrinkles.inputs.set('age', 50)
    // The square is 30% narrower, and so is the brow; half of 0.6 comes from the blendshape itself.
    expect(activations()).toEqual([0.6, 0.6, 0.4])
    // Moved as a whole nothing else happens.
    mesh.position.set(1, 2, 3)
    mesh.rotation.y = 2
    expect(activations()).toEqual([0.6, 0.6, 0.4])
    wrinkles.setRestingActivation('neck', 0.25)
    expect(activations()).toEqual([0.6, 0.6, 0.65])
    expect(wrinkles.getRestingActivation('neck')).toBe(0.25)
  })

  it('leaves areas without a driver to whoever sets them', () => {
    const { wrinkles, activations } = face([morph('brow', 'browDownLeft')])
    wrinkles.setActivation('neck', 0.9)
    wrinkles.setActivation('brow', 0.9)
    expect(activations()).toEqual([0, 0.2, 0.9])
    wrinkles.driven = false
    wrinkles.setActivation('brow', 0.9)
    expect(activations()).toEqual([0.9, 0.2, 0.9])
  })

  it('age adds to what is set, and delays follow it, where nothing else moves an area', () => {
    const { wrinkles, activations } = face([
      {
        type: 'age',
        area: 'brow',
        curve: [
          [20, 0],
          [70, 0.5],
        ],
      },
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

  it('presets play on an aging face without drifting', () => {
    const { mesh, wrinkles, activations } = face([
      {
        type: 'age',
        area: 'brow',
        curve: [
          [20, 0],
          [70, 0.5],
        ],
      },
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

  it('a preset and the blendshapes that it sets move the areas alike', () => {
    const drivers = [morph('brow', 'browDownLeft', 0.5), morph('neck', 'jawOpen')]
    const [played, set] = [face(drivers), face(drivers)]
    new ExpressionPlayer(played.mesh, played.wrinkles, [
      { name: 'frown', targets: { browDownLeft: 0.7, jawOpen: 0.2 }, activations: { brow: 1, neck: 1 } },
    ]).play('frown', 0)
    set.mesh.morphTargetInfluences![0] = 0.7
    set.mesh.morphTargetInfluences![1] = 0.2
    expect(played.activations()).toEqual([0.35, 0.2, 0.2])
    expect(set.activations()).toEqual([0.35, 0.2, 0.2])
  })

  it('follows with a delay by the clock, the first frame at once', () => {
    const { mesh, wrinkles, activations } = face([
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

  it('keeps the presets of the file for players', () => {
    const { wrinkles } = face([
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
      'area \\"nose\\", which drives itself,',
    ],
  ])('warns once of %s, and drives the rest', (_, driver, message, targets) => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const { head, activations } = face(
      [driver, { type: 'bone', area: 'neck', joints: ['chest', 'head'], measure: 'angle', curve: STRAIGHT }],
      targets,
    )
    head.rotation.z = 0.3
    for (let i = 0; i < 3; i++) expect(activations()).toEqual([0, 0.2, 0.3])
    expect(warn).toHaveBeenCalledTimes(1)
    expect(warn.mock.calls[0][0]).toContain(message)
  })

  it('says once that an area is gone, and moves the rest', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const { mesh, wrinkles, activations } = face([
      morph('brow', 'browDownLeft'),
      morph('nose', 'browDownLeft', 0.5),
    ])
    mesh.morphTargetInfluences![0] = 0.5
    expect(activations()).toEqual([0.5, 0.45, 0])
    wrinkles.removeArea('brow')
    for (let i = 0; i < 3; i++) expect(activations()).toEqual([null, 0.45, 0])
    expect(warn).toHaveBeenCalledTimes(1)
    expect(warn.mock.calls[0][0]).toContain('area \\"brow\\"')
  })

  it('refuses an input that is NaN, or of an instance that does not exist', () => {
    const { inputs } = face([]).wrinkles
    expect(() => inputs.set('age', Number.NaN)).toThrow(
      'Wrinkles.inputs: value of "age" is NaN or infinite, got NaN, allowed: a finite number',
    )
    expect(() => inputs.set('age', 40, 1)).toThrow('no such instance, got 1, allowed: 0 to 0')
  })

  it('inputs start from what their drivers say, and can be set before there are drivers', () => {
    const age: WrinkleDriver = {
      type: 'age',
      area: 'brow',
      curve: [
        [20, 0.1],
        [70, 0.6],
      ],
    }
    const { wrinkles, activations } = face([age, { ...age, type: 'input', name: 'stress', area: 'neck' }])
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

  it('brings activations up to date without drawing by update()', () => {
    const { mesh, wrinkles } = face([morph('brow', 'browDownLeft')])
    mesh.morphTargetInfluences![0] = 0.7
    expect(wrinkles.getActivation('brow')).toBe(0)
    wrinkles.update()
    expect(wrinkles.getActivation('brow')).toBeCloseTo(0.7, 6)
  })
})
