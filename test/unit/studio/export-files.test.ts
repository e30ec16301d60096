import { readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { packCommand } from '../../../packages/cli/src/commands/pack.ts'
import { exportFace } from '../../../studio/src/export/export-face.ts'
import { readFace } from '../../../studio/src/export/read-face.ts'
import { findingsOf } from '../../../studio/src/export/validate-face.ts'
import { openFace, referencesIn, wrinkleSetIn } from '../../../studio/src/files/face-files.ts'
import { Workshop } from '../cli/workshop.ts'

const shop = new Workshop()

/** The files of a folder, as a page has them. */
async function projectAt(name: string) {
  const folder = await shop.makeFolder(name)
  const entries = Object.entries(shop.files(name))
  const files = new Map<string, Uint8Array>(
    entries.map(([path, text]) => [path, Buffer.from(text, 'base64')]),
  )
  return { folder, files, face: { name: 'face.glb', bytes: files.get('face.glb')! } }
}

describe('the files beside a face', () => {
  const bytes = Uint8Array.of(1, 2, 3)
  const read = referencesIn(new Map([['images/my skin.png', bytes]]), 'face.gltf', 'Studio')

  it('are found by any address of them, each as one object', async () => {
    const found = await read('images/my%20skin.png')
    expect(found).toEqual({ bytes, path: 'images/my skin.png' })
    expect(await read('./images\\x/../my skin.png')).toBe(found)
  })

  it('are found by the address itself, where they were dropped from elsewhere', async () => {
    const read = referencesIn(new Map([['tex/skin%20a.png', bytes]]), 'face.gltf', 'Studio')
    expect(await read('tex/skin%20a.png')).toEqual({ bytes, path: 'tex/skin a.png' })
  })

  it('are not needed where the address holds the data', async () => {
    expect(await read('data:;base64,AQID')).toEqual({ bytes })
    expect(await read('data:,%01b')).toEqual({ bytes: Uint8Array.of(1, 98) })
  })

  it.each([
    [
      'a file that was not opened',
      'skin.bin',
      'cannot read skin.bin, which face.gltf refers to (it was not opened with it)',
    ],
    ['one above', '../images/my skin.png', 'it was not opened with it'],
    ['an absolute path', '/images/skin.png', 'it was not opened with it'],
    ['the network', 'https://example.org/skin.png', 'refers to a file that is not on this computer'],
    ['no address', '', 'face.gltf has an empty address'],
  ])('are missed: %s', async (_, uri, message) => {
    await expect(read(uri)).rejects.toThrow(message)
  })
})

describe('a project', () => {
  it('is read as furrow pack reads its folder, other files ignored', async () => {
    const { files } = await projectAt('plain')
    const document = wrinkleSetIn(files.set('notes.txt', Uint8Array.of(1)), 'Studio')
    expect(document.layers.map(({ name }) => name)).toEqual(['age', 'expression'])
    expect(document.layers[1]).toMatchObject({ baseColor: 'layers/expression/baseColor.png' })
    expect(document.areas.map(({ image }) => image)).toContain('areas/brow.png')
  })

  it('without areas, or with a damaged document, is refused in one line', async () => {
    const { files } = await projectAt('odd')
    const layers = new Map([...files].filter(([path]) => !path.startsWith('areas/')))
    expect(() => wrinkleSetIn(layers, 'Studio')).toThrow('Studio: no areas in the project')
    expect(() => wrinkleSetIn(files.set('wrinkles.json', Uint8Array.of(123)), 'Studio')).toThrow(
      /^Studio: cannot read wrinkles.json \(.*JSON/,
    )
  })

  it('becomes the bytes of furrow pack, validated, and a project again', async () => {
    const { folder, files, face } = await projectAt('whole')
    for (const [options, words] of [
      [{}, []],
      [{ size: 8, areaSize: 64, mesh: 'eyes' }, ['--size', '8', '--area-size', '64', '--mesh', 'eyes']],
    ] as const) {
      const out = shop.path('out.glb')
      await shop.run(packCommand, folder, '-o', out, ...words)
      const { bytes, findings, cost, warnings } = await exportFace(face, files, options)
      expect(Buffer.from(bytes).equals(readFileSync(out))).toBe(true)
      expect(findings.filter(({ severity }) => severity === 'error')).toEqual([])
      expect([cost.file, cost.gpu].every((size) => size > 0)).toBe(true)
      expect(warnings).toEqual([])
      const read = await readFace({ name: 'out.glb', bytes })
      const again = await exportFace({ name: 'face.glb', bytes: read.face }, read.folder!)
      expect(Buffer.from(again.bytes).equals(bytes)).toBe(true)
    }
  })

  it('is not there in a face without wrinkles', async () => {
    const { face } = await projectAt('bare')
    const { folder, face: bytes } = await readFace(face)
    expect(folder).toBeUndefined()
    expect((await findingsOf(await openFace({ name: 'face.glb', bytes }, 'Studio')))[0]).toMatchObject({
      code: 'NO_WRINKLES',
    })
  })
})
