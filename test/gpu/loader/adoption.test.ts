import { wrinklesOf } from 'furrow/three'
import { Group, type Material } from 'three'
import { describe, expect, it } from 'vitest'
import { largestDifference, ROUNDING } from '../difference.ts'
import { harnessOn, RENDERERS } from '../harness.ts'
import { litPicture, loadFile, pageMesh } from '../loaded.ts'
import { faceMeshes, wrinkledFile } from '../wrinkled-file.ts'

describe.each(RENDERERS)('a mesh that a page makes with the material of a loaded face, on %s', (name) => {
  const harness = harnessOn(name)

  const load = async () => loadFile(harness, await wrinkledFile())
  const picture = (root: Group) => litPicture(harness, root)
  /** Renders the loaded face at a blendshape weight, to compare with. */
  const expected = async (weight: number) => {
    const gltf = await load()
    for (const mesh of faceMeshes(gltf.scene)) mesh.morphTargetInfluences![0] = weight
    return picture(gltf.scene)
  }

  it('wrinkles as the loaded face from the first frame on, if both share their blendshape weights', async () => {
    const gltf = await load()
    const [face] = wrinklesOf(gltf)
    const loaded = faceMeshes(gltf.scene)
    const meshes = loaded.map((mesh) => pageMesh(mesh, mesh.morphTargetInfluences!))
    for (const mesh of meshes) mesh.morphTargetInfluences![0] = 1
    expect(meshes.map((mesh) => wrinklesOf(mesh))).toEqual([face, face])
    const root = new Group().add(...meshes)
    expect(largestDifference(await picture(root), await expected(1))).toBeLessThan(ROUNDING)
    expect(face.getActivation('a')).toBe(1)
    for (const mesh of meshes) mesh.morphTargetInfluences![0] = 0
    expect(largestDifference(await picture(root), await expected(0))).toBeLessThan(ROUNDING)
    face.dispose()
    expect(wrinklesOf(meshes[0])).toBeUndefined()
  })

  it('wrinkles independently if it has its own weights, until it is removed', async () => {
    const gltf = await load()
    const [face] = wrinklesOf(gltf)
    const loaded = faceMeshes(gltf.scene)
    const meshes = loaded.map((mesh) => pageMesh(mesh, [1]))
    const root = new Group().add(...meshes)
    await picture(root)
    const shared = loaded[0].material
    expect(largestDifference(await picture(root), await expected(1))).toBeLessThan(ROUNDING)
    expect(meshes.map((mesh) => wrinklesOf(mesh)!.getActivation('a'))).toEqual([1, 1])
    expect(face.getActivation('a')).toBe(0)
    // React does this when a property changes and changes back.
    const own = meshes[0].material
    meshes[0].material = shared
    await picture(root)
    expect(meshes[0].material).toBe(own)
    root.clear()
    expect(meshes.map((mesh) => wrinklesOf(mesh))).toEqual([undefined, undefined])
    expect(meshes[0].material).toBe(shared)
    root.add(...meshes)
    await picture(root)
    expect(largestDifference(await picture(root), await expected(1))).toBeLessThan(ROUNDING)
    root.clear()
  })

  it('wrinkles with a copy of the material, and can be removed and added again', async () => {
    const gltf = await load()
    const meshes = faceMeshes(gltf.scene).map((mesh) =>
      pageMesh(mesh, [1], (mesh.material as Material).clone()),
    )
    const root = new Group().add(...meshes)
    await picture(root)
    expect(largestDifference(await picture(root), await expected(1))).toBeLessThan(ROUNDING)
    root.clear()
    expect(wrinklesOf(meshes[0])).toBeUndefined()
    root.add(...meshes)
    await picture(root)
    expect(largestDifference(await picture(root), await expected(1))).toBeLessThan(ROUNDING)
    root.clear()
  })
})
