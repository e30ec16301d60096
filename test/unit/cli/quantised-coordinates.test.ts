import { readFileSync } from 'node:fs'
import { skinOf } from 'furrow/internal'
import { addFlatNormalMap, facesOf, readMeshes } from 'furrow/internal/three'
import { findSkin } from 'furrow-files'
import type { Mesh } from 'three'
import { beforeAll, expect, it } from 'vitest'
import { decodeGlb } from '../../../packages/files/src/gltf/glb-file.ts'
import { quantisedCoordinates } from '../../../packages/files/src/pack/flat-normal.ts'
import { jsonOf } from '../../glb.ts'
import { loadInNode } from '../three/node-loader.ts'
import { quantiseCoordinates } from './auto-changes.ts'
import { anyIO, plainFace } from './auto-variants.ts'
import { AREAS, Workshop } from './workshop.ts'

const shop = new Workshop()
let plain: number[]
let bytes: Uint8Array

beforeAll(async () => {
  const document = await plainFace()
  plain = [...Array.from(findSkin(document, 'face.glb', 'test', 'skin').skin.uvs)]
  quantiseCoordinates(document)
  bytes = await (await anyIO()).writeBinary(document)
})

/** Returns the largest difference from the texture coordinates of the unchanged face. */
const apart = (uvs: ArrayLike<number>) =>
  plain.reduce((most, value, i) => Math.max(most, Math.abs(value - uvs[i]!)), 0)

it('quantised texture coordinates are read with the transform of the base colour, if no other map has one', async () => {
  const { skin } = findSkin(await (await anyIO()).readBinary(bytes), 'face.glb', 'test', 'skin')
  expect(skin.uvs).toHaveLength(plain.length)
  expect(apart(skin.uvs)).toBeLessThan(1 / 4000)
})

it('three.js reads them through a flat normal map with the same transform', async () => {
  const gltf = await loadInNode(bytes)
  const face = facesOf(gltf, gltf.parser).find(([{ name }]) => name === 'skin')!
  addFlatNormalMap(face)
  const { normalMap, map } = face[0].material as Mesh['material'] & Record<'normalMap' | 'map', never>
  expect(normalMap).toMatchObject({ repeat: (map as { repeat: object }).repeat })
  expect(apart(skinOf(readMeshes(face)).uvs)).toBeLessThan(1 / 4000)
})

it('a file that gets wrinkles also gets a flat normal map with this transform', async () => {
  const folder = await shop.makeFolder('set')
  shop.write('set/face.glb', bytes)
  await shop.run('pack', folder, '--mesh', 'skin', '-o', shop.path('out.glb'))
  const { materials } = jsonOf(readFileSync(shop.path('out.glb')))
  const { normalTexture, pbrMetallicRoughness, extensions } = materials.find(
    ({ extensions }: { extensions?: object }) => extensions && 'FURROW_wrinkle_maps' in extensions,
  )
  expect(normalTexture.extensions).toEqual(pbrMetallicRoughness.baseColorTexture.extensions)
  expect(extensions.FURROW_wrinkle_maps.areas).toHaveLength(AREAS.length)
})

it('float coordinates are used as they are', () => {
  const { json } = decodeGlb(bytes, 'face.glb', 'test')
  const skin = json.meshes!.find(({ name }) => name === 'skin')!.primitives[0]!
  expect(quantisedCoordinates(json, skin.material!)).toBeDefined()
  const accessor = json.accessors![skin.attributes!.TEXCOORD_0!] as { componentType: number }
  accessor.componentType = 5126
  expect(quantisedCoordinates(json, skin.material!)).toBeUndefined()
})
