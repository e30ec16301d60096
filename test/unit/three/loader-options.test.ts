import { FurrowError, type WrinkleSet } from 'furrow'
import { WrinkleLoaderPlugin as WebGLPlugin, Wrinkles } from 'furrow/three'
import { WrinkleLoaderPlugin as WebGPUPlugin } from 'furrow/webgpu'
import { describe, expect, it } from 'vitest'
import { blendMesh } from '../../blend-mesh.ts'
import { randomSet } from '../../cases.ts'
import { morph } from '../../drivers.ts'
import { seeded } from '../../random.ts'
import { frameOf } from './stub-renderer.ts'

describe.each([WebGLPlugin, WebGPUPlugin])('the loader plugin', (Plugin) => {
  const create = (options: object) => new Plugin({ json: {} } as never, options)

  it('passes its options to Wrinkles', () => {
    expect(() => create({ mode: 'composed', areaSize: 64, fadeBelow: 200, relief: 'near' })).not.toThrow()
  })

  it.each<[object, string]>([
    [{ mode: 'bogus' }, 'WrinkleLoaderPlugin: invalid mode, got "bogus", allowed: default,'],
    [{ relief: true }, 'WrinkleLoaderPlugin: invalid relief, got true, allowed: off, on, near'],
  ])('refuses %j', (options, message) => {
    expect(() => create(options)).toThrow(FurrowError)
    expect(() => create(options)).toThrow(message)
  })
})

it("adds a wrinkle set's drivers", () => {
  const mesh = blendMesh('jawOpen')
  mesh.morphTargetInfluences![0] = 1
  const set: WrinkleSet = { ...randomSet(seeded(1), 1, 8), drivers: [morph('area0', 'jawOpen')] }
  const wrinkles = new Wrinkles(mesh, set)
  frameOf(mesh)()
  expect(wrinkles.getActivation('area0')).toBe(1)
})

it('tracks instances of a class that extends Wrinkles separately', () => {
  class Own extends Wrinkles {}
  const create = (Class: typeof Wrinkles) => new Class(blendMesh(), randomSet(seeded(1), 1, 2))
  expect(create(Own)).toBeInstanceOf(Own)
  expect(create(Own)).toBeInstanceOf(Wrinkles)
  expect(create(Wrinkles)).not.toBeInstanceOf(Own)
})
