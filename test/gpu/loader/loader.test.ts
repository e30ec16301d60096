import { VRMExpressionLoaderPlugin } from '@pixiv/three-vrm-core'
import { packAreas, reference } from 'furrow/internal'
import { wrinklesOf } from 'furrow/three'
import type { Mesh, WebGLRenderer } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { clone as cloneSkinned } from 'three/addons/utils/SkeletonUtils.js'
import { describe, expect, it, vi } from 'vitest'
import { editGlb } from '../../glb.ts'
import { largestDifference, ROUNDING } from '../difference.ts'
import { harnessOn, RENDERERS } from '../harness.ts'
import { litPicture, loadFile } from '../loaded.ts'
import { addEyes, driver, WEIGHTS, wrinkledFile } from '../wrinkled-file.ts'

const SIZE = 16

describe.each(RENDERERS)('a file with wrinkles on %s', (name) => {
  const harness = harnessOn(name)

  const load = (file: Uint8Array) => loadFile(harness, file)
  const picture = ({ scene }: GLTF) => litPicture(harness, scene)
  const meshesOf = (gltf: GLTF) => {
    return gltf.scene.getObjectsByProperty('isMesh', true) as Mesh[]
  }

  it('wrinkles as its blendshapes move', async () => {
    const gltf = await load(await wrinkledFile())
    const [left, right] = meshesOf(gltf)
    const rest = await picture(gltf)
    left.morphTargetInfluences![0] = right.morphTargetInfluences![0] = 1
    const moved = await picture(gltf)
    expect(moved).not.toEqual(rest)
    // The file has two primitives that share the material and the wrinkles, one in each half of the picture.
    for (const half of [0, 16]) expect(differs(rest, moved, half), `half at ${half}`).toBe(true)
    left.morphTargetInfluences![0] = right.morphTargetInfluences![0] = 0
    expect(await picture(gltf)).toEqual(rest)
  })

  it.each([
    ['before', true],
    ['after', false],
  ])("follows a VRM's expressions by name, with its plugin registered %s three-vrm's", async (_, isFirst) => {
    const file = editGlb(await wrinkledFile(), (json) => {
      const node = json.nodes.findIndex(({ mesh }: { mesh?: number }) => mesh !== undefined)
      const smile = { morphTargetBinds: [{ node, index: 0, weight: 0 }], overrideBlink: 'block' }
      json.extensionsUsed = [...json.extensionsUsed, 'VRMC_vrm']
      json.extensions = {
        VRMC_vrm: {
          specVersion: '1.0',
          expressions: {
            preset: { happy: smile, blink: { morphTargetBinds: [{ node, index: 0, weight: 0 }] } },
          },
        },
      }
      const drivers = ['happy', 'blink'].map((target, i) => ({
        type: 'morph',
        area: ['a', 'b'][i],
        targets: [{ name: target }],
      }))
      for (const material of json.materials) {
        if (material.extensions) Object.assign(material.extensions.FURROW_wrinkle_maps, { drivers })
      }
    })
    const { Plugin } = harness
    const loader = new GLTFLoader()
    if (isFirst) loader.register((parser) => new Plugin(parser))
    loader.register((parser) => new VRMExpressionLoaderPlugin(parser))
    if (!isFirst) loader.register((parser) => new Plugin(parser))
    const gltf = await loader.parseAsync(file.buffer, '')
    const [wrinkles] = gltf.userData.wrinkles
    const expressions = gltf.userData.vrmExpressionManager
    const b = wrinkles.getActivation('b')
    expressions.setValue('happy', 0.5)
    expressions.setValue('blink', 1)
    expressions.update()
    await picture(gltf)
    expect(wrinkles.getActivation('a')).toBeCloseTo(0.5, 6)
    // `happy` blocks the blink, so the area driven by the blink is at rest.
    expect(wrinkles.getActivation('b')).toBeCloseTo(b, 6)
    expressions.setValue('happy', 0)
    expressions.update()
    await picture(gltf)
    expect(wrinkles.getActivation('b')).toBe(1)
  })

  it('reads each channel exactly, including alpha', async () => {
    const gltf = await load(await wrinkledFile())
    const [wrinkles] = gltf.userData.wrinkles
    const [left, right] = meshesOf(gltf)
    for (const [channel, area] of ['a', 'b', 'c', 'd'].entries()) {
      left.material = right.material = wrinkles.createInfluenceMaterial(area)
      const pixels = await picture(gltf)
      const weights = Uint8Array.from({ length: SIZE * SIZE }, (_, i) => WEIGHTS[4 * i + channel])
      const array = packAreas([{ width: SIZE, height: SIZE, data: weights }])
      for (let i = 0; i < 32 * 32; i++) {
        const [x, y] = [((i % 32) + 0.5) / 32, 1 - (Math.floor(i / 32) + 0.5) / 32]
        const exact = reference.sampleArray(array, x, y, 0)
        expect(Math.abs(pixels[4 * i] - exact)).toBeLessThanOrEqual(1 / 255)
      }
    }
  })

  it('shows the face without wrinkles in a loader without the plugin', async () => {
    const file = await wrinkledFile()
    const plain = await new GLTFLoader().parseAsync(file.slice().buffer as ArrayBuffer, '')
    const wrinkled = await load(file)
    wrinkled.userData.wrinkles[0].setActivation('b', 0)
    expect(await picture(plain)).toEqual(await picture(wrinkled))
    expect(wrinklesOf(plain)).toEqual([])
  })

  it('gives each copy of a face its own wrinkles with shared textures', async () => {
    const gltf = await load(await wrinkledFile())
    await picture(gltf)
    const { textures } = (harness.renderer as WebGLRenderer).info.memory
    const copy = cloneSkinned(gltf.scene)
    const [original, cloned] = [gltf.scene, copy].map((root) => meshesOf({ scene: root } as GLTF))
    for (const mesh of cloned) mesh.morphTargetInfluences![0] = 1
    const [moved, rest] = [await picture({ scene: copy } as GLTF), await picture(gltf)]
    for (const half of [0, 16]) expect(differs(rest, moved, half), `half at ${half}`).toBe(true)
    expect(original.map((mesh) => wrinklesOf(mesh)!.getActivation('a'))).toEqual([0, 0])
    expect(cloned.map((mesh) => wrinklesOf(mesh)!.getActivation('a'))).toEqual([1, 1])
    // At equal blendshape weights, the original looks like the copy.
    for (const mesh of original) mesh.morphTargetInfluences![0] = 1
    expect(largestDifference(await picture(gltf), moved)).toBeLessThan(ROUNDING)
    // The copy may need a larger atlas, which is one more texture for a while.
    expect((harness.renderer as WebGLRenderer).info.memory.textures).toBeLessThanOrEqual(textures + 1)
    gltf.userData.wrinkles[0].dispose()
    expect(await picture({ scene: copy } as GLTF), 'after dispose of the original').toEqual(moved)
    for (const mesh of cloned) wrinklesOf(mesh)!.dispose()
    expect(cloned.map((mesh) => wrinklesOf(mesh))).toEqual([undefined, undefined])
  })

  it('adds no wrinkles to eyes that share the material of the skin', async () => {
    const gltf = await load(await wrinkledFile(undefined, addEyes))
    expect(wrinklesOf(gltf)).toHaveLength(1)
    const [wrinkles] = gltf.userData.wrinkles
    await picture(gltf)
    expect(meshesOf(gltf).map((mesh) => wrinklesOf(mesh) === wrinkles)).toEqual([false, false, true, true])
    expect(meshesOf(gltf).map((mesh) => wrinklesOf(mesh) === undefined)).toEqual([true, true, false, false])
  })

  it('wrinkles two faces with one material independently', async () => {
    const gltf = await load(
      await wrinkledFile(undefined, (json) => {
        json.nodes.push({ ...json.nodes[0], name: 'twin', translation: [0, 0, -1] })
        json.scenes[0].nodes.push(json.nodes.length - 1)
      }),
    )
    expect(gltf.userData.wrinkles).toHaveLength(2)
    const twins = ['face', 'twin'].map((twin) => gltf.scene.getObjectByName(twin)!.children as Mesh[])
    for (const mesh of twins[1]) mesh.morphTargetInfluences![0] = 1
    await picture(gltf)
    expect(twins.map(([mesh]) => wrinklesOf(mesh)!.getActivation('a'))).toEqual([0, 1])
    for (const wrinkles of gltf.userData.wrinkles) wrinkles.dispose()
  })

  it('restores everything on dispose', async () => {
    const gltf = await load(await wrinkledFile())
    const [mesh] = meshesOf(gltf)
    const plain = await new GLTFLoader().parseAsync((await wrinkledFile()).buffer as ArrayBuffer, '')
    const expected = await picture(plain)
    for (const each of meshesOf(gltf)) each.morphTargetInfluences![0] = 0
    await picture(gltf)
    const textures = (harness.renderer as WebGLRenderer).info.memory.textures
    gltf.userData.wrinkles[0].dispose()
    expect(await picture(gltf)).toEqual(expected)
    // The textures of areas and normals are freed. The atlas of influence maps stays, because all faces share it.
    expect((harness.renderer as WebGLRenderer).info.memory.textures).toBeLessThanOrEqual(textures - 2)
    expect(mesh.onBeforeRender).toBe(Object.getPrototypeOf(mesh).onBeforeRender)
  })

  it('warns about a driver with an unknown target, and runs the others', async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const gltf = await load(await wrinkledFile((json) => json.drivers.push(driver('b', 'trunkUp'))))
    expect(warn.mock.calls.map(([text]) => text)).toEqual([
      expect.stringMatching(
        /^Wrinkles: drivers of mesh ".*" reference missing inputs, areas or types, got "target \\?"trunkUp/,
      ),
    ])
    warn.mockRestore()
    for (const mesh of meshesOf(gltf)) mesh.morphTargetInfluences![0] = 1
    await picture(gltf)
    expect(gltf.userData.wrinkles[0].getActivation('a')).toBe(1)
  })
})

function differs(a: Float32Array, b: Float32Array, firstColumn: number): boolean {
  return a.some((value, i) => {
    const column = (i >> 2) % 32
    return column >= firstColumn && column < firstColumn + 16 && value !== b[i]
  })
}
