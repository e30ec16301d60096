import { readFileSync } from 'node:fs'
import { WebIO } from '@gltf-transform/core'
import { describe, expect, it } from 'vitest'
import type { StudioDocument } from '../../../studio/src/document/document.ts'
import { setSculpted } from '../../../studio/src/document/layers.ts'
import type { DocumentToPack, StrokeMaps } from '../../../studio/src/document/packed-layers.ts'
import { sculptedOf } from '../../../studio/src/document/sculpted.ts'
import { motionOf } from '../../../studio/src/document/take.ts'
import { exportDocument } from '../../../studio/src/export/export-document.ts'
import { readDocument, readProject } from '../../../studio/src/export/read-document.ts'
import { readFace } from '../../../studio/src/export/read-face.ts'
import { findingsOf } from '../../../studio/src/export/validate-face.ts'
import { openFace, referencesIn } from '../../../studio/src/files/face-files.ts'
import { Workshop } from '../cli/workshop.ts'
import { opened, projectFiles } from './project-files.ts'
import { sampleDocument, strokeOf } from './sample-document.ts'

const shop = new Workshop()

/** Makes a folder of wrinkles, and returns its path, and its files as a page receives them. */
async function projectAt(name: string) {
  const folder = await shop.makeFolder(name)
  const entries = Object.entries(shop.files(name))
  const files = new Map<string, Uint8Array>(
    entries.map(([path, text]) => [path, Buffer.from(text, 'base64')]),
  )
  return { folder, files, face: { name: 'face.glb', bytes: files.get('face.glb')! } }
}

const SIDE = 32

/** Maps of drawn lines. */
const LINES: StrokeMaps = {
  normal: { width: SIDE, height: SIDE, data: texels(4, (i) => 100 + (i % 50)) },
  occlusion: { width: SIDE, height: SIDE, data: texels(1, (i) => 200 + (i % 50)) },
  heights: {
    width: SIDE,
    height: SIDE,
    data: Float32Array.from(
      texels(1, (i) => i % 9),
      (step) => step / -10,
    ),
  },
}

function texels(channels: number, valueAt: (index: number) => number): Uint8Array {
  return Uint8Array.from({ length: channels * SIDE ** 2 }, (_, i) => valueAt(i))
}

/** Returns a document with a stroke on its first layer, and without maps on the others. */
function withLines(document: StudioDocument): StudioDocument {
  const [age, ...others] = document.layers
  const layers = [age, ...others.map((layer) => ({ ...layer, maps: {} }))]
  return { ...document, mapSize: SIDE, layers, strokes: [strokeOf('age', 'brow')] }
}

/** Returns a document whose first layer has sculpted heights and no stroke. */
function withSculpted(document: StudioDocument): StudioDocument {
  const data = new Float32Array(SIDE ** 2).fill(0.25, 100)
  const { strokes: _, ...lined } = withLines(document)
  return setSculpted({ ...lined, strokes: [] }, 'age', sculptedOf({ width: SIDE, height: SIDE, data }))
}

/** Writes the folder of a document with a face, and returns its path. */
function saved(name: string, source: DocumentToPack, face: Uint8Array): string {
  for (const [path, bytes] of projectFiles(source)) shop.write(`${name}/${path}`, bytes)
  shop.write(`${name}/face.glb`, face)
  return shop.path(name)
}

describe('the files next to a face', () => {
  const bytes = Uint8Array.of(1, 2, 3)
  const read = referencesIn(new Map([['images/my skin.png', bytes]]), 'face.gltf', 'Studio')

  it('are found by any form of their URLs, and each is always the same object', async () => {
    const found = await read('images/my%20skin.png')
    expect(found).toEqual({ bytes, path: 'images/my skin.png' })
    expect(await read('./images\\x/../my skin.png')).toBe(found)
  })

  it('are found if their path is the URL itself, with its escapes', async () => {
    const read = referencesIn(new Map([['tex/skin%20a.png', bytes]]), 'face.gltf', 'Studio')
    expect(await read('tex/skin%20a.png')).toEqual({ bytes, path: 'tex/skin a.png' })
  })

  it('are not needed for data: URLs', async () => {
    expect(await read('data:;base64,AQID')).toEqual({ bytes })
    expect(await read('data:,%01b')).toEqual({ bytes: Uint8Array.of(1, 98) })
  })

  it.each([
    [
      'a file that was not opened',
      'skin.bin',
      'cannot read skin.bin, referenced by face.gltf (it was not opened with it)',
    ],
    ['one above', '../images/my skin.png', 'it was not opened with it'],
    ['an absolute path', '/images/skin.png', 'it was not opened with it'],
    ['the network', 'https://example.org/skin.png', 'references a remote file'],
    ['no address', '', 'face.gltf has an empty URI'],
  ])('are reported missing: %s', async (_, uri, message) => {
    await expect(read(uri)).rejects.toThrow(message)
  })
})

describe('a project', () => {
  it('exports the same bytes as `furrow pack`, which are valid and open as a project', async () => {
    const { files, face } = await projectAt('whole')
    const { document } = await readProject(opened(files), 'whole')
    const images = { document, drawn: new Map() }
    const lines = { document: withLines(document), drawn: new Map([['age', LINES]]) }
    const sculpted = { document: withSculpted(document), drawn: new Map([['age', LINES]]) }
    const ofEyes = ['--size', '8', '--area-size', '64', '--mesh', 'eyes']
    for (const [source, options, words] of [
      [images, {}, []],
      [lines, {}, []],
      [sculpted, {}, []],
      [lines, { size: 8, areaSize: 64, mesh: 'eyes' }, ofEyes],
      [images, { size: 8, areaSize: 16, ktx2: true }, ['--size', '8', '--area-size', '16', '--ktx2']],
    ] as const) {
      const [folder, out] = [
        saved(source === images ? 'images' : source === lines ? 'lines' : 'sculpted', source, face.bytes),
        shop.path('out.glb'),
      ]
      await shop.run('pack', folder, '-o', out, ...words)
      const { bytes, findings, cost, warnings } = await exportDocument(face, source, options)
      expect(Buffer.from(bytes).equals(readFileSync(out)), words.join(' ')).toBe(true)
      expect(findings.filter(({ severity }) => severity === 'error')).toEqual([])
      expect([cost.file, cost.gpu].every((size) => size > 0)).toBe(true)
      expect(warnings).toEqual([])
    }
    const { bytes } = await exportDocument(face, images)
    const file = { name: 'out.glb', bytes }
    const again = { document: (await readDocument(file))!, drawn: new Map() }
    const { face: bare } = await readFace(file)
    const { bytes: twice } = await exportDocument({ name: 'face.glb', bytes: bare }, again)
    expect(Buffer.from(twice).equals(bytes)).toBe(true)
  })

  it('keeps shape corrections in the exported file, like `furrow pack`', async () => {
    const { files, face } = await projectAt('corrected')
    const { document } = await readProject(opened(files), 'corrected')
    const shapes = [{ target: 'smile', shape: 'mouthFrown' }, { target: 'jaw' }]
    const source = { document: { ...document, shapes }, drawn: new Map() }
    const { bytes } = await exportDocument(face, source)
    await shop.run('pack', saved('corrections', source, face.bytes), '-o', shop.path('out.glb'))
    expect(Buffer.from(bytes).equals(readFileSync(shop.path('out.glb')))).toBe(true)
    expect((await readDocument({ name: 'out.glb', bytes }))!.shapes).toEqual(shapes)
  })

  it('without areas is refused with a message of one line', async () => {
    const { face } = await projectAt('begun')
    const document = { ...sampleDocument(), areas: [], drivers: [] }
    await expect(exportDocument(face, { document, drawn: new Map() })).rejects.toThrow(
      'Studio: the document has no areas',
    )
  })

  it('does not exist in a face without wrinkles', async () => {
    const { face } = await projectAt('bare')
    const { folder, face: bytes } = await readFace(face)
    expect(folder).toBeUndefined()
    expect((await findingsOf(await openFace({ name: 'face.glb', bytes }, 'Studio')))[0]).toMatchObject({
      code: 'NO_WRINKLES',
    })
  })
})

describe('takes', () => {
  const take = {
    name: 'Raise',
    motion: motionOf([0, 1], [['browInnerUp', [0, 1]]]),
    range: [0.5, 1],
  } as const

  it('become animations of the file, trimmed', async () => {
    const { files, face } = await projectAt('takes')
    const { document } = await readProject(opened(files), 'takes')
    const source = { document: { ...document, takes: [take] }, drawn: new Map() }
    const { bytes, findings } = await exportDocument(face, source)
    expect(findings.filter(({ severity }) => severity === 'error')).toEqual([])
    const [animation, ...others] = (await new WebIO().readBinary(bytes)).getRoot().listAnimations()
    expect([animation.getName(), others]).toEqual(['Raise', []])
    const channels = animation.listChannels()
    expect(channels.length).toBeGreaterThan(0)
    for (const channel of channels) {
      expect(channel.getTargetPath()).toBe('weights')
      const sampler = channel.getSampler()!
      const mesh = channel.getTargetNode()!.getMesh()!
      const names = (mesh.getExtras() as { targetNames: string[] }).targetNames
      const [times, weights] = [sampler.getInput()!.getArray()!, sampler.getOutput()!.getArray()!]
      expect([times.length, times[0], times[30]]).toEqual([31, 0, 0.5])
      const middle = weights.slice(15 * names.length, 16 * names.length)
      expect([...middle]).toEqual(names.map((name) => (name === 'browInnerUp' ? 0.75 : 0)))
    }
  })

  it('are left out if the user wants', async () => {
    const { files, face } = await projectAt('no-takes')
    const { document } = await readProject(opened(files), 'no-takes')
    const drawn = new Map()
    const without = await exportDocument(face, { document, drawn })
    const left = await exportDocument(
      face,
      { document: { ...document, takes: [take] }, drawn },
      { takes: false },
    )
    expect(left.bytes).toEqual(without.bytes)
  })
})
