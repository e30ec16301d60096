import type { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js'
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js'
import { HemisphericLight } from '@babylonjs/core/Lights/hemisphericLight.js'
import { LoadAssetContainerAsync } from '@babylonjs/core/Loading/sceneLoader.js'
import { Matrix, Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import type { Mesh } from '@babylonjs/core/Meshes/mesh.js'
import type { Scene } from '@babylonjs/core/scene.js'
import '@babylonjs/loaders/glTF/2.0/glTFLoader.js'
import { ExpressionPlayer, FaceTracker, registerWrinkleMaps, Wrinkles, wrinklesOf } from 'furrow/babylon'
import { afterEach, beforeAll, describe, expect, it } from 'vitest'
import { largestDifference, ROUNDING } from '../difference.ts'
import { quietConsole } from '../quiet-console.ts'
import { addEyes, driver, wrinkledFile } from '../wrinkled-file.ts'
import { type BabylonHarness, disposeScene, ENGINES, harnessOn } from './harness.ts'

const PIXELS = 32

// biome-ignore lint/suspicious/noExplicitAny: tests edit files in ways that no type allows
type Any = any

beforeAll(() => registerWrinkleMaps())

async function load(scene: Scene, file: Uint8Array) {
  const container = await LoadAssetContainerAsync(file, scene, { pluginExtension: '.glb' })
  container.addAllToScene()
  return container
}

/** Creates a scene with a light, and a camera that sees glTF faces from the front. */
function litScene(harness: BabylonHarness): Scene {
  const scene = harness.createScene()
  const camera = scene.activeCamera as FreeCamera
  camera.position.z = 5
  camera.setTarget(Vector3.Zero())
  new HemisphericLight('sky', Vector3.Up(), scene).intensity = 0.3
  new DirectionalLight('sun', new Vector3(-1, -1, -1), scene)
  return scene
}

const setTarget = (meshes: readonly { morphTargetManager?: Mesh['morphTargetManager'] }[], value: number) => {
  for (const { morphTargetManager } of meshes) {
    if (morphTargetManager) morphTargetManager.getTarget(0).influence = value
  }
}

describe.each(ENGINES)('a file with wrinkles in Babylon.js on %s', (name) => {
  const written = quietConsole()
  const harness = harnessOn(name)
  let scene: Scene
  afterEach(async () => {
    await disposeScene(scene)
    expect(harness.errors).toEqual([])
  })

  const open = async (...edits: Parameters<typeof wrinkledFile>) => {
    scene = litScene(harness)
    return load(scene, await wrinkledFile(...edits))
  }
  const picture = () => harness.render(scene, PIXELS)

  it('adds no wrinkles to eyes that share the material of the skin', async () => {
    const { meshes } = await open(undefined, addEyes)
    const wrinkled = meshes.filter((mesh) => wrinklesOf(mesh)).map(({ name }) => name)
    expect(new Set(wrinkled)).toEqual(new Set(['face_primitive0', 'face_primitive1']))
  })

  it('wrinkles all primitives as its blendshapes move', async () => {
    const { meshes } = await open()
    const rest = await picture()
    setTarget(meshes, 1)
    const moved = await picture()
    for (const half of [0, PIXELS / 2]) expect(differs(rest, moved, half), `half at ${half}`).toBe(true)
    setTarget(meshes, 0)
    expect(await picture()).toEqual(rest)
    expect(written.warn).not.toHaveBeenCalled()
  })

  it('finds blendshapes in other spellings, also on copies', async () => {
    const container = await open(
      () => {},
      (json) => {
        for (const { extras } of json.meshes) extras.targetNames = ['blendShape1.browInnerUp']
      },
    )
    const [, left] = container.meshes as Mesh[]
    const clone = left.clone('clone')
    setTarget(container.meshes, 0.6)
    await picture()
    for (const mesh of [left, clone]) expect(wrinklesOf(mesh)!.getActivation('a')).toBeCloseTo(0.5, 6)
    expect(written.warn).not.toHaveBeenCalled()
  })

  it('plays expressions and scores', async () => {
    const { meshes } = await open()
    const [root] = meshes
    const player = new ExpressionPlayer(root, wrinklesOf(meshes[1]), [
      { name: 'surprised', targets: { browInnerUp: 0.8 }, activations: { d: 0.5 } },
    ])
    player.play('surprised', 0)
    expect(meshes[1].morphTargetManager!.getTarget(0).influence).toBeCloseTo(0.8, 6)
    new FaceTracker(root).set([{ categoryName: 'browInnerUp', score: 0.3 }])
    expect(meshes[2].morphTargetManager!.getTarget(0).influence).toBeCloseTo(0.3, 6)
  })

  it('gives clones and instances their own activations', async () => {
    const container = await open()
    const [, left] = container.meshes as Mesh[]
    const clone = left.clone('clone')
    const instance = left.createInstance('instance')
    const faces = [left, clone, instance].map((mesh) => wrinklesOf(mesh)!)
    expect(new Set(faces).size).toBe(3)
    clone.position.x = 1
    for (const mesh of [clone, instance]) mesh.setEnabled(false)
    const shown = async (mesh: { setEnabled(on: boolean): void }, activation: number) => {
      for (const own of [...container.meshes.slice(1), clone, instance]) own.setEnabled(false)
      mesh.setEnabled(true)
      faces[[left, clone, instance].indexOf(mesh as Mesh)].setActivation('d', activation)
      return picture()
    }
    const rest = await shown(left, 0)
    const wrinkled = await shown(left, 1)
    expect(wrinkled).not.toEqual(rest)
    clone.position.copyFrom(left.position)
    for (const mesh of [clone, instance as never]) {
      expect(largestDifference(await shown(mesh, 0), rest)).toBeLessThan(ROUNDING)
      expect(largestDifference(await shown(mesh, 1), wrinkled)).toBeLessThan(ROUNDING)
    }
    expect(await shown(left, 0.5)).not.toEqual(wrinkled)
  })

  it.each([
    ['instances', (mesh: Mesh) => mesh.createInstance('copy')],
    ['clones with the same material', (mesh: Mesh) => mesh.clone('copy')],
  ])('gives %s their own wrinkles in the first frame', async (_, copyOf) => {
    const container = await open()
    const [, left, right] = container.meshes as Mesh[]
    right.setEnabled(false)
    const copy = copyOf(left)
    copy.position.x = 1
    const rest = await picture()
    wrinklesOf(copy)!.setActivation('d', 1)
    const moved = await picture()
    const halves = [0, PIXELS / 2].map((half) => differs(rest, moved, half))
    expect(halves.filter(Boolean)).toHaveLength(1)
    wrinklesOf(copy)!.setActivation('d', 0)
    wrinklesOf(left)!.setActivation('d', 1)
    const other = await picture()
    expect([0, PIXELS / 2].map((half) => differs(rest, other, half))).toEqual(
      halves.map((changed) => !changed),
    )
  })

  it('gives each thin instance its own activations', async () => {
    const container = await open()
    const [, left, right] = container.meshes as Mesh[]
    right.setEnabled(false)
    left.thinInstanceAdd([Matrix.Identity(), Matrix.Translation(1, 0, 0)])
    const wrinkles = new Wrinkles(left, wrinklesOf(left)!)
    expect(wrinkles.faceCount).toBe(2)
    const rest = await picture()
    wrinkles.setActivation('d', 1, 1)
    const moved = await picture()
    expect([0, PIXELS / 2].map((half) => differs(rest, moved, half)).filter(Boolean)).toHaveLength(1)
  })

  it('gives copies of a container their own wrinkles, with shared or separate materials', async () => {
    for (const cloneMaterials of [false, true]) {
      const container = await open()
      const copy = container.instantiateModelsToScene(undefined, cloneMaterials, { doNotInstantiate: true })
      const [own] = wrinklesOf(container)
      const [copied] = wrinklesOf(copy)
      expect(copied).not.toBe(own)
      setTarget(container.meshes, 0.6)
      await picture()
      expect(copied.areaNames).toEqual(own.areaNames)
      copied.setActivation('d', 1)
      await picture()
      expect(own.getActivation('d')).toBe(0)
      scene.dispose()
    }
  })

  // Only WebGL can lose and restore its context in a test; Babylon.js cannot restore a WebGPU device.
  if (name === 'webgl')
    it('redraws its influence and maps after the context was lost', async () => {
      const [wrinkles] = wrinklesOf(await open())
      wrinkles.setActivation('d', 1)
      const before = await picture()
      const { _gl: gl } = harness.engine as unknown as { _gl: WebGL2RenderingContext }
      const extension = gl.getExtension('WEBGL_lose_context')!
      const restored = new Promise((resolve) => harness.engine.onContextRestoredObservable.addOnce(resolve))
      extension.loseContext()
      await new Promise((resolve) => setTimeout(resolve, 50))
      extension.restoreContext()
      await restored
      // Changing the mode compiles new programs. Babylon.js does not draw with programs made before the loss.
      wrinkles.mode = 'off'
      await picture()
      wrinkles.mode = 'default'
      expect(await picture()).toEqual(before)
    })

  it('frees everything in 20 loads and disposals', async () => {
    const file = await wrinkledFile()
    scene = litScene(harness)
    const counts = () => {
      const { _compiledEffects: effects } = harness.engine as unknown as { _compiledEffects: object }
      const { textures, materials, meshes } = scene
      return {
        textures: textures.length,
        onGpu: harness.engine.getLoadedTexturesCache().length,
        effects: Object.keys(effects).length,
        materials: materials.length,
        meshes: meshes.length,
        observers: scene.onBeforeRenderObservable.observers.length,
      }
    }
    const once = async () => {
      const container = await load(scene, file)
      setTarget(container.meshes, 1)
      await picture()
      container.dispose()
    }
    await once()
    const before = counts()
    for (let i = 0; i < 20; i++) await once()
    expect(counts()).toEqual(before)
  })

  it.each([
    [
      'null',
      (_: Any, json: Any) => (json.materials[0].extensions.FURROW_wrinkle_maps = null),
      /must be an object, got null/,
    ],
    [
      'a texture without an image',
      (maps: Any, json: Any) => (json.textures[maps.areas[0].texture.index] = {}),
      /cannot be read/,
    ],
    [
      'an image that is cut off',
      (maps: Any, json: Any) => {
        const { source } = json.textures[maps.layers[0].normalTexture.index]
        json.bufferViews[json.images[source].bufferView].byteLength = 60
      },
      /not a readable image, got "truncated file"/,
    ],
    [
      'a file that does not declare it',
      (_: Any, json: Any) => (json.extensionsUsed = []),
      /extensionsUsed lacks/,
    ],
    [
      'KTX 2',
      (maps: Any, json: Any) => {
        const texture = json.textures[maps.layers[0].normalTexture.index]
        texture.extensions = { KHR_texture_basisu: { source: texture.source } }
        delete texture.source
      },
      /the maps are KTX 2, and there is no transcoder.*transcoderPath/,
    ],
  ])('stays plain, with one warning, because of %s', async (_, spoil, warning) => {
    const container = await open(undefined, (json) =>
      spoil(json.materials[0].extensions.FURROW_wrinkle_maps as never, json),
    )
    expect(wrinklesOf(container)).toEqual([])
    expect(written.warn.mock.calls.flat().filter((text) => /FURROW|Wrinkle/.test(String(text)))).toHaveLength(
      1,
    )
    expect(String(written.warn.mock.calls[0])).toMatch(warning)
    const pixels = await picture()
    expect(Math.max(...pixels)).toBeGreaterThan(0.1)
  })

  it.each([
    ['a transcoder that is not there', '/nowhere', /cannot be decoded/],
    ['a transcoder that is something else', '/test/gpu/babylon/not-a-transcoder', /cannot be decoded/],
  ])('stays plain, with one warning, because of %s', async (_, transcoderPath, warning) => {
    registerWrinkleMaps({ transcoderPath })
    scene = litScene(harness)
    const container = await LoadAssetContainerAsync('/conformance/files/ktx2.glb', scene)
    registerWrinkleMaps()
    expect(wrinklesOf(container)).toEqual([])
    expect(written.warn.mock.calls.map(String)).toEqual([expect.stringMatching(warning)])
  })

  it('skips drivers that are malformed, unknown or lack inputs, with one warning each', async () => {
    const container = await open((maps) => {
      maps.drivers = [
        driver('a', 'browInnerUp'),
        { type: 'morph', area: 'b', targets: 1 },
        { type: 'telepathy', area: 'b' },
        driver('c', 'nowhere'),
      ]
    })
    setTarget(container.meshes, 1)
    await picture()
    expect(wrinklesOf(container)[0].getActivation('a')).toBe(1)
    expect(written.warn).toHaveBeenCalledTimes(2)
  })
})

describe('features that only three.js supports', () => {
  it.each([
    [{ mode: 'paper' }, /invalid mode for Babylon.js, got "paper"/],
    [{ mode: 'composed' }, /invalid mode for Babylon.js/],
    [{ relief: 'on' }, /option unsupported in Babylon.js, got "relief"/],
    [{ auto: {} }, /option unsupported in Babylon.js, got "auto"/],
    [{ fadeBelow: 100 }, /option unsupported in Babylon.js/],
    [{ areaSize: 1 }, /areaSize/],
    [{ transcoderPath: 1 }, /transcoderPath/],
  ])('are refused: %j', (options, message) => {
    expect(() => registerWrinkleMaps(options as never)).toThrow(message)
  })
})

function differs(a: Float32Array, b: Float32Array, x0: number): boolean {
  for (let y = 0; y < PIXELS; y++) {
    for (let x = x0 + 2; x < x0 + PIXELS / 2 - 2; x++) {
      const at = 4 * (y * PIXELS + x)
      for (let c = 0; c < 3; c++) if (Math.abs(a[at + c] - b[at + c]) > 1 / 255) return true
    }
  }
  return false
}
