import type { Curve, WrinkleDriver } from 'furrow'
import { addDrivers, Wrinkles } from 'furrow/three'
import {
  Bone,
  Float32BufferAttribute,
  type Mesh,
  MeshStandardMaterial,
  PlaneGeometry,
  Skeleton,
  SkinnedMesh,
} from 'three'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { layer, randomNormals } from '../../cases.ts'
import { seeded } from '../../random.ts'
import { frameOf } from './stub-renderer.ts'

const STRAIGHT: Curve = [
  [0, 0],
  [1, 1],
]
const AREAS = ['brow', 'nose', 'neck']

/** A square with two blendshapes, of which the first makes it half as wide, and two joints. */
function face(drivers: WrinkleDriver[], targets = ['browDown_L', 'jawOpen']) {
  const geometry = new PlaneGeometry(1, 1, 4, 4)
  const { count } = geometry.getAttribute('position')
  geometry.morphTargetsRelative = true
  geometry.morphAttributes.position = targets.map((name, i) => {
    const offsets = new Float32Array(3 * count)
    for (let k = 0; k < count; k++) if (i === 0) offsets[3 * k] = -geometry.attributes.position.getX(k) / 2
    return Object.assign(new Float32BufferAttribute(offsets, 3), { name })
  })
  if (targets.length === 0) geometry.morphAttributes = {}
  geometry.setAttribute('skinIndex', new Float32BufferAttribute(new Float32Array(4 * count), 4))
  const one = Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0))
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(one, 4))
  const mesh = new SkinnedMesh(geometry, new MeshStandardMaterial())
  const [chest, head] = ['chest', 'head'].map((name) => Object.assign(new Bone(), { name }))
  head.position.y = 1
  mesh.add(chest.add(head))
  mesh.bind(new Skeleton([chest, head]))
  const weights = { width: 2, height: 2, data: new Uint8Array(4).fill(255) }
  const wrinkles = new Wrinkles(mesh, {
    layers: [layer('skin', 'detail', randomNormals(seeded(1), 2))],
    areas: AREAS.map((name) => ({ name, weights, ...(name === 'nose' && { activation: 0.2 }) })),
  })
  addDrivers(wrinkles, drivers)
  const draw = frameOf(mesh as Mesh)
  const activations = () => {
    draw()
    return AREAS.map((name) =>
      wrinkles.hasArea(name) ? Math.round(1e4 * wrinkles.getActivation(name)) / 1e4 : null,
    )
  }
  return { mesh, head, wrinkles, activations }
}

const morph = (area: string, name: string, weight = 1): WrinkleDriver => ({
  type: 'morph',
  area,
  targets: [{ name, weight }],
  rule: 'sum',
  curve: STRAIGHT,
})

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
    wrinkles.age = 50
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
      'an end',
      { type: 'area', area: 'nose', areas: [{ name: 'nose', weight: 1 }], rule: 'sum', curve: STRAIGHT },
      'an end to the drivers of area \\"nose\\"',
    ],
  ])('says once that %s is missing, and moves the rest', (_, driver, message, targets) => {
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

  it('refuses an age that is none', () => {
    expect(() => {
      face([]).wrinkles.age = Number.NaN
    }).toThrow(/Wrinkles.age: no age, got NaN/)
  })
})
