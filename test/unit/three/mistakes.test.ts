import { NullEngine } from '@babylonjs/core/Engines/nullEngine.js'
import { TransformNode } from '@babylonjs/core/Meshes/transformNode.js'
import { Scene } from '@babylonjs/core/scene.js'
import { autoWrinkles } from 'furrow/author'
import * as babylon from 'furrow/babylon'
import {
  activationTrack,
  addDrivers,
  ExpressionPlayer,
  extendLoader,
  frameFace,
  updateArea,
  WrinkleLoaderPlugin,
  Wrinkles,
  wrinklesOf,
  wrinklesReady,
} from 'furrow/three'
import { Group, PerspectiveCamera } from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { ramp } from '../../drivers.ts'
import { expectRefused, face, plain, set } from './refused.ts'

/** Values that only plain JavaScript can pass. */
const any = (value: unknown) => value as never

const { mesh, wrinkles } = face()
const parser = { json: {} }
const declared = () => ({
  scene: new Group(),
  userData: {},
  parser: { json: { extensionsUsed: ['FURROW_wrinkle_maps'] } },
})
const withAge = () => {
  const own = face().wrinkles
  addDrivers(own, [{ type: 'age', area: 'area0', from: 20, curve: ramp(20, 80) } as never])
  return own
}

afterEach(() => vi.restoreAllMocks())

describe('mistakes', () => {
  it.each<[error: RegExp, run: () => unknown]>([
    [
      /^Wrinkles: unknown option, got "fadebelow", allowed: mode, areaSize, .*; did you mean "fadeBelow"\?$/,
      () => new Wrinkles(plain(), set(), any({ fadebelow: 100 })),
    ],
    [
      /^WrinkleLoaderPlugin: unknown option, got "Auto", allowed: .*auto; did you mean "auto"\?$/,
      () => new WrinkleLoaderPlugin(any(parser), any({ Auto: {} })),
    ],
    [
      /^WrinkleLoaderPlugin auto: unknown option, got "Age", allowed: age, .*; did you mean "age"\?$/,
      () => new WrinkleLoaderPlugin(any(parser), { auto: any({ Age: 45 }) }),
    ],
    [
      /^WrinkleLoaderPlugin auto: invalid age, got 450, allowed: a number, 20 to 80; /,
      () => new WrinkleLoaderPlugin(any(parser), { auto: { age: 450 } }),
    ],
    [
      /^WrinkleLoaderPlugin auto: unknown option, got "kind", allowed: .*kinds; did you mean "kinds"\?$/,
      () => new WrinkleLoaderPlugin(any(parser), { auto: any({ kind: {} }) }),
    ],
    [
      /^WrinkleLoaderPlugin auto: invalid kind, got "wool", allowed: skin, cloth, hard; /,
      () => new WrinkleLoaderPlugin(any(parser), { auto: { kinds: { Sweater: any('wool') } } }),
    ],
    [
      /^autoWrinkles: unknown region, got "crowfeet", allowed: .*; did you mean "crowsFeet"\?$/,
      () => autoWrinkles(any({}), { regions: [any('crowfeet')] }),
    ],
    [
      /^autoWrinkles: invalid seed, got 0.5, allowed: a whole number, 0 to /,
      () => autoWrinkles(any({}), { seed: 0.5 }),
    ],
    [
      /^WrinkleLoaderPlugin: invalid parser, got "undefined", allowed: .*; call extendLoader\(loader\)/,
      () => new WrinkleLoaderPlugin(...([] as never as [never])),
    ],
    [
      /^WrinkleLoaderPlugin: invalid parser, got "GLTFLoader"/,
      () => new WrinkleLoaderPlugin(any(new GLTFLoader())),
    ],
    [
      /^extendLoader: invalid loader, got .*allowed: a GLTFLoader instance/,
      () => extendLoader(any(GLTFLoader)),
    ],
    [
      /^extendLoader: unknown option, got "modes", .*did you mean "mode"\?$/,
      () => extendLoader(new GLTFLoader(), any({ modes: 'off' })),
    ],
    [
      /^wrinklesOf: invalid argument, got "Group", allowed: .*gltf, not gltf.scene/,
      () => wrinklesOf(any(new Group())),
    ],
    [/^wrinklesOf: invalid argument, got "Promise"/, () => wrinklesOf(any(Promise.resolve()))],
    [
      /^activationTrack: unknown area, got "aera0", allowed: "area0", "area1"; did you mean "area0"\?$/,
      () => activationTrack(mesh, 'aera0', [0], [1]),
    ],
    [
      /^ExpressionPlayer: invalid wrinkles of the face, got "a list of 1", allowed: an item of the list, such as wrinklesOf\(gltf\)\[0\]/,
      () => new ExpressionPlayer(mesh, any([wrinkles])),
    ],
    [
      /^updateArea: invalid wrinkles, got "a list of 1", allowed: an item of the list/,
      () => updateArea(any([wrinkles]), 'area0', set().areas[0].weights),
    ],
    [
      /^ExpressionMix: unknown expression, got "hapy", .*did you mean "happy"\?$/,
      () =>
        new ExpressionPlayer(mesh, wrinkles, [
          { name: 'happy', targets: { jawOpen: 1 }, activations: {} },
        ]).play('hapy'),
    ],
    [
      /^frameFace: unknown option, got "yawn", allowed: yaw, pitch, zoom; did you mean "yaw"\?$/,
      () => frameFace(new PerspectiveCamera(), mesh, any({ yawn: 30 })),
    ],
    [
      /^registerWrinkleMaps: .*got "aeraSize", allowed: mode, areaSize; did you mean "areaSize"\?$/,
      () => babylon.registerWrinkleMaps(any({ aeraSize: 64 })),
    ],
    [
      /^wrinklesOf: invalid argument, got "_?TransformNode"/,
      () => babylon.wrinklesOf(any(new TransformNode('root', new Scene(new NullEngine())))),
    ],
    [
      /^ExpressionPlayer: invalid wrinkles of the face, got "a list of 0"/,
      () => new babylon.ExpressionPlayer(any({}), any([])),
    ],
  ])('throw one error with the remedy: %s', (error, run) => {
    expectRefused(run, error)
  })

  it.each<[warning: RegExp, run: () => unknown]>([
    [
      /^wrinklesOf: the file has FURROW_wrinkle_maps, but was loaded without .*; call extendLoader\(loader\)/,
      (file = declared()) => [wrinklesOf(file), wrinklesOf(file), wrinklesReady(file)],
    ],
    [
      /^Wrinkles.inputs: no driver of this face reads the input, got "agee", allowed: age; did you mean "age"\?$/,
      (own = withAge()) => [own.inputs.set('agee', 40), own.inputs.set('agee', 50)],
    ],
    [
      /^wrinklesOf: files have no wrinkles before registerWrinkleMaps is called; /,
      () => [babylon.wrinklesOf({ meshes: [] }), babylon.wrinklesOf({ meshes: [] })],
    ],
  ])('log one warning: %s', async (warning, run) => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    await Promise.all([run()].flat())
    expect(warn.mock.calls).toEqual([[expect.stringMatching(warning)]])
  })

  it('a loader that is extended twice has one plugin, with the latest options', () => {
    const loader = new GLTFLoader()
    const register = vi.spyOn(loader, 'register')
    expect(extendLoader(extendLoader(loader), { mode: 'off' })).toBe(loader)
    expect(register).toHaveBeenCalledTimes(1)
    expect(register.mock.calls[0][0](any(parser))).toBeInstanceOf(WrinkleLoaderPlugin)
  })
})
