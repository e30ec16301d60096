import type { Document } from '@gltf-transform/core'
import { findSkin } from 'furrow-files'
import { describe, expect, test } from 'vitest'
import { BARE_FACES } from '../../bare-faces/bare-faces.ts'
import { skinOf } from './auto-changes.ts'
import { meshOf, plainFace, targetNamesOf } from './auto-variants.ts'
import { toVRoid, VROID_SKIN } from './vroid.ts'

describe('the chosen skin', () => {
  test.each([
    ['the shipped face', () => plainFace(), 'skin', 'skin'],
    [
      "a face like VRoid Studio's",
      async () => {
        const document = await plainFace()
        toVRoid(document)
        return document
      },
      'Face',
      VROID_SKIN,
    ],
    [
      'a face whose clothes, eyes and teeth have many shapes too',
      async () => {
        const document = await plainFace()
        for (const name of ['eye-left', 'teeth-lower', 'brows', 'lashes']) lendShapes(document, name)
        lendShapes(document, 'shirt', 'jawOpen')
        return document
      },
      'skin',
      'skin',
    ],
    ...BARE_FACES.map(({ name, path, material }) => [name, () => plainFace(path), 'face', material] as const),
  ] as const)('is that of %s', async (_, read, mesh, material) => {
    const found = findSkin(await read(), 'face.glb', 'test')
    expect([found.meshName, found.materialName]).toEqual([mesh, material])
    expect(found.reason).toMatch(/^\d+% of the motion of brows, lids and mouth$/)
    expect(Number.parseInt(found.reason, 10)).toBeGreaterThan(50)
  })

  test('is identified by indices if mesh and material have no names', async () => {
    const document = await plainFace()
    for (const named of [...document.getRoot().listMeshes(), ...document.getRoot().listMaterials()])
      named.setName('')
    const found = findSkin(document, 'face.glb', 'test')
    expect([found.meshName, found.materialName]).toEqual([String(found.mesh), String(found.material)])
  })
})

describe('the skin of a face with unknown shape names', () => {
  const unnamed = async (isKept = (_: string) => true) => {
    const document = await plainFace()
    for (const mesh of document.getRoot().listMeshes()) {
      const names = mesh.getExtras().targetNames as string[] | undefined
      if (!names) continue
      for (const primitive of mesh.listPrimitives())
        for (const [i, target] of primitive.listTargets().entries())
          if (!isKept(names[i]!)) primitive.removeTarget(target)
      mesh.setExtras({ targetNames: names.filter(isKept).map((_, i) => `shape ${i}`) })
    }
    return document
  }
  /** Returns the face with meaningless names, and without the shapes by whose motion a face is recognised. */
  const unrecognised = () => unnamed((name) => /^(jaw|mouth(Funnel|Pucker))/.test(name))
  const find = (document: Document) => {
    const { meshName, reason } = findSkin(document, 'face.glb', 'test')
    return [meshName, reason.replace(/^\d+% of the motion of /, '')]
  }

  test('is the mesh that shapes of brows, lids and mouth move', async () => {
    const document = await unnamed()
    lendShapes(document, 'shirt', 'shape 99', 0.1)
    expect(find(document)).toEqual(['skin', 'brows, lids and mouth'])
  })

  test('is not clothes, even if body sliders move them most', async () => {
    const document = await unrecognised()
    for (const name of ['Fat', 'male', 'female']) lendShapes(document, 'shirt', name, 0.1)
    expect(find(document)).toEqual(['skin', 'all meshes by blendshapes'])
  })

  test('is the mesh on the head joint, even if another mesh moves more', async () => {
    const document = await unrecognised()
    lendShapes(document, 'shirt', 'shape 99', 0.1)
    skinTo(document, 'skin', 'mixamorig:Head')
    skinTo(document, 'shirt', 'mixamorig:Hips')
    expect(find(document)).toEqual(['skin', 'the head by blendshapes'])
  })

  test('is never a mesh whose name or material means clothes', async () => {
    const document = await unrecognised()
    lendShapes(document, 'shirt', 'shape 99', 0.012)
    expect(find(document)).toEqual(['skin', 'all meshes by blendshapes'])
  })
})

/** Skins a mesh to a joint with this name. */
function skinTo(document: Document, name: string, joint: string): void {
  const mesh = meshOf(document, name)
  const node = document
    .getRoot()
    .listNodes()
    .find((one) => one.getMesh() === mesh)!
  const bone = document.createNode(joint)
  node.setSkin(document.createSkin().addJoint(bone))
  for (const primitive of mesh.listPrimitives()) {
    const count = primitive.getAttribute('POSITION')!.getCount()
    const weights = Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0))
    const accessor = (array: Float32Array<ArrayBuffer> | Uint8Array<ArrayBuffer>) =>
      document.createAccessor().setType('VEC4').setArray(array)
    primitive.setAttribute('JOINTS_0', accessor(new Uint8Array(4 * count)))
    primitive.setAttribute('WEIGHTS_0', accessor(weights))
  }
}

/** Gives a mesh blendshapes with the names of one or all shapes of the skin. Each moves the complete mesh by `distance`, metres. */
function lendShapes(document: Document, name: string, only?: string, distance = 0.0005): void {
  const mesh = meshOf(document, name)
  const names = only ? [only] : targetNamesOf(skinOf(document))
  const [primitive] = mesh.listPrimitives()
  const count = primitive!.getAttribute('POSITION')!.getCount()
  if (!primitive!.getAttribute('TEXCOORD_0')) {
    const uvs = Float32Array.from({ length: 2 * count }, (_, i) => (i % 7) / 7)
    primitive!.setAttribute('TEXCOORD_0', document.createAccessor().setType('VEC2').setArray(uvs))
  }
  for (const target of primitive!.listTargets()) primitive!.removeTarget(target)
  const moved = document
    .createAccessor()
    .setType('VEC3')
    .setArray(new Float32Array(3 * count).fill(distance))
  for (const shape of names)
    primitive!.addTarget(document.createPrimitiveTarget(shape).setAttribute('POSITION', moved))
  mesh.setExtras({ targetNames: names })
}
