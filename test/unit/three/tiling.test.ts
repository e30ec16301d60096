import { Mesh, MeshStandardMaterial, PlaneGeometry, Texture } from 'three'
import { expect, test } from 'vitest'
import { isTiled } from '../../../packages/furrow/src/three/mesh/tiling.ts'

test('a mesh is tiled if the transform of the normal map puts texture coordinates outside 0..1', () => {
  const material = new MeshStandardMaterial({ normalMap: new Texture() })
  const mesh = new Mesh(new PlaneGeometry(), material)
  expect(isTiled(mesh, material)).toBe(false)
  material.normalMap!.offset.set(0, 0.1)
  expect(isTiled(mesh, material)).toBe(true)
  material.normalMap!.repeat.set(1, 0.9)
  expect(isTiled(mesh, material)).toBe(false)
})
