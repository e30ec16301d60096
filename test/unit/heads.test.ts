import { readFile } from 'node:fs/promises'
import { type Document, Logger, NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { beforeAll, beforeEach, expect, test } from 'vitest'
import {
  decimate,
  foldUvs,
  keepTargets,
  placeScene,
  removeMeshes,
  removeNames,
  renameTargets,
  swapSides,
} from '../heads.ts'

const io = new NodeIO().setLogger(new Logger(Logger.Verbosity.SILENT)).registerExtensions(ALL_EXTENSIONS)
let bytes: Uint8Array
let document: Document

beforeAll(async () => {
  bytes = await readFile(new URL('../../faces/human.glb', import.meta.url))
})

beforeEach(async () => {
  document = await io.readBinary(bytes)
})

const meshes = () => document.getRoot().listMeshes()
const namesOf = (mesh: string) =>
  meshes()
    .find((one) => one.getName() === mesh)!
    .getExtras().targetNames as string[]
const skinOf = () =>
  meshes()
    .find((one) => one.getName() === 'skin')!
    .listPrimitives()[0]!

test('renamed blendshapes have one name on all meshes, also after writing and reading', async () => {
  const [skin, eye] = [namesOf('skin'), namesOf('eye-left')]
  removeNames(document)
  document = await io.readBinary(await io.writeBinary(document))
  expect(namesOf('skin')).toEqual(skin.map((_, i) => `target_${i}`))
  expect(namesOf('eye-left')).toEqual(eye.map((name) => `target_${skin.indexOf(name)}`))
})

test('names swap their sides, and names without a side stay', () => {
  const before = namesOf('skin')
  swapSides(document)
  expect(namesOf('skin')[before.indexOf('eyeBlinkLeft')]).toBe('eyeBlinkRight')
  expect(namesOf('skin')[before.indexOf('jawOpen')]).toBe('jawOpen')
})

test('blendshapes are removed with their offsets', () => {
  const names = namesOf('skin')
  const smile = skinOf().listTargets()[names.indexOf('mouthSmileLeft')]
  keepTargets(document, (name) => name.startsWith('mouthSmile'))
  expect(namesOf('skin')).toEqual(['mouthSmileLeft', 'mouthSmileRight'])
  expect(skinOf().listTargets()).toHaveLength(2)
  expect(skinOf().listTargets()[0]).toBe(smile)
})

test('all meshes are moved below the mirrored node', () => {
  const node = placeScene(document, { scale: [-1, 1, 1] })
  const [scene] = document.getRoot().listScenes()
  expect(scene!.listChildren()).toEqual([node])
  expect(node.listChildren()).toHaveLength(meshes().length)
  expect(node.getWorldMatrix()[0]).toBe(-1)
})

test('eyes are removed, and a mesh with fewer vertices keeps all blendshapes', async () => {
  removeMeshes(document, /^eye-/)
  expect(meshes().map((mesh) => mesh.getName())).not.toContain('eye-left')
  const [before, shapes] = [skinOf().getAttribute('POSITION')!.getCount(), skinOf().listTargets().length]
  await decimate(document, 0.3)
  expect(skinOf().getAttribute('POSITION')!.getCount()).toBeLessThan(0.6 * before)
  expect(skinOf().listTargets()).toHaveLength(shapes)
})

test('both halves use the same texels', () => {
  const uvs = skinOf().getAttribute('TEXCOORD_0')!
  const before = Array.from({ length: uvs.getCount() }, (_, i) => uvs.getElement(i, [0, 0]))
  foldUvs(document)
  for (const [i, [u, v]] of before.entries())
    expect(uvs.getElement(i, [])).toEqual([u < 0.5 ? expect.closeTo(1 - u, 6) : u, v])
})

test('names follow a rule', () => {
  renameTargets(document, (name) => `CTRL_${name}`)
  expect(namesOf('skin')[0]).toMatch(/^CTRL_eye/)
})
