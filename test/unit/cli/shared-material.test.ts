import { readFileSync } from 'node:fs'
import { readWrinkleMaps } from 'furrow/three'
import { beforeAll, describe, expect, it, test } from 'vitest'
import { drivenFaces } from '../../../packages/furrow/src/runtime/file/driven-faces.ts'
import { findSkins, indexOfSkin, skinOfDocument } from '../../../studio/src/open/skins.ts'
import { STRAIGHT } from '../../drivers.ts'
import { editGlb } from '../../glb.ts'
import { loadInNode } from '../three/node-loader.ts'
import { faceBytes, Workshop } from './workshop.ts'

const shop = new Workshop()
const read = (name: string) => readFileSync(shop.path(name))

/** Makes a file with eyes, a head and hands that share a material. Only the head has the blendshape that the driver reads. */
async function sharedFace(): Promise<Uint8Array> {
  return editGlb(await faceBytes(['eyes', 'head', 'hands']), ({ meshes, materials }) => {
    materials[0].name = 'skin'
    for (const { primitives } of meshes) primitives[0].material = 0
    meshes[0].extras.targetNames = ['eyeLookUpLeft']
    delete meshes[2].primitives[0].targets
    delete meshes[2].extras
  })
}

describe('a material that a head shares with eyes and hands', () => {
  beforeAll(async () => {
    const folder = await shop.makeFolder('set')
    shop.write('set/face.glb', await sharedFace())
    shop.json('set/wrinkles.json', {
      version: 1,
      mesh: 'head',
      layers: [{ name: 'age', kind: 'replace', normal: 'layers/age/normal.png' }],
      areas: [{ name: 'brow', image: 'areas/brow.png' }],
      drivers: [
        { type: 'morph', area: 'brow', targets: [{ name: 'browInnerUp' }], rule: 'sum', curve: STRAIGHT },
      ],
    })
    await shop.run('pack', folder, '-o', shop.path('packed.glb'))
  })

  it('shows wrinkles only on the head when three.js loads it', async () => {
    const faces = await readWrinkleMaps(await loadInNode(read('packed.glb')))
    expect(faces.map(({ meshes }) => meshes.map(({ name }) => name))).toEqual([['head']])
  })

  it('is unpacked for the head, and so are its activations', async () => {
    await shop.run('unpack', shop.path('packed.glb'), '-o', shop.path('unpacked'))
    expect(JSON.parse(String(read('unpacked/wrinkles.json')))).toMatchObject({
      mesh: 'head',
      material: 'skin',
    })
    const printed = await shop.output('activations', shop.path('packed.glb'), '--set', 'browInnerUp=1')
    expect(printed).toContain('1.000  brow')
  })

  it('opens in the studio on the head, also from a project', async () => {
    const skins = await findSkins(await loadInNode(read('packed.glb')), expect.fail)
    expect(skins.map(({ target }) => target.mesh)).toEqual(['eyes', 'head', 'hands'])
    const skin = indexOfSkin(skins)
    expect(skins[skin]!.name).toBe('head')
    expect(skinOfDocument({ skins, skin: 0 }, skins[skin]!.target)).toBe(skin)
  })
})

const morph = (...names: string[]) => [
  {
    type: 'morph' as const,
    area: 'a',
    targets: names.map((name) => ({ name })),
    rule: 'sum' as const,
    curve: STRAIGHT,
  },
]

test.each([
  ['the one with most driving shapes, first', { eye: ['a'], head: ['a', 'b', 'c'] }, ['head']],
  ['twins', { one: ['a', 'b'], two: ['a', 'b'] }, ['one', 'two']],
  ['any spelling', { eye: [], head: ['Head.a_L', 'b'] }, ['head']],
  ['all where none has any', { one: ['x'], two: [] }, ['one', 'two']],
])('faces among meshes with one material: %s', (_, meshes: Record<string, string[]>, expected) => {
  const measure = (name: string) => ({ targets: meshes[name]!, vertices: 3 })
  expect(drivenFaces(Object.keys(meshes), measure, morph('a', 'b', 'c', 'aLeft'))).toEqual(expected)
})

test('of two meshes with the same shapes, the larger one is chosen', () => {
  const measure = (vertices: number) => ({ targets: ['a'], vertices })
  expect(drivenFaces([3, 300], measure, morph('a'))).toEqual([300, 3])
})
