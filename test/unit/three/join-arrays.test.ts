import type { Area, ArraySlice, Layer } from 'furrow'
import { CompressedArrayTexture, LinearFilter, LinearMipmapLinearFilter, RGBA_BPTC_Format } from 'three'
import { describe, expect, it } from 'vitest'
import { joinArrays } from '../../../packages/furrow/src/three/loader/join-arrays.ts'

/** Texture array with levels of 8 x 8 and 4 x 4 texels. The bytes of its blocks are all the same. */
function array(depth: number, value: number, size = 8): CompressedArrayTexture {
  const level = (side: number, offset: number) => {
    const blocks = (side / 4) ** 2
    const data = new Uint8Array(16 * blocks * depth)
    for (let slice = 0; slice < depth; slice++) {
      data.fill(value + 10 * slice + offset, 16 * blocks * slice, 16 * blocks * (slice + 1))
    }
    return { data, width: side, height: side }
  }
  const texture = new CompressedArrayTexture(
    [level(size, 0), level(size / 2, 1)],
    size,
    size,
    depth,
    RGBA_BPTC_Format,
  )
  texture.minFilter = LinearMipmapLinearFilter
  texture.magFilter = LinearFilter
  return texture
}

const slice = (of: CompressedArrayTexture, index = 0, channel = 0): ArraySlice => ({
  array: of,
  slice: index,
  channel,
})
const layer = (name: string, maps: Partial<Layer<ArraySlice>>): Layer<ArraySlice> => ({
  name,
  kind: 'detail',
  normal: slice(array(1, 0)),
  ...maps,
})
const area = (name: string, weights: Area<ArraySlice>['weights']): Area<ArraySlice> => ({ name, weights })

describe('joinArrays', () => {
  it('joins compressed images of one kind into an array, level by level and in order', () => {
    const [first, second] = [array(1, 100), array(2, 200)]
    const { layers, areas } = joinArrays({
      layers: [layer('a', {})],
      areas: [
        area('one', slice(first, 0, 3)),
        area('two', slice(second, 1, 2)),
        area('three', slice(second, 0, 1)),
        area('four', slice(first, 0, 0)),
      ],
    })
    const weights = areas.map((joinedArea) => joinedArea.weights as ArraySlice)
    const [joined] = weights.map((weight) => weight.array as CompressedArrayTexture)
    expect(weights.every((weight) => weight.array === joined)).toBe(true)
    expect(weights.map((weight) => [weight.slice, weight.channel])).toEqual([
      [0, 3],
      [2, 2],
      [1, 1],
      [0, 0],
    ])
    expect(joined.image).toMatchObject({ width: 8, height: 8, depth: 3 })
    const values = joined.mipmaps.map(({ data, width }) => {
      const blocks = 16 * (width / 4) ** 2
      return [0, 1, 2].map((index) => [
        ...new Set((data as Uint8Array).subarray(index * blocks, (index + 1) * blocks)),
      ])
    })
    expect(values).toEqual([
      [[100], [200], [210]],
      [[101], [201], [211]],
    ])
    expect(joined).toMatchObject({ minFilter: LinearMipmapLinearFilter, format: RGBA_BPTC_Format })
    expect(layers[0].normal).toMatchObject({ slice: 0 })
  })

  it('joins an array of occlusion and roughness only once, and keeps single arrays and images', () => {
    const [normals, orm, other] = [array(2, 0), array(1, 50), array(1, 60)]
    const image = { width: 1, height: 1, data: new Uint8Array(4) }
    const { layers } = joinArrays({
      layers: [
        layer('a', {
          normal: slice(normals, 1),
          roughness: slice(orm, 0, 1),
          occlusion: slice(orm),
          baseColor: image,
        }),
        layer('b', { normal: slice(normals, 0), roughness: slice(other, 0, 1), occlusion: slice(other) }),
        layer('c', { normal: slice(normals, 0) }),
      ],
      areas: [],
    })
    const [a, b, c] = layers as Layer<ArraySlice>[]
    expect(a.normal).toEqual(slice(normals, 1))
    expect(a.baseColor).toBe(image)
    expect((a.roughness as ArraySlice).array).toBe((b.occlusion as ArraySlice).array)
    expect(b.roughness).toMatchObject({ slice: 1, channel: 1 })
    expect(b.occlusion).toMatchObject({ slice: 1, channel: 0 })
    expect(c).not.toHaveProperty('roughness')
  })

  it('refuses maps of one kind that differ in size or levels', () => {
    const layerOf = (normal: CompressedArrayTexture) => layer('b', { normal: slice(normal) })
    const joining = (normal: CompressedArrayTexture) => () =>
      joinArrays({ layers: [layer('a', {}), layerOf(normal)], areas: [] })
    expect(joining(array(1, 0, 16))).toThrow(/normal maps with different layouts, got .*16 x 16.*8 x 8/)
    const flat = array(1, 0)
    flat.mipmaps.pop()
    expect(joining(flat)).toThrow(/1 levels.*2 levels/)
    expect(joining(array(1, 0))).not.toThrow()
  })
})
