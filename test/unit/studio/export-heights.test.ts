import sharp from 'sharp'
import { expect, it } from 'vitest'
import type { StudioDocument } from '../../../studio/src/document/document.ts'
import type { StrokeMaps } from '../../../studio/src/document/packed-layers.ts'
import { readProject } from '../../../studio/src/export/read-document.ts'
import { opened, projectFiles } from './project-files.ts'
import { sampleDocument } from './sample-document.ts'

const SIDE = 64

/** Maps of drawn lines: the left half is 0.2 mm deep, the right half 0.1 mm high. */
function lines(): StrokeMaps {
  const texels = SIDE ** 2
  const data = Float32Array.from({ length: texels }, (_, i) => (i % SIDE < SIDE / 2 ? -0.2 : 0.1))
  return {
    normal: { width: SIDE, height: SIDE, data: new Uint8Array(4 * texels).fill(128) },
    occlusion: { width: SIDE, height: SIDE, data: new Uint8Array(texels).fill(250) },
    heights: { width: SIDE, height: SIDE, data },
  }
}

function documentOf(maps: StudioDocument['layers'][number]['maps'], heightAmplitude?: number) {
  const document = sampleDocument()
  const [, down] = document.layers
  const layer = { ...down, maps, ...(heightAmplitude !== undefined && { heightAmplitude }) }
  return { ...document, layers: [{ ...layer, name: 'up' }, down] }
}

const entryOf = (files: ReadonlyMap<string, Uint8Array>) =>
  JSON.parse(new TextDecoder().decode(files.get('wrinkles.json')!)).layers[0]

it('the lines of a layer are exported as its height map in millimetres, at half size', async () => {
  const document = documentOf({})
  const files = projectFiles({ document, drawn: new Map([['up', lines()]]) })
  expect(entryOf(files)).toMatchObject({
    height: 'layers/up/height.png',
    heightAmplitude: expect.closeTo(4e-4, 8),
  })
  const { data, info } = await sharp(files.get('layers/up/height.png')!)
    .toColourspace('b-w')
    .raw()
    .toBuffer({ resolveWithObject: true })
  expect([info.width, info.height]).toEqual([SIDE / 2, SIDE / 2])
  // The smooth skin would be 127.5, and the deepest line is 0.
  expect([data[0], data[SIDE / 2 - 1]]).toEqual([0, 191])
})

it('a project is read without the height maps that its lines produce again', async () => {
  const document = documentOf({})
  const files = projectFiles({ document, drawn: new Map([['up', lines()]]) })
  const read = async (paths: (path: string) => boolean) => {
    const folder = opened([...files].filter(([path]) => paths(path)))
    return (await readProject(folder, 'Face')).document.layers[0]
  }
  expect(await read(() => true)).toEqual(document.layers[0])
  // Without studio.json, like a folder by `furrow unpack`, the layer keeps its height map.
  expect(await read((path) => path !== 'studio.json')).toEqual(document.layers[0])
})

it('the own height map of a layer is kept if the layer has lines', async () => {
  const height = { mimeType: 'image/png', bytes: Uint8Array.of(1, 2, 3) }
  const document = documentOf({ height }, 0.02)
  const files = projectFiles({ document, drawn: new Map([['up', lines()]]) })
  expect(files.get('layers/up/height.png')).toEqual(height.bytes)
  expect(entryOf(files).heightAmplitude).toBe(0.02)
})
