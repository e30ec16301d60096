import { type MuscleDriver, parseDrivers } from 'furrow'
import { addDrivers, Wrinkles } from 'furrow/three'
import { Bone, BufferAttribute, Mesh, MeshStandardMaterial, Object3D, PlaneGeometry } from 'three'
import { beforeEach, describe, expect, it } from 'vitest'
import { targetDials } from '../../../studio/src/viewer/pose/dials.ts'
import { FaceDrivers } from '../../../studio/src/viewer/pose/face-drivers.ts'
import { jointsOf } from '../../../studio/src/viewer/pose/joints.ts'
import { muscleAxis } from '../../../studio/src/viewer/pose/muscle-axis.ts'
import { MuscleTargets } from '../../../studio/src/viewer/pose/muscle-targets.ts'
import { layer, randomNormals } from '../../cases.ts'
import { ramp, STRAIGHT } from '../../drivers.ts'
import { seeded } from '../../random.ts'

const SHAPES = ['browInnerUp', 'browDownLeft', 'squash']
const AREAS = ['brow', 'glabella', 'lines', 'cold', 'neck', 'cheek', 'spare']

/** One driver of each type that activates an area, and a conflict. */
const DRIVERS = parseDrivers(
  [
    { type: 'conflict', targets: ['browInnerUp', 'browDownLeft'] },
    {
      type: 'morph',
      area: 'brow',
      targets: [{ name: 'browInnerUp', weight: 0.5, curve: ramp(0.1, 0.9) }],
    },
    { type: 'area', area: 'glabella', areas: [{ name: 'brow' }], curve: ramp(0, 0.4) },
    { type: 'age', area: 'lines', curve: ramp(20, 80, 0.6) },
    {
      type: 'input',
      area: 'cold',
      name: 'cold',
      curve: [
        [-10, 1],
        [10, 0],
      ],
    },
    { type: 'bone', area: 'neck', joints: ['chest', 'head'], measure: 'angle', curve: STRAIGHT },
    { type: 'tension', area: 'cheek', curve: ramp(0, 0.5) },
    { type: 'time', area: 'brow', attack: 5 },
  ],
  AREAS,
)

let mesh: Mesh
let head: Bone
let wrinkles: Wrinkles
let inputs: Map<string, number>
let resting: Map<string, number>
let drivers: FaceDrivers

beforeEach(() => {
  const geometry = new PlaneGeometry()
  geometry.morphTargetsRelative = true
  geometry.morphAttributes.position = SHAPES.map((name) => {
    const offsets = new Float32Array(12)
    // Halfway towards the middle.
    if (name === 'squash')
      for (let i = 0; i < 4; i++) offsets[3 * i] = -geometry.getAttribute('position').getX(i) / 2
    const attribute = new BufferAttribute(offsets, 3)
    attribute.name = name
    return attribute
  })
  mesh = new Mesh(geometry, new MeshStandardMaterial())
  head = new Bone()
  head.name = 'head'
  const chest = new Bone()
  chest.name = 'chest'
  chest.add(head)
  const root = new Object3D()
  root.add(mesh, chest)
  const weights = { width: 2, height: 2, data: new Uint8Array(4).fill(255) }
  wrinkles = new Wrinkles(mesh, {
    layers: [layer('skin', 'replace', randomNormals(seeded(1), 2))],
    areas: AREAS.map((name) => ({ name, weights })),
  })
  inputs = new Map()
  resting = new Map([['lines', 0.1]])
  drivers = new FaceDrivers(wrinkles, DRIVERS, { inputs, resting })
})

function pose(weights: readonly number[], angle: number): void {
  weights.forEach((weight, i) => {
    mesh.morphTargetInfluences![i] = weight
  })
  head.rotation.x = angle
  head.parent!.updateMatrixWorld(true)
}

function activations(): Record<string, number> {
  const values = drivers.evaluate()
  return Object.fromEntries(drivers.areaNames.map((name, i) => [name, values[i]]))
}

describe('drivers on the stage', () => {
  it('at rest give the activations at rest', () => {
    pose([0, 0, 0], 0)
    const { lines, ...others } = activations()
    expect(lines).toBeCloseTo(0.1, 6)
    expect(others).toEqual({ brow: 0, glabella: 0, cold: 0.5, neck: 0, cheek: 0 })
  })

  it('of every type give the same activations as the renderer', () => {
    addDrivers(
      wrinkles,
      DRIVERS.filter(({ type }) => type !== 'time'),
    )
    wrinkles.setRestingActivation('lines', 0.1)
    const random = seeded(2)
    for (let i = 0; i < 20; i++) {
      pose([random(), random() / 2, random()], random())
      for (const [name, value] of [
        ['age', 20 + 60 * random()],
        ['cold', 20 * random() - 10],
      ] as const) {
        inputs.set(name, value)
        wrinkles.inputs.set(name, value)
      }
      wrinkles.update()
      for (const [area, activation] of Object.entries(activations())) {
        expect(activation, area).toBeCloseTo(wrinkles.getActivation(area), 5)
      }
    }
  })

  it('report the inputs of their links and curves, and their results', () => {
    pose([0.7, 0.2, 0], 0)
    const given = drivers.contributions()
    expect(given).toHaveLength(DRIVERS.length)
    expect(given[0]).toBeNull()
    expect(given[7]).toBeNull()
    // The conflict reduces 0.7 to 0.5. The link maps this value by its curve and multiplies the result by 0.5.
    const { inputs: read, links, combined, activation } = given[1]!
    expect(read[0]).toBeCloseTo(0.5, 6)
    expect(links[0]).toBeCloseTo(0.25, 6)
    expect(combined).toBeCloseTo(0.25, 6)
    expect(activation).toBeCloseTo(0.25, 6)
    expect(given[2]!.combined).toBeCloseTo(0.25, 6)
    expect(given[2]!.activation).toBeCloseTo(0.625, 6)
  })

  it('are found by the blendshapes that they read, and inputs by their names', () => {
    expect(drivers.targetsOf('brow')).toEqual(['browInnerUp'])
    expect(drivers.areasOf('browInnerUp')).toEqual(['brow'])
    expect(drivers.input('age')).toBe(20)
    inputs.set('age', 44)
    expect(drivers.input('age')).toBe(44)
  })

  it('do not exist on a face without wrinkles', () => {
    const none = new FaceDrivers(null, DRIVERS, { inputs, resting })
    expect(none.areaNames).toEqual([])
    expect(none.contributions()).toEqual(DRIVERS.map(() => null))
  })
})

it('the joints of a face are listed after their parents', () => {
  expect(jointsOf(mesh.parent!)).toEqual([['chest', 'head']])
})

describe('a muscle of the document', () => {
  const muscle = (strength: number) =>
    parseDrivers(
      [{ type: 'muscle', name: 'frontalis', origin: [0.5, 1.5, 0], insertion: [0.5, 0.5, 0], strength }],
      [],
    ) as MuscleDriver[]

  const pull = () => {
    const index = mesh.morphTargetDictionary!.frontalis
    return Array.from(mesh.geometry.morphAttributes.position![index].array)
  }

  it('adds a blendshape to the face, which changes with the muscle', () => {
    const targets = new MuscleTargets([mesh])
    targets.update(muscle(0.2))
    expect(Object.keys(mesh.morphTargetDictionary!)).toEqual([...SHAPES, 'frontalis'])
    const weak = pull()
    expect(Math.hypot(...weak)).toBeGreaterThan(0)
    let disposed = 0
    mesh.geometry.addEventListener('dispose', () => disposed++)
    targets.update(muscle(0.2))
    expect(disposed).toBe(0)
    targets.update(muscle(0.4))
    expect(disposed).toBe(1)
    expect(Math.hypot(...pull())).toBeCloseTo(2 * Math.hypot(...weak), 5)
  })

  it('can be removed while other muscles keep moving the skin, and returns with undo', () => {
    const targets = new MuscleTargets([mesh])
    const other = { ...muscle(0.3)[0], name: 'corrugator' }
    targets.update([...muscle(0.2), other])
    const { morphTargetInfluences: weights, morphTargetDictionary: known } = mesh
    weights![known!.corrugator] = 0.7
    const pulled = mesh.geometry.morphAttributes.position![known!.corrugator]
    targets.update([other])
    expect(Object.keys(known!)).toEqual([...SHAPES, 'corrugator'])
    expect(weights).toHaveLength(SHAPES.length + 1)
    expect(weights![known!.corrugator]).toBe(0.7)
    expect(mesh.geometry.morphAttributes.position![known!.corrugator]).toBe(pulled)
    targets.update([...muscle(0.2), other])
    expect(known!.frontalis).toBe(SHAPES.length + 1)
    expect(Math.hypot(...pull())).toBeGreaterThan(0)
  })

  it('has a slider that does nothing after its removal, while other sliders still work', () => {
    const targets = new MuscleTargets([mesh])
    const other = { ...muscle(0.3)[0], name: 'corrugator' }
    targets.update([...muscle(0.2), other])
    const dials = targetDials(mesh)
    const dial = (name: string) => dials.find((each) => each.name === name)!
    dial('corrugator').write(0.7)
    targets.update([other])
    const before = [...mesh.morphTargetInfluences!]
    dial('frontalis').write(0.4)
    expect(dial('frontalis').read()).toBe(0)
    expect(mesh.morphTargetInfluences).toEqual(before)
    expect(dial('corrugator').read()).toBe(0.7)
  })

  it('does not change blendshapes of the file', () => {
    const targets = new MuscleTargets([mesh])
    const before = mesh.geometry.morphAttributes.position![2].array.slice()
    targets.update([{ ...muscle(0.2)[0], name: 'squash' }])
    targets.update([{ ...muscle(0.9)[0], name: 'squash' }])
    expect(mesh.geometry.morphAttributes.position![2].array).toEqual(before)
  })

  it('starts in the middle of its area', () => {
    const left = { width: 2, height: 1, data: Uint8Array.of(255, 0) }
    const { origin, insertion } = muscleAxis(mesh, left)!
    expect(insertion[0]).toBeCloseTo(-0.5, 6)
    expect(origin[1]).toBeGreaterThan(insertion[1])
    expect(muscleAxis(mesh, { ...left, data: new Uint8Array(2) })).toBeNull()
  })
})
