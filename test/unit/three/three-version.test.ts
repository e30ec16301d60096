import { readFileSync } from 'node:fs'
import type { WrinkleSet } from 'furrow'
import { Wrinkles as WebGLWrinkles } from 'furrow/three'
import { Wrinkles } from 'furrow/webgpu'
import { writeArray } from 'furrow-files'
import {
  BatchedMesh,
  Mesh,
  MeshStandardMaterial,
  REVISION,
  ShaderChunk,
  type Texture,
  type WebGLRenderer,
} from 'three'
import { NodeBuilder } from 'three/webgpu'
import { afterEach, describe, expect, it, vi } from 'vitest'
import { loadMapArray } from '../../../packages/furrow/src/three/loader/ktx2.ts'
import {
  checkThree,
  NEWEST_THREE,
  OLDEST_THREE,
  requireInternal,
} from '../../../packages/furrow/src/three/three-version.ts'
import { quadMaterials } from '../../../packages/furrow/src/three/webgl/influence/influence-quads.ts'
import { instancedVertex } from '../../../packages/furrow/src/three/webgl/mixing/default-shader.ts'
import { checkBatch } from '../../../packages/furrow/src/three/webgpu/influence/influence.ts'

const shown = vi.hoisted(() => ({ revision: null as string | null }))
vi.mock('three', async (original) => {
  const three = await original<typeof import('three')>()
  return {
    ...three,
    get REVISION() {
      return shown.revision ?? three.REVISION
    },
  }
})
afterEach(() => {
  shown.revision = null
})

const read = (path: string) => JSON.parse(readFileSync(new URL(`../../../${path}`, import.meta.url), 'utf8'))

const SET: WrinkleSet = {
  layers: [{ name: 'skin', kind: 'replace', normal: { width: 1, height: 1, data: new Uint8Array(4) } }],
  areas: [{ name: 'nose', weights: { width: 1, height: 1, data: new Uint8Array(1) } }],
}

/** Matches the end of the error about a missing internal of three.js. */
const found = (name: string) =>
  new RegExp(
    `three\\.js lacks ${name}, got "r${REVISION}", allowed: up to r${NEWEST_THREE}; install a three\\.js release`,
  )

describe('the versions of three.js', () => {
  it('are the same in the package, the tests and the error messages', () => {
    const { devDependencies } = read('package.json')
    const { 'furrow/three': oldest, 'furrow/webgpu': oldestOfNodes } = OLDEST_THREE
    expect(read('packages/furrow/package.json').peerDependencies.three).toBe(`>=0.${oldest}.0`)
    expect(devDependencies['three-oldest']).toBe(`npm:three@0.${oldestOfNodes}.0`)
    expect(devDependencies.three).toMatch(new RegExp(`^0\\.${NEWEST_THREE}\\.\\d+$`))
    expect(REVISION).toBe(String(NEWEST_THREE))
  })

  it.each([
    ['furrow/three', WebGLWrinkles],
    ['furrow/webgpu', Wrinkles],
  ] as const)('are checked by %s before the mesh', (entry, Wrinkles) => {
    const oldest = OLDEST_THREE[entry]
    shown.revision = String(oldest - 1)
    const message = `Wrinkles of ${entry}: three.js is too old, got "r${oldest - 1}", allowed: r${oldest} or later; npm install three@^0.${oldest}.0`
    expect(() => new Wrinkles(new Mesh(), SET)).toThrow(message)
    for (const tested of [`${oldest}`, `${NEWEST_THREE}`, `${NEWEST_THREE + 1}dev`])
      expect(() => checkThree(entry, tested)).not.toThrow()
  })
})

describe('internals of three.js', () => {
  it('are returned if they exist, including false and 0', () => {
    for (const value of [0, false, '', {}])
      expect(requireInternal(value, 'Wrinkles', 'x', REVISION)).toBe(value)
    for (const value of [null, undefined])
      expect(() => requireInternal(value, 'Wrinkles', 'x', REVISION)).toThrow(found('x'))
  })

  it.each([
    ['init', {}],
    ['transcoderBinary', { init: async () => {} }],
    ['workerSourceURL', { init: async () => {}, transcoderBinary: new ArrayBuffer(0) }],
    [
      'workerPool.setWorkerCreator',
      { init: async () => {}, transcoderBinary: new ArrayBuffer(0), workerSourceURL: 'blob:' },
    ],
  ])('are named if KTX2Loader lacks %s', async (name, internals) => {
    const ktx2Loader = Object.assign(new (class KTX2Loader {})(), {
      workerConfig: { dxtSupported: true },
      ...internals,
    })
    const image = { width: 4, height: 4, channels: 1 as const, srgb: false }
    const bytes = await writeArray({ ...image, names: ['x'], layers: [new Uint8Array(16)] }, 'uastc')
    const parser = {
      options: { ktx2Loader },
      json: {
        textures: [{ extensions: { KHR_texture_basisu: { source: 0 } } }],
        images: [{ bufferView: 0 }],
      },
      getDependency: async () => bytes.slice().buffer,
    }
    await expect(loadMapArray(parser as never, 0, () => {})).rejects.toThrow(found(`KTX2Loader.${name}`))
  })

  it('are named if WebGLRenderer does not have the state of a render target', () => {
    const texture = {} as Texture
    const hasContents = (renderer: object) =>
      quadMaterials.hasContents(renderer as WebGLRenderer, { texture } as never)
    const knowing = (known: object) => ({ properties: { get: () => known } })
    expect(() => hasContents({})).toThrow(found('renderer.properties'))
    expect(hasContents(knowing({}))).toBe(false)
    expect(hasContents(knowing({ __webglTexture: {} }))).toBe(true)
    expect(() => hasContents(knowing({ __renamed: {} }))).toThrow(
      found('__webglTexture of a drawn render target'),
    )
  })

  it('are named if the drawing order of a batch cannot be read', () => {
    const batch = new BatchedMesh(1, 3, 3, new MeshStandardMaterial())
    expect(() => checkBatch(batch)).not.toThrow()
    const { getDrawIndex } = NodeBuilder.prototype as unknown as { getDrawIndex: unknown }
    Object.assign(NodeBuilder.prototype, { getDrawIndex: undefined })
    expect(() => checkBatch(batch)).toThrow(found('NodeBuilder.getDrawIndex'))
    Object.assign(NodeBuilder.prototype, { getDrawIndex })
    Object.assign(batch, { _indirectTexture: undefined })
    expect(() => checkBatch(batch)).toThrow(found('BatchedMesh._indirectTexture'))
    expect(() => new Wrinkles(batch, null as never)).toThrow(found('BatchedMesh._indirectTexture'))
    const { batching_pars_vertex } = ShaderChunk
    ShaderChunk.batching_pars_vertex = ''
    expect(() => instancedVertex('void main() {}', 'batched')).toThrow(
      found('getIndirectIndex in batching_pars_vertex'),
    )
    ShaderChunk.batching_pars_vertex = batching_pars_vertex
  })
})
