import { readFileSync } from 'node:fs'
import { readGlbFile } from 'furrow-files/node'
import { describe, expect, it } from 'vitest'
import { type Anything, joinGlb, setImage, splitGlb } from '../../fuzz/glb-parts.ts'
import { vrm0Avatar, vrm1Avatar } from './vrm-avatars.ts'
import { Workshop } from './workshop.ts'

const NAME = 'FURROW_wrinkle_maps'
const LISTS = ['nodes', 'meshes', 'accessors', 'materials', 'textures', 'images', 'samplers'] as const

const shop = new Workshop()

describe.each([
  ['VRM 0', vrm0Avatar],
  ['VRM 1', vrm1Avatar],
])('furrow auto on an avatar in %s', (version, makeAvatar) => {
  const at = (name: string) => shop.path(`${version}/${name}`)
  const write = async (name: string) => shop.write(`${version}/${name}`, await makeAvatar())
  const make = async (face: string, out: string, ...options: string[]) => {
    await shop.run('auto', face, '-o', out, '--size', '512', ...options)
    return out
  }

  it.each(['vrm', 'glb', 'gltf'])('adds wrinkles and keeps everything else, in a .%s', async (format) => {
    const path = await write('avatar.vrm')
    const out = await make(path, at(`wrinkled.${format}`))
    expectKept(await contentsOf(path), await contentsOf(out))
    await expectWrinkles(out)
  })

  it('has the same bytes when its wrinkles are made again', async () => {
    const first = await make(await write('plain.vrm'), at('once.vrm'))
    const second = await make(first, at('twice.vrm'), '--replace')
    expect(readFileSync(second)).toEqual(readFileSync(first))
  })

  it('keeps everything when wrinkles are replaced, also an image that was added after the wrinkles', async () => {
    const plain = await write('bare.vrm')
    const parts = splitGlb(readFileSync(await make(plain, at('first.vrm'))))
    const { json } = parts
    const image = json.images.push({ name: 'new thumbnail' }) - 1
    const picture = Buffer.from('\x89PNG\r\n\x1a\n another', 'latin1')
    if (version === 'VRM 0') json.extensions.VRM.meta.texture = json.textures.push({ source: image }) - 1
    else json.extensions.VRMC_vrm.meta.thumbnailImage = image
    shop.write(`${version}/edited.vrm`, joinGlb(setImage(parts, image, picture, 'image/png')))
    const out = await contentsOf(await make(at('edited.vrm'), at('second.vrm'), '--replace', '--age', '70'))
    expect(out.images[image].bufferView).toBe(picture.toString('base64'))
    if (version === 'VRM 0') expect(out.textures[json.extensions.VRM.meta.texture].source).toBe(image)
    expectKept({ ...(await contentsOf(plain)), extensions: json.extensions }, out)
  })
})

/** Returns the JSON of a file without its wrinkles. Bytes replace buffer view indices, because views may move. */
async function contentsOf(path: string): Promise<Anything> {
  const { json, bin } = await readGlbFile(path, 'test')
  const { buffers: _, bufferViews = [], extensionsUsed, ...rest } = json
  for (const { extensions } of rest.materials ?? []) delete extensions?.[NAME]
  const text = JSON.stringify(rest, (key, value) => {
    if (key !== 'bufferView') return value
    const { byteOffset = 0, byteLength } = bufferViews[value]!
    return Buffer.from(bin.subarray(byteOffset, byteOffset + byteLength)).toString('base64')
  })
  return { ...JSON.parse(text), extensionsUsed: extensionsUsed?.filter((name) => name !== NAME) }
}

/** Expects that all items keep their indices. Only images and textures of wrinkles may be added at the end. */
function expectKept(before: Anything, after: Anything): void {
  const kept = LISTS.map((list) => [list, after[list].slice(0, before[list].length)])
  expect({ ...after, ...Object.fromEntries(kept) }).toEqual(before)
}

async function expectWrinkles(path: string): Promise<void> {
  const { json } = await readGlbFile(path, 'test')
  const { layers, areas } = json.materials![0]!.extensions![NAME] as Anything
  expect(Math.min(layers.length, areas.length)).toBeGreaterThan(0)
  shop.printed = ''
  await shop.run('validate', path)
  expect(shop.printed).toMatch(/\(MTOON\).*: 0 errors, /s)
}
