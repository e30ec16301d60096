import type { WrinkleSet } from 'furrow'
import { updateLayer, Wrinkles } from 'furrow/three'
import { type DataArrayTexture, Mesh, MeshStandardMaterial, PlaneGeometry } from 'three'
import { expect, it } from 'vitest'
import { WebGLWrinkles } from '../../../packages/furrow/src/three/webgl/webgl-wrinkles.ts'
import type { WrinklesBase } from '../../../packages/furrow/src/three/wrinkles-base.ts'

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

/** The texels of its textures of normals and occlusion. */
function texelsOf(wrinkles: WrinklesBase): Uint8Array[] {
  const { normals, values } = wrinkles.editable('test').inputs.textures
  return [normals, values.occlusion!].map(
    ({ texture }) => (texture as DataArrayTexture).image.data as Uint8Array,
  )
}

it('maps of a file are in memory once, those of their textures', () => {
  const set = createSet()
  const wrinkles = new WebGLWrinkles(face(), set)
  const [{ normal, occlusion }] = set.layers
  const [normals, occlusions] = texelsOf(wrinkles)
  expect(normals).toBe(normal.data)
  expect(occlusions).toBe(occlusion!.data)
  wrinkles.dispose()
})

it('maps of a set that a page made remain its own', () => {
  const set = createSet()
  const wrinkles = new Wrinkles(face(), set)
  const [{ normal, occlusion }] = set.layers
  normal.data.fill(1)
  occlusion!.data.fill(1)
  expect(texelsOf(wrinkles).map(([first]) => first)).toEqual([255, 200])
  updateLayer(wrinkles, 'skin', { normal: map(128, 4), occlusion: map(100, 1) })
  expect(texelsOf(wrinkles).map(([first]) => first)).toEqual([128, 100])
  expect([normal.data[0], occlusion!.data[0]]).toEqual([1, 1])
  wrinkles.dispose()
})
