import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { zipSync } from 'fflate'
import { resampleGray } from 'furrow/internal'
import { decodeGray } from 'furrow-files'
import { encodePng } from 'furrow-files/node'
import sharp from 'sharp'
import { describe, expect, it } from 'vitest'
import { renameArea } from '../../../studio/src/document/areas.ts'
import type { StudioDocument } from '../../../studio/src/document/document.ts'
import { renameLayer } from '../../../studio/src/document/layers.ts'
import type { StrokeMaps } from '../../../studio/src/document/packed-layers.ts'
import type { FolderFile } from '../../../studio/src/files/folder-files.ts'
import { unzipFolder, zipFolder } from '../../../studio/src/files/zip.ts'
import { folderFiles } from '../../../studio/src/keep/folder-files.ts'
import { readFolder } from '../../../studio/src/keep/read-folder.ts'
import { across } from '../../strokes.ts'
import { Workshop } from '../cli/workshop.ts'
import { sampleDocument } from './sample-document.ts'

const shop = new Workshop()

/** Archive made by Python's zipfile, with all numbers in the 64-bit fields of zip64. */
const ZIP_64 =
  'UEsDBC0AAAAAAAAAIQDZqbWP//////////8IABQAeC9hLmpzb24BABAAHAAAAAAAAAAcAAAAAAAAAHsiYSI6IFsxLCAxLCAxLCAxLCAxLCAxLCAxXX1QSwMELQAAAAAAAAAhAIamEDb//////////wcAFAB4L2IudHh0AQAQAAUAAAAAAAAABQAAAAAAAABoZWxsb1BLAQItAy0AAAAAAAAAIQDZqbWP//////////8IABQAAAAAAAAAAACAAQAAAAB4L2EuanNvbgEAEAAcAAAAAAAAABwAAAAAAAAAUEsBAi0DLQAAAAAAAAAhAIamEDb//////////wcAHAAAAAAAAAAAAIAB/////3gvYi50eHQBABgABQAAAAAAAAAFAAAAAAAAAFYAAAAAAAAAUEsGBiwAAAAAAAAALQAtAAAAAAAAAAAAAgAAAAAAAAACAAAAAAAAAJsAAAAAAAAAlAAAAAAAAABQSwYHAAAAAC8BAAAAAAAAAQAAAFBLBQYAAAAAAgACAJsAAACUAAAAAAA='

async function imageOf(side: number, value: number) {
  const create = { width: side, height: side, channels: 3, background: { r: value, g: 128, b: 255 } } as const
  return { mimeType: 'image/png', bytes: new Uint8Array(await sharp({ create }).png().toBuffer()) }
}

/** Returns the sample document with valid image files, varying area weights and every kind of setting. */
async function wholeDocument(): Promise<StudioDocument> {
  const document = sampleDocument()
  const [up, down] = document.layers
  const maps = {
    normal: await imageOf(64, 100),
    baseColor: await imageOf(64, 200),
    blood: await imageOf(32, 150),
    onset: await imageOf(32, 60),
  }
  return {
    ...document,
    layers: [
      {
        ...up,
        kind: 'replace',
        maps,
        normalScale: 1.5,
        occlusionStrength: 0.5,
        bloodAmplitude: 0.4,
        onsetStrength: 0.7,
      },
      { ...down, heightAmplitude: 0.01 },
    ],
    areas: document.areas.map((area, i) => ({
      ...area,
      combine: i === 1 ? 'max' : 'sum',
      activation: i / 4,
      weights: { ...area.weights, data: area.weights.data.map((_, k) => 16 * k + i) },
      ...(i === 2 && { isAutomatic: true }),
    })),
    furrows: { size: 1, depth: 0.1, stretch: 1.2, seed: 7, layer: up.name },
    strokes: document.strokes.map((stroke, i) => (i === 1 ? { ...stroke, isAutomatic: true } : stroke)),
  }
}

const SIDE = 64

/** Returns drawn maps. The value makes them different for each layer. */
function strokeMaps(value: number): StrokeMaps {
  const texels = SIDE ** 2
  return {
    normal: { width: SIDE, height: SIDE, data: new Uint8Array(4 * texels).fill(value) },
    occlusion: { width: SIDE, height: SIDE, data: new Uint8Array(texels).fill(value + 1) },
    heights: { width: SIDE, height: SIDE, data: new Float32Array(texels).fill(value / -100) },
  }
}

function drawnMaps({ layers }: StudioDocument): Map<string, StrokeMaps> {
  return new Map(layers.map(({ name }, i) => [name, strokeMaps(10 * (i + 1))]))
}

const FACE = [{ path: 'avatar.vrm', file: new Blob(['the face']) }]

/** Returns the files as a page receives them. */
const asRead = (files: readonly FolderFile[]) =>
  files.map(({ path, content }) => ({ path, file: new Blob([content as BlobPart]) }))

/** Returns the files of a folder in the workshop as a page receives them. */
function onDisk(name: string) {
  return Object.entries(shop.files(name)).map(([path, base64]) => ({
    path,
    file: new Blob([Buffer.from(base64, 'base64')]),
  }))
}

function write(document: StudioDocument, face = FACE): FolderFile[] {
  return folderFiles({ document, drawn: drawnMaps(document) }, face)
}

describe('the folder of a project', () => {
  it('is read as the same document and face', async () => {
    const document = await wholeDocument()
    const { document: read, face } = await readFolder(asRead(write(document)), 'Face', decodeGray)
    expect(read).toEqual(document)
    expect(face.map(({ path }) => path)).toEqual(['avatar.vrm'])
    expect(await face[0].file.text()).toBe('the face')
  })

  it('keeps names that cannot be file names', async () => {
    const renamed = renameArea(renameLayer(await wholeDocument(), 'up', 'brow/up?'), 'frown', '..')
    const files = write(renamed)
    for (const { path } of files) expect(path).toMatch(/^[\w/ -]+\.\w+$/)
    const { document } = await readFolder(asRead(files), 'Face', decodeGray)
    // The shapes of an area in `strokes.json` are dropped if the area's name cannot be a file name.
    expect(document).toEqual({ ...renamed, strokeAreas: [renamed.strokeAreas![0]] })
  })

  it('can store a document without areas, strokes, drivers and maps', async () => {
    const { sculpted: _, ...layer } = sampleDocument().layers[1]
    const bare: StudioDocument = {
      scale: 10,
      mapSize: 32,
      areaSize: 8,
      layers: [layer],
      areas: [],
      strokes: [],
      drivers: [],
    }
    const files = folderFiles({ document: bare, drawn: new Map() }, [])
    expect(files.map(({ path }) => path)).toEqual(['layers/down/normal.png', 'wrinkles.json', 'studio.json'])
    expect(await readFolder(asRead(files), 'Face', decodeGray)).toEqual({
      document: bare,
      face: [],
      notes: [],
    })
  })

  it('stores a face of several files unchanged', async () => {
    const face = ['head/face.gltf', 'head/face.bin', 'skin.png'].map((path) => ({
      path,
      file: new Blob([path]),
    }))
    const files = write(await wholeDocument(), face)
    expect(files[0].path).toBe('face/head/face.gltf')
    const read = await readFolder(asRead(files), 'Face', decodeGray)
    expect(read.face.map(({ path }) => path)).toEqual(face.map(({ path }) => path))
  })

  it('is the same after it is stored in a .zip', async () => {
    const document = await wholeDocument()
    const zip = await zipFolder(write(document), 'My face')
    const files = await unzipFolder(zip, 'My face.zip')
    expect((await readFolder(files, 'Face', decodeGray)).document).toEqual(document)
  })
})

describe('`furrow pack`', () => {
  it('packs the folder of a project', async () => {
    const document = { ...(await wholeDocument()), mesh: undefined, material: undefined }
    const bytes = readFileSync(join(await shop.makeFolder('hand'), 'face.glb'))
    const face = [{ path: 'avatar.glb', file: new Blob([bytes]) }]
    for (const { path, content } of write(document, face)) {
      const file = content instanceof Blob ? new Uint8Array(await content.arrayBuffer()) : content
      shop.write(`project/${path}`, file)
    }
    await shop.run('pack', shop.path('project'), '-o', shop.path('packed.glb'))
    shop.printed = ''
    await shop.run('inspect', shop.path('packed.glb'), '--json')
    const report = JSON.parse(shop.printed)
    expect(report.layers.map((layer: { name: string }) => layer.name)).toEqual(['up', 'down'])
    expect(report.areas.map((area: { name: string }) => area.name)).toEqual(['forehead', 'frown', 'cheeks'])
    expect(report.strokes.count).toBe(document.strokes.length)
    expect(report.drivers.length).toBe(document.drivers.length)
  })
})

describe('a hand-made folder', () => {
  it('opens without studio.json, with the same content as `furrow pack` reads', async () => {
    await shop.makeFolder('plain')
    const { document, face } = await readFolder(onDisk('plain'), 'plain', decodeGray)
    expect(document.layers.map(({ name, maps }) => [name, Object.keys(maps)])).toEqual([
      ['age', ['normal']],
      ['expression', ['normal', 'baseColor']],
    ])
    const [image] = readdirSync(shop.path('plain/areas')).sort()
    const gray = await decodeGray(readFileSync(shop.path(`plain/areas/${image}`)), image, 'test')
    const weights = { ...gray, data: gray.data.map((value) => 255 - value) }
    expect(document.areas[0].weights).toEqual(resampleGray(weights, document.areaSize))
    expect(document).toMatchObject({ scale: 1000, areaSize: 128, strokes: [], drivers: [] })
    expect(face.map(({ path }) => path)).toEqual(['face.glb'])
  })

  it('has its strokes drawn at the size of its maps', async () => {
    await shop.makeFolder('sized')
    const { bytes } = await imageOf(32, 128)
    for (const layer of ['age', 'expression'])
      shop.write(`sized/layers/${layer}/normal.png`, Buffer.from(bytes))
    expect((await readFolder(onDisk('sized'), 'sized', decodeGray)).document.mapSize).toBe(32)
  })

  it('has its strokes drawn again, and the maps made from strokes are skipped', async () => {
    await shop.makeFolder('lines')
    const points = across(0.2, 0.1, 0.4)
    const strokes = [{ layer: 'age', points, width: 2, depth: 1 }]
    shop.json('lines/strokes.json', { version: 1, scale: 100, size: 256, strokes })
    const { document } = await readFolder(onDisk('lines'), 'lines', decodeGray)
    expect(document).toMatchObject({ scale: 100, mapSize: 256, strokes })
    expect(document.layers.map(({ maps }) => Object.keys(maps))).toEqual([[], ['normal', 'baseColor']])
  })

  it('may contain its images as data: URLs in the document', async () => {
    const bytes = Uint8Array.from(
      Buffer.from(await encodePng({ width: 2, height: 2, channels: 1, data: new Uint8Array(4) })),
    )
    const image = `data:image/png;base64,${Buffer.from(bytes).toString('base64')}`
    const set = { layers: [{ name: 'a', normal: image }], areas: [{ name: 'b', image }] }
    const files = [{ path: 'wrinkles.json', file: new Blob([JSON.stringify({ version: 1, ...set })]) }]
    const { document } = await readFolder(files, 'hand', decodeGray)
    expect(document.layers[0].maps.normal?.bytes).toEqual(bytes)
    expect(document.areas[0].weights.data.every((weight) => weight === 255)).toBe(true)
  })

  it.each([
    ['no JSON', { 'wrinkles.json': '{' }, 'cannot read wrinkles.json'],
    [
      'no image',
      { 'wrinkles.json': '{"layers":[{"name":"a"}],"areas":[{"name":"b"}]}' },
      'is not in the folder',
    ],
    ['nothing', {}, 'no layers in hand'],
    [
      'strokes on no layer',
      {
        'wrinkles.json': '{"layers":[{"name":"a"}],"areas":[{"name":"b"}]}',
        'strokes.json': '{"version":1,"strokes":[]}',
      },
      'strokes has the wrong number of items',
    ],
  ])('with %s fails with one clear message', async (_, files, message) => {
    const list = Object.entries(files).map(([path, text]) => ({ path, file: new Blob([text]) }))
    await expect(readFolder(list, 'hand', decodeGray)).rejects.toThrow(message)
  })

  it('opens as if it had no studio.json if its studio.json is invalid', async () => {
    await shop.makeFolder('odd')
    const without = await readFolder(onDisk('odd'), 'odd', decodeGray)
    for (const text of ['{ "version": 7, "layers": 3 }', '5', 'null', '{ "version": 1', '[]']) {
      shop.write('odd/studio.json', text)
      const { notes, ...read } = await readFolder(onDisk('odd'), 'odd', decodeGray)
      expect({ ...read, notes: [] }).toEqual(without)
      expect(notes, text).toEqual([expect.stringContaining('studio.json')])
    }
  })

  it.each<[object, string]>([
    [{ auto: 5 }, 'auto must be an object'],
    [{ auto: {} }, 'auto.strength must be a number'],
    [{ auto: { strength: 1, size: 1024, seed: 1, age: 'old' } }, 'auto.age must be a number'],
    [{ auto: { strength: 1, size: 1024, seed: 1, symmetry: 2 } }, 'auto.symmetry is out of range'],
    [{ auto: { strength: 1, size: 1024, seed: 1, regions: 'chin' } }, 'auto.regions must be an array'],
    [{ auto: { strength: 1, size: 1024, seed: 1, regions: ['tail'] } }, 'auto.regions[0] is unknown'],
    [{ auto: { strength: 1, size: 1024, kind: 'fur' } }, 'auto.kind is unknown'],
    [{ auto: { strength: 1, size: 1024, cloth: 'fur' } }, 'auto.cloth is unknown'],
    [{ auto: { strength: 1, size: 1024, strengths: { chin: -1 } } }, 'auto.strengths.chin is out of range'],
    [{ auto: { strength: 1, size: 1024, densities: { chin: 1 } } }, 'auto.densities has an unknown field'],
    [{ mapSize: -1 }, 'mapSize is out of range'],
    [{ mapSize: '64' }, 'mapSize must be a number'],
    [{ scale: null }, 'scale must be a number'],
    [{ automaticAreas: 5 }, 'automaticAreas must be an array'],
    [{ automaticStrokes: ['1'] }, 'automaticStrokes[0] must be a number'],
    [{ automaticBlood: {} }, 'automaticBlood must be an array'],
    [{ layers: { expression: { drawn: 5 } } }, 'layers.expression.drawn must be an array'],
    [{ layers: { expression: { drawn: ['paint'] } } }, 'layers.expression.drawn[0] is unknown'],
    [{ layers: { age: { drawn: [], under: { normal: 5 } } } }, 'layers.age.under.normal must be text'],
    [{ face: 'face.glb' }, 'face must be an object'],
    [{ face: { path: 5 } }, 'face.path must be text'],
    [{ files: [5] }, 'files[0] must be text'],
  ])(
    'opens without the invalid part of studio.json %j, and reports this part in one line',
    async (wrong, problem) => {
      await shop.makeFolder('wrong')
      // Leaves out the weights, because comparing all of them takes a second.
      const read = async (json: object) => {
        shop.json('wrong/studio.json', json)
        const { document, face, notes } = await readFolder(onDisk('wrong'), 'wrong', decodeGray)
        return { document: { ...document, areas: document.areas.length }, face, notes }
      }
      const note = expect.stringContaining(`Opened without a part of studio.json: studio.json: ${problem}`)
      expect(await read({ version: 1, ...wrong })).toEqual({ ...(await read({ version: 1 })), notes: [note] })
    },
  )

  it('keeps the valid parts of studio.json next to invalid ones', async () => {
    await shop.makeFolder('partly')
    const auto = { age: 60, strength: 1, size: 1024, seed: 3, seeds: { chin: 4 }, regions: ['chin'] }
    shop.json('partly/studio.json', { version: 1, auto, mapSize: 5, files: 5 })
    const { document, notes } = await readFolder(onDisk('partly'), 'partly', decodeGray)
    expect(document.auto).toEqual(auto)
    expect(notes).toEqual([expect.stringMatching(/mapSize is out of range.* \(and 1 more\)$/)])
  })
})

describe('a .zip', () => {
  const files = [
    { path: 'wrinkles.json', content: new TextEncoder().encode('{}') },
    { path: 'layers/a/normal.png', content: new Blob(['image']) },
  ]

  it('contains one folder, whose name is removed from the paths when it is read', async () => {
    const zip = await zipFolder(files, 'Gesicht ä')
    const read = await unzipFolder(zip, 'a.zip')
    expect(read.map(({ path }) => path)).toEqual(['wrinkles.json', 'layers/a/normal.png'])
    expect(await read[1].file.text()).toBe('image')
  })

  it('is read without the hidden files that operating systems add', async () => {
    const left = ['__MACOSX/._x', '.DS_Store'].map((path) => ({
      path: `../${path}`,
      content: new Uint8Array(1),
    }))
    const zip = await zipFolder([...files, ...left], 'x')
    expect((await unzipFolder(zip, 'a.zip')).length).toBe(2)
  })

  it.each([
    ['is not an archive', new Blob(['PK but no more'])],
    ['is empty', new Blob([])],
  ])('that %s fails with one clear message', async (_, zip) => {
    await expect(unzipFolder(zip, 'a.zip')).rejects.toThrow('Studio: cannot read a.zip')
  })

  it.each([
    ['far fewer', 10],
    ['fewer', 2 ** 22],
    ['far more', 0xfffffff0],
  ])('with an entry that claims %s bytes than it has fails quickly with one message', async (_, claimed) => {
    const content = new Uint8Array(2 ** 24)
    const zip = new Uint8Array(await (await zipFolder([{ path: 'a.json', content }], 'x')).arrayBuffer())
    const view = new DataView(zip.buffer)
    // Changes the entry's size in the archive's directory. The archive ends with a record of 22 bytes, which locates the directory.
    const list = view.getUint32(zip.length - 6, true)
    expect(view.getUint32(list + 24, true)).toBe(content.length)
    view.setUint32(list + 24, claimed, true)
    const start = performance.now()
    const failure = await unzipFolder(new Blob([zip]), 'a.zip').catch((error) => error)
    expect(failure.message).toMatch(
      /^Studio: (cannot read a\.zip \(x\/a\.json has more bytes than it says\)|a\.zip is too large)/,
    )
    expect(performance.now() - start).toBeLessThan(1000)
  })

  it('is refused before unpacking if its entries are too large in total', async () => {
    const content = new Uint8Array(1000)
    const files = Array.from({ length: 3 }, (_, i) => ({ path: `${i}.json`, content }))
    const zip = new Uint8Array(await (await zipFolder(files, 'x')).arrayBuffer())
    const view = new DataView(zip.buffer)
    let at = view.getUint32(zip.length - 6, true)
    for (let i = 0; i < 3; i++) {
      view.setUint32(at + 24, 2 ** 29, true)
      at += 46 + [28, 30, 32].reduce((sum, field) => sum + view.getUint16(at + field, true), 0)
    }
    await expect(unzipFolder(new Blob([zip]), 'a.zip')).rejects.toThrow('Studio: a.zip is too large')
  })

  it('with thousands of files is refused with one message', async () => {
    const many = Array.from({ length: 5001 }, (_, i) => ({ path: `${i}.png`, content: new Uint8Array(1) }))
    const zip = await zipFolder(many, 'x')
    await expect(unzipFolder(zip, 'a.zip')).rejects.toThrow(
      /^Studio: too many files in a\.zip, allowed: 5,000/,
    )
  })

  it('made by another program is read, including zip64', async () => {
    const wide = Buffer.from(ZIP_64, 'base64')
    const files = await unzipFolder(new Blob([wide]), 'wide.zip')
    expect(files.map(({ path, file }) => [path, file.size])).toEqual([
      ['a.json', 28],
      ['b.txt', 5],
    ])
    const zip = zipSync({
      'x/a.json': [new TextEncoder().encode('{}'), { level: 9 }],
      'x/é.txt': [new Uint8Array(3), { level: 0 }],
    })
    const read = await unzipFolder(new Blob([zip as Uint8Array<ArrayBuffer>]), 'a.zip')
    expect(read.map(({ path, file }) => [path, file.size])).toEqual([
      ['a.json', 2],
      ['é.txt', 3],
    ])
  })

  it('that is truncated or damaged is read, or refused with one message', async () => {
    const bytes = new Uint8Array(await (await zipFolder(files, 'x')).arrayBuffer())
    for (let i = 0; i < bytes.length; i += 3) {
      const damaged = bytes.slice()
      damaged[i] ^= 0x55
      for (const zip of [bytes.subarray(0, i), damaged]) {
        await unzipFolder(new Blob([zip]), 'a.zip').catch((error) => expect(error.name).toBe('FurrowError'))
      }
    }
  })
})
