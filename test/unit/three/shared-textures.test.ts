import type { Layer } from 'furrow'
import { RedFormat, RGBAFormat, RGFormat } from 'three'
import { describe, expect, it } from 'vitest'
import { createTextures, listTextures } from '../../../packages/furrow/src/three/material/wrinkle-textures.ts'

const gray = (value: number, size = 2) => ({
  width: size,
  height: size,
  data: new Uint8Array(size * size).fill(value),
})
const normal = { width: 2, height: 2, data: new Uint8Array(16).fill(255) }
const layer = (name: string, maps: Partial<Layer>): Layer => ({ name, kind: 'detail', normal, ...maps })

describe('onset on the GPU', () => {
  const onset = gray(51)
  it.each<[string, Partial<Layer>, object, number]>([
    ['alone', {}, { channel: 0 }, RedFormat],
    ['occlusion', { occlusion: gray(10) }, { channel: 1 }, RGFormat],
    ['blood', { blood: gray(20), bloodAmplitude: 1 }, { channel: 1 }, RGFormat],
    [
      'occlusion and blood',
      { occlusion: gray(10), blood: gray(20), bloodAmplitude: 1 },
      { channel: 2 },
      RGBAFormat,
    ],
  ])('shares one texture with: %s', (_, maps, place, format) => {
    const layers = [layer('without', maps), layer('with', { ...maps, onset, onsetStrength: 0.5 })]
    const textures = createTextures(layers, 1)
    expect(listTextures(textures)).toHaveLength(2)
    expect(textures.values.onset).toMatchObject({
      ...place,
      slices: [null, Object.keys(maps).length > 0 ? 1 : 0],
    })
    expect(textures.values.onset!.texture.format).toBe(format)
    expect(textures.onsetStrength.value.toArray()).toEqual([1, 0.5, 1, 1])
  })
})

describe('blood on the GPU', () => {
  it('is stored in the same texture as the occlusion', () => {
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

  it('needs no memory if no layer has it', () => {
    const { values } = createTextures([layer('plain', { occlusion: gray(10) })], 1)
    expect(Object.keys(values)).toEqual(['occlusion'])
    expect((values.occlusion!.texture.image as { data: Uint8Array }).data).toHaveLength(4)
  })
})
