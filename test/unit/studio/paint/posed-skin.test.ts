import { Bone, Group, type Mesh, Ray, Skeleton, SkinnedMesh, Vector3 } from 'three'
import { expect, it, vi } from 'vitest'
import { LineSkin } from '../../../../studio/src/lines/line-skin.ts'
import { posedSkinOf } from '../../../../studio/src/paint/posed-skin.ts'
import { PoseWatch } from '../../../../studio/src/viewer/pose/pose-watch.ts'
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

it('a face that rests is not read again, nor one whose pose comes again', () => {
  const mesh = plainSheet()
  mesh.morphTargetInfluences = [0, 0]
  const meshes: [Mesh] = [mesh]
  const posed = posedSkinOf(meshes, SCALE)
  const refit = vi.spyOn(posed.picker, 'refit').mockReturnValue()
  const lines = new LineSkin(meshes, { scale: SCALE, areaSize: 64 })
  posedSkinOf(meshes, SCALE)
  lines.follow()
  expect(refit).not.toHaveBeenCalled()
  mesh.morphTargetInfluences[1] = 0.5
  lines.follow()
  posedSkinOf(meshes, SCALE)
  expect(refit).toHaveBeenCalledTimes(1)
})

it('joints, parents, blendshapes that are added and muscles that change are another pose', () => {
  const plain = plainSheet()
  const mesh = new SkinnedMesh(plain.geometry, plain.material)
  const bone = new Bone()
  const parent = new Group()
  parent.add(bone.add(mesh))
  mesh.bind(new Skeleton([bone]))
  const watch = new PoseWatch([mesh])
  const offsets = mesh.geometry.attributes.position.clone()
  const changes: (() => void)[] = [
    () => bone.rotateX(0.1),
    () => parent.position.set(0, 0, 1),
    () => {
      mesh.morphTargetInfluences = [0.3]
    },
    () => {
      mesh.geometry.morphAttributes.position = [offsets]
    },
    () => {
      offsets.needsUpdate = true
    },
  ]
  expect(watch.isNew()).toBe(true)
  for (const change of changes) {
    expect(watch.isNew()).toBe(false)
    change()
    expect(watch.isNew()).toBe(true)
  }
})
