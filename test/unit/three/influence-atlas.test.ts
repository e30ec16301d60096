import { FloatType, HalfFloatType, type WebGLRenderer } from 'three'
import { expect, test } from 'vitest'
import { InfluenceAtlas } from '../../../packages/furrow/src/three/atlas/influence-atlas.ts'
import { quadMaterials } from '../../../packages/furrow/src/three/webgl/influence/influence-quads.ts'

const ALL = ['OES_texture_float_linear', 'EXT_float_blend', 'float32-filterable', 'float32-blendable']

/** Returns a stub of a renderer that supports these features. */
function stub(features: readonly string[], isWebGPUBackend: boolean) {
  const has = (name: string) => features.includes(name)
  return {
    backend: { isWebGPUBackend },
    hasFeature: has,
    getContext: () => ({ getExtension: (name: string) => (has(name) ? {} : null) }),
    properties: { get: () => ({ __webglTexture: true }) },
  } as unknown as WebGLRenderer
}

test.each([false, true])(
  'sums are 32-bit floats if the renderer can filter and blend them, on WebGPU: %s',
  (isWebGPU) => {
    const typeOf = (layers: number, features: readonly string[]) => {
      const atlas = new InfluenceAtlas(8, 8, layers, quadMaterials)
      atlas.collect([], stub(features, isWebGPU))
      return atlas.target.texture.type
    }
    expect([1, 2, 3, 4].map((layers) => typeOf(layers, ALL))).toEqual([
      FloatType,
      FloatType,
      HalfFloatType,
      HalfFloatType,
    ])
    for (const missing of isWebGPU ? ALL.slice(2) : ALL.slice(0, 2)) {
      const others = ALL.filter((name) => name !== missing)
      expect(typeOf(1, others), missing).toBe(HalfFloatType)
    }
  },
)

test('a renderer that cannot filter 32-bit floats gets half floats, also after one that can', () => {
  const atlas = new InfluenceAtlas(8, 8, 1, quadMaterials)
  let freed = 0
  atlas.target.addEventListener('dispose', () => freed++)
  atlas.collect([], stub(ALL, false))
  atlas.collect([], stub([], false))
  expect(atlas.target.texture.type).toBe(HalfFloatType)
  expect(freed).toBe(2)
})
