import type { Document } from '@gltf-transform/core'
import { findSkin } from 'furrow-files'
import { describe, expect, test } from 'vitest'
import { BARE_FACES } from '../../bare-faces/bare-faces.ts'
import { skinOf } from './auto-changes.ts'
import { meshOf, plainFace, targetNamesOf } from './auto-variants.ts'
import { toVRoid, VROID_SKIN } from './vroid.ts'

describe('the skin that is taken', () => {
  test.each([
    ['the shipped face', () => plainFace(), 'skin', 'skin'],
    [
      'one in the manner of VRoid Studio',
      async () => {
        const document = await plainFace()
        toVRoid(document)
        return document
      },
      'Face',
      VROID_SKIN,
    ],
    [
      'clothes, eyes and teeth that have all shapes, though they move little or with none that tell',
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
    expect(found.reason).toMatch(/^\d+% of what brows, lids and mouth move$/)
    expect(Number.parseInt(found.reason, 10)).toBeGreaterThan(50)
  })
})

/** Gives a mesh all shapes of the skin, or one; each moves it by a millimetre. */
function lendShapes(document: Document, name: string, only?: string): void {
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
    .setArray(new Float32Array(3 * count).fill(0.0005))
  for (const shape of names)
    primitive!.addTarget(document.createPrimitiveTarget(shape).setAttribute('POSITION', moved))
  mesh.setExtras({ targetNames: names })
}
