import type { Layer } from 'furrow'
import { RGFormat } from 'three'
import { describe, expect, it } from 'vitest'
import { createTextures, listTextures } from '../../../packages/furrow/src/three/material/wrinkle-textures.ts'

const gray = (value: number, size = 2) => ({
  width: size,
  height: size,
  data: new Uint8Array(size * size).fill(value),
})
const normal = { width: 2, height: 2, data: new Uint8Array(16).fill(255) }
const layer = (name: string, maps: Partial<Layer>): Layer => ({ name, kind: 'detail', normal, ...maps })

describe('blood on the GPU', () => {
  it('shares its texture with the occlusion', () => {
    const layers = [
      layer('both', { occlusion: gray(10), blood: gray(200), bloodAmplitude: 0.25 }),
      layer('neither', {}),
      layer('blood', { blood: gray(100), bloodAmplitude: 0.5 }),
    ]
    const textures = createTextures(layers, 1)
    const { occlusion, blood } = textures.values
    expect(listTextures(textures)).toEqual([textures.normals.texture, occlusion!.texture])
    expect(blood!.texture).toBe(occlusion!.texture)
    expect(blood).toMatchObject({ slices: [0, null, 1], channel: 1 })
    expect(occlusion).toMatchObject({ slices: [0, null, null], channel: 0 })
    expect(occlusion!.texture.format).toBe(RGFormat)
    expect(textures.bloodAmplitude.value.toArray()).toEqual([0.25, 0, 0.5, 1])
  })

  it('costs nothing if missing', () => {
    const { values } = createTextures([layer('plain', { occlusion: gray(10) })], 1)
    expect(Object.keys(values)).toEqual(['occlusion'])
    expect((values.occlusion!.texture.image as { data: Uint8Array }).data).toHaveLength(4)
  })
})
