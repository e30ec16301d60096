import { Wrinkles, wrinklesOf } from 'furrow/three'
import { Mesh, MeshStandardMaterial, PlaneGeometry } from 'three'
import { expect, test } from 'vitest'

test('wrinklesOf finds the wrinkles that a page has moved to another material', () => {
  const mesh = new Mesh(new PlaneGeometry(), new MeshStandardMaterial())
  const flat = { width: 2, height: 2, data: new Uint8Array(16).fill(128) }
  const weights = { width: 2, height: 2, data: new Uint8Array(4).fill(255) }
  const first = new Wrinkles(mesh, {
    layers: [{ name: 'layer', kind: 'replace', normal: flat }],
    areas: [{ name: 'area', weights }],
  })
  expect(wrinklesOf(mesh)).toBe(first)
  mesh.material = new MeshStandardMaterial()
  const moved = new Wrinkles(mesh, first)
  first.dispose()
  expect(wrinklesOf(mesh)).toBe(moved)
  moved.dispose()
  expect(wrinklesOf(mesh)).toBeUndefined()
})
