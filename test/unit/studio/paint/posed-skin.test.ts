import { type Mesh, Ray, Vector3 } from 'three'
import { expect, it } from 'vitest'
import { LineSkin } from '../../../../studio/src/lines/line-skin.ts'
import { posedSkinOf } from '../../../../studio/src/paint/posed-skin.ts'
import { plainSheet } from './skins.ts'

const SCALE = 1000

it('painting and lines read the skin of an avatar once', () => {
  const meshes: [Mesh] = [plainSheet()]
  const { skin, picker } = posedSkinOf(meshes, SCALE)
  expect(new LineSkin(meshes, { scale: SCALE, areaSize: 64 }).picker).toBe(picker)
  expect(posedSkinOf(meshes, SCALE).skin).toBe(skin)
  expect(posedSkinOf([...meshes], SCALE).skin).not.toBe(skin)
})

it('another scale of the face is another skin', () => {
  const meshes: [Mesh] = [plainSheet()]
  const [metres, half] = [SCALE, SCALE / 2].map((scale) => posedSkinOf(meshes, scale).skin.surface.points[0])
  expect(half).toBeCloseTo(metres / 2, 6)
})

it('a skin that was read before has the present pose', () => {
  const mesh = plainSheet()
  const meshes: [Mesh] = [mesh]
  posedSkinOf(meshes, SCALE)
  mesh.position.y = 0.2
  const { picker } = posedSkinOf(meshes, SCALE)
  const hit = picker.pick(new Ray(new Vector3(0.01, 0.22, 5), new Vector3(0, 0, -1)))
  expect(hit?.position[1]).toBeCloseTo(20, 4)
})
