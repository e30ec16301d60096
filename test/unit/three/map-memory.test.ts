import type { RgbaImage, WrinkleSet } from 'furrow'
import { updateLayer, Wrinkles, type WrinklesBase } from 'furrow/three'
import { type DataArrayTexture, Mesh, MeshStandardMaterial, PlaneGeometry } from 'three'
import { expect, it } from 'vitest'
import { ReadSet } from '../../../packages/furrow/src/three/check-source.ts'
import { meshOf } from '../../../packages/furrow/src/three/wrinkles-base.ts'

const map = (value: number, channels: number) => ({
  width: 2,
  height: 2,
  data: new Uint8Array(4 * channels).fill(value),
})

const createSet = (): WrinkleSet => ({
  layers: [{ name: 'skin', kind: 'detail', normal: map(255, 4), occlusion: map(200, 1) }],
  areas: [{ name: 'brow', weights: map(255, 1) }],
})

const face = () => new Mesh(new PlaneGeometry(), new MeshStandardMaterial())

/** Returns the texels of the textures for normals and occlusion. */
function texelsOf(wrinkles: WrinklesBase): Uint8Array[] {
  const { normals, values } = meshOf(wrinkles).shaderInputs.textures
  return [normals, values.occlusion!].map(
    ({ texture }) => (texture as DataArrayTexture).image.data as Uint8Array,
  )
}

/** Returns a set with two layers, whose maps share texture arrays. */
const createLayered = (): WrinkleSet => {
  const { layers, areas } = createSet()
  const second = { name: 'pores', kind: 'replace' as const, normal: map(254, 4), occlusion: map(201, 1) }
  return { layers: [...layers, second], areas }
}

it.each([createSet, createLayered])('maps of a file are in memory only once, in their textures', (create) => {
  const set = create()
  const values = set.layers.map(({ normal, occlusion }) => [normal.data[0], occlusion!.data[0]])
  const wrinkles = new Wrinkles(face(), new ReadSet(set))
  const [normals, occlusions] = texelsOf(wrinkles)
  for (const [i, { normal, occlusion }] of set.layers.entries()) {
    expect(normal.data).toEqual(normals.subarray(16 * i, 16 * (i + 1)))
    expect(occlusion!.data).toEqual(occlusions.subarray(4 * i, 4 * (i + 1)))
    expect(normal.data.buffer).toBe(normals.buffer)
    expect(occlusion!.data.buffer).toBe(occlusions.buffer)
    expect([normal.data[0], occlusion!.data[0]]).toEqual(values[i])
  }
  wrinkles.dispose()
})

it.each([createSet, createLayered])(
  'maps of a set that a page made are copied, and the page can change its own',
  (create) => {
    const set = create()
    const images = set.layers.flatMap(({ normal, occlusion }) => [normal, occlusion!])
    const given = images.map(({ data }) => data)
    const wrinkles = new Wrinkles(face(), set)
    for (const [i, { data }] of images.entries()) {
      expect(data).toBe(given[i])
      data.fill(1)
    }
    expect(texelsOf(wrinkles).map(([first]) => first)).toEqual([255, 200])
    updateLayer(wrinkles, 'skin', { normal: map(128, 4), occlusion: map(100, 1) })
    expect(texelsOf(wrinkles).map(([first]) => first)).toEqual([128, 100])
    expect(images.every(({ data }) => data.every((value) => value === 1))).toBe(true)
    wrinkles.dispose()
  },
)

it('an image shared by two layers does not change when one of them does', () => {
  const { layers, areas } = createLayered()
  for (const layer of layers) layer.normal = layers[0].normal
  const wrinkles = new Wrinkles(face(), new ReadSet({ layers, areas }))
  updateLayer(wrinkles, 'pores', { normal: map(128, 4) })
  const { textures } = meshOf(wrinkles).shaderInputs
  expect(textures.layers.map(({ normal }) => (normal as RgbaImage).data[0])).toEqual([255, 128])
  updateLayer(wrinkles, 'skin', { normal: map(64, 4) })
  expect(textures.layers.map(({ normal }) => (normal as RgbaImage).data[0])).toEqual([64, 128])
  wrinkles.dispose()
})
