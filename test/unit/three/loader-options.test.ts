import { FurrowError, type WrinkleSet } from 'furrow'
import { WrinkleLoaderPlugin as WebGLPlugin, Wrinkles } from 'furrow/three'
import { WrinkleLoaderPlugin as WebGPUPlugin } from 'furrow/webgpu'
import { Mesh, MeshStandardMaterial, PlaneGeometry } from 'three'
import { describe, expect, it } from 'vitest'
import { randomSet } from '../../cases.ts'
import { seeded } from '../../random.ts'
import { frameOf } from './stub-renderer.ts'

describe.each([WebGLPlugin, WebGPUPlugin])('the loader plugin', (Plugin) => {
  const create = (options: object) => new Plugin({ json: {} } as never, options)

  it('takes the options of Wrinkles', () => {
    expect(() => create({ mode: 'composed', areaSize: 64, fadeBelow: 200, relief: 'near' })).not.toThrow()
  })

  it.each<[object, string]>([
    [{ mode: 'bogus' }, 'WrinkleLoaderPlugin: unknown mode, got "bogus", allowed: default,'],
    [{ areaSize: 0.5 }, 'WrinkleLoaderPlugin: areaSize, got 0.5, allowed: 2 to 8192 texels'],
    [{ areaSize: 1e9 }, 'WrinkleLoaderPlugin: areaSize, got 1000000000,'],
    [{ fadeBelow: -1 }, 'WrinkleLoaderPlugin: fadeBelow, got -1, allowed: 0 pixels or more'],
    [{ relief: true }, 'WrinkleLoaderPlugin: unknown relief, got true, allowed: off, on, near'],
    [{ fadeBelow: Number.NaN }, 'WrinkleLoaderPlugin: fadeBelow, got NaN'],
  ])('refuses %j', (options, message) => {
    expect(() => create(options)).toThrow(FurrowError)
    expect(() => create(options)).toThrow(message)
  })
})

it('a wrinkle set brings its drivers', () => {
  const mesh = new Mesh(new PlaneGeometry(), new MeshStandardMaterial())
  mesh.morphTargetDictionary = { jawOpen: 0 }
  mesh.morphTargetInfluences = [1]
  const driver = { type: 'morph', area: 'area0', targets: [{ name: 'jawOpen', weight: 1 }], rule: 'sum' }
  const curve = [
    [0, 0],
    [1, 1],
  ]
  const set: WrinkleSet = { ...randomSet(seeded(1), 1, 8), drivers: [Object.assign(driver, { curve })] }
  const wrinkles = new Wrinkles(mesh, set)
  frameOf(mesh)()
  expect(wrinkles.getActivation('area0')).toBe(1)
})

it('a class of its own that extends Wrinkles has instances of its own only', () => {
  class Own extends Wrinkles {}
  const create = (Class: typeof Wrinkles) =>
    new Class(new Mesh(new PlaneGeometry(), new MeshStandardMaterial()), randomSet(seeded(1), 1, 2))
  expect(create(Own)).toBeInstanceOf(Own)
  expect(create(Own)).toBeInstanceOf(Wrinkles)
  expect(create(Wrinkles)).not.toBeInstanceOf(Own)
})
