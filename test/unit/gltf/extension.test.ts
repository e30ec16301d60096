import { KHRTextureTransform, type Transform } from '@gltf-transform/extensions'
import {
  cloneDocument,
  dedup,
  getTextureColorSpace,
  listTextureChannels,
  listTextureSlots,
  meshopt,
  prune,
  quantize,
  textureCompress,
  unpartition,
} from '@gltf-transform/functions'
import { FurrowError } from 'furrow'
import { parseWrinkleMaps } from 'furrow/internal'
import { MeshoptEncoder } from 'meshoptimizer'
import sharp from 'sharp'
import { beforeAll, describe, expect, it } from 'vitest'
import { createIO, createSample, DRIVERS, NAME, SHAPES, STROKES, summary, wrinkleMapsOf } from './sample.ts'

const io = createIO()
const texturesOf = async () => (await createSample()).getRoot().listTextures()

describe('FurrowWrinkleMaps', () => {
  it('writes JSON without defaults, which the parser accepts', async () => {
    const { json } = await io.writeJSON(await createSample())
    expect(json.extensionsUsed).toEqual([NAME])
    expect(json.extensionsRequired).toBeUndefined()
    const maps = json.materials![0].extensions![NAME] as Record<string, unknown[]>
    expect(maps).toMatchObject({
      revision: 7,
      extras: { by: 'hand' },
      drivers: DRIVERS,
      strokes: STROKES,
      shapes: SHAPES,
    })
    expect(maps.layers[1]).toEqual({ name: 'down', kind: 'detail', normalTexture: { index: 7 } })
    expect(maps.layers[0]).toMatchObject({
      later: { deep: [1, 2] },
      normalTexture: { index: 2, scale: 0.5 },
      occlusionTexture: { index: 5, strength: 0.25 },
      heightTexture: { index: 6, amplitude: 0.004 },
      bloodTexture: { index: 5, amplitude: 0.5 },
      onsetTexture: { index: 5, strength: 0.75 },
    })
    expect(maps.areas[0]).toEqual({ name: 'brow', texture: { index: 8 } })
    expect(maps.areas[4]).toEqual({
      name: 'eye',
      extras: { side: 'left' },
      texture: { index: 9 },
      channel: 1,
      combine: 'max',
      activation: 0.5,
    })
    expect(parseWrinkleMaps(maps, json.textures!.length).areas).toHaveLength(5)
  })

  it('reads its own output, as JSON and as a binary file', async () => {
    const document = await createSample()
    const before = summary(document)
    expect(before.drivers).toEqual(DRIVERS)
    expect(before.strokes).toEqual(STROKES)
    expect(before.shapes).toEqual(SHAPES)
    expect(summary(await io.readJSON(await io.writeJSON(document)))).toEqual(before)
    const bytes = await io.writeBinary(document)
    const back = await io.readBinary(bytes)
    expect(summary(back)).toEqual(before)
    expect(await io.writeBinary(back)).toEqual(bytes)
  })

  it('is copied with the document, independently of the original', async () => {
    const document = await createSample()
    const copy = cloneDocument(document)
    const before = summary(document)
    expect(summary(copy)).toEqual(before)
    wrinkleMapsOf(document).listAreas()[0].setName('other').setTexture(null)
    wrinkleMapsOf(document).setDrivers([]).setStrokes(null).setShapes(null)
    expect(summary(copy)).toEqual(before)
    expect(wrinkleMapsOf(copy).listAreas()[1].getLayer()).toBe(wrinkleMapsOf(copy).listLayers()[1])
    expect(await io.writeBinary(copy)).toEqual(await io.writeBinary(await createSample()))
  })

  it.each([
    ['strokes', { version: 2, lines: [] }, 'lines'],
    ['shapes', [{ target: 7, extras: { by: 'hand' } }], { no: 'list' }],
  ] as const)('keeps %s unchanged, even if malformed or missing', async (field, ...values) => {
    const document = await createSample()
    const after = async (value: unknown) => {
      const wrinkles = wrinkleMapsOf(document)
      if (field === 'strokes') wrinkles.setStrokes(value)
      else wrinkles.setShapes(value)
      const written = await io.writeJSON(document)
      const read = wrinkleMapsOf(await io.readJSON(written))
      const json = written.json.materials![0].extensions![NAME] as Record<string, unknown>
      return [json[field], field === 'strokes' ? read.getStrokes() : read.getShapes()]
    }
    expect(await after(null)).toEqual([undefined, null])
    for (const value of values) expect(await after(value)).toEqual([value, value])
  })

  it('preserves slices in files and copies, and distinguishes slices of an array', async () => {
    const document = await createSample()
    const [layers, areas] = [wrinkleMapsOf(document).listLayers(), wrinkleMapsOf(document).listAreas()]
    const array = areas[0].getTexture()
    for (const [slice, area] of areas.entries()) area.setTexture(array, 0).setSlice(slice)
    layers[0].setSlice('occlusionTexture', 3).setSlice('bloodTexture', 3).setSlice('onsetTexture', 3)
    const slicesOf = (from: typeof document) => [
      wrinkleMapsOf(from)
        .listAreas()
        .map((area) => area.getSlice()),
      wrinkleMapsOf(from)
        .listLayers()
        .map((layer) => [layer.getSlice('occlusionTexture'), layer.getSlice('normalTexture')]),
    ]
    const expected = [
      [0, 1, 2, 3, 4],
      [
        [3, null],
        [null, null],
      ],
    ]
    const { json } = await io.writeJSON(document)
    const maps = json.materials![0].extensions![NAME] as Record<string, unknown[]>
    expect(maps.areas[0]).toEqual({ name: 'brow', texture: { index: 8, slice: 0 } })
    expect(maps.layers[0]).toMatchObject({ occlusionTexture: { index: 5, strength: 0.25, slice: 3 } })
    expect(slicesOf(await io.readBinary(await io.writeBinary(document)))).toEqual(expected)
    expect(slicesOf(cloneDocument(document))).toEqual(expected)
    const twin = areas[0].clone()
    expect(twin.equals(areas[0])).toBe(true)
    expect(twin.setSlice(1).equals(areas[0])).toBe(false)
    expect(layers[0].clone().setSlice('normalTexture', 1).equals(layers[0])).toBe(false)
  })

  it('lists the channels of each image, and only base colour as sRGB', async () => {
    const textures = await texturesOf()
    const of = (name: string) => textures.find((texture) => texture.getName() === name)!
    const [R, G, B] = [0x1000, 0x0100, 0x0010]
    expect(listTextureChannels(of('up'))).toEqual([R, G, B])
    expect(listTextureChannels(of('dry'))).toEqual([G])
    expect(listTextureChannels(of('shade'))).toEqual([R, G, B])
    expect(listTextureChannels(of('relief'))).toEqual([R])
    expect(listTextureChannels(of('weights 0'))).toEqual([R, G, B])
    expect(listTextureChannels(of('weights 1'))).toEqual([R, G])
    expect(listTextureSlots(of('up'))).toEqual(['normalTexture'])
    expect(listTextureSlots(of('weights 0'))).toEqual(['weightsTexture'])
    const colours = textures.filter((texture) => getTextureColorSpace(texture) === 'srgb')
    expect(colours.map((texture) => texture.getName())).toEqual(['colour', 'flushed'])
  })

  it('preserves a texture transform', async () => {
    const document = await createSample()
    const transform = document.createExtension(KHRTextureTransform).createTransform().setOffset([0.25, 0])
    const [layer] = wrinkleMapsOf(document).listLayers()
    layer.getTextureInfo('normalTexture')!.setTexCoord(1).setExtension('KHR_texture_transform', transform)
    const { json } = await io.writeJSON(document)
    expect(json.materials![0].extensions![NAME]).toMatchObject({
      layers: [
        {
          normalTexture: {
            scale: 0.5,
            texCoord: 1,
            extensions: { KHR_texture_transform: { offset: [0.25, 0] } },
          },
        },
        {},
      ],
    })
    const back = wrinkleMapsOf(await io.readBinary(await io.writeBinary(document)))
    const info = back.listLayers()[0].getTextureInfo('normalTexture')!
    expect(info.getTexCoord()).toBe(1)
    expect(info.getExtension<Transform>('KHR_texture_transform')!.getOffset()).toEqual([0.25, 0])
  })

  it('compares materials by their wrinkles', async () => {
    const [one, two] = await Promise.all([createSample(), createSample()])
    const materials = [one, two].map((document) => document.getRoot().listMaterials()[0])
    expect(materials[0].equals(materials[1])).toBe(true)
    wrinkleMapsOf(two).setDrivers([{ type: 'weather', area: 'brow' }])
    expect(materials[0].equals(materials[1])).toBe(false)
  })

  it.each<[string, (document: Awaited<ReturnType<typeof createSample>>) => void, string]>([
    ['a texture', (d) => wrinkleMapsOf(d).listAreas()[0].setTexture(null), 'area "brow" has no texture'],
    [
      'a normal map',
      (d) => wrinkleMapsOf(d).listLayers()[1].setTexture('normalTexture', null),
      'layer "down" has no normal texture',
    ],
    [
      'its layer',
      (d) => wrinkleMapsOf(d).removeLayer(wrinkleMapsOf(d).listLayers()[1]),
      'area "nose" has no layer of the same material',
    ],
    [
      'areas',
      (d) => {
        for (const area of wrinkleMapsOf(d).listAreas()) area.dispose()
      },
      'areas has the wrong number',
    ],
    [
      'a driven area',
      (d) => wrinkleMapsOf(d).setDrivers([{ type: 'morph', area: 'x', targets: [], curve: [] }]),
      'drivers[0].area is unknown, got "x"',
    ],
  ])('refuses to write wrinkles without %s', async (_, breakDocument, message) => {
    const document = await createSample()
    breakDocument(document)
    const failure = await io.writeBinary(document).catch((error) => error)
    expect(failure).toBeInstanceOf(FurrowError)
    expect(failure.message).toContain(`${NAME} of material 0 "skin": ${message}`)
  })
})

describe('a glTF-Transform script', () => {
  let before: ReturnType<typeof summary>
  let after: Awaited<ReturnType<typeof createSample>>

  beforeAll(async () => {
    const document = await createSample()
    // Gives the second layer a copy of the first layer's normal map, which dedup must merge.
    const twin = wrinkleMapsOf(document).listLayers()[1].getTexture('normalTexture')!
    twin.setImage(wrinkleMapsOf(document).listLayers()[0].getTexture('normalTexture')!.getImage()!)
    // Adds an image of one colour, which prune would replace by a factor.
    const white = { width: 8, height: 8, channels: 3 as const, background: '#fff' }
    const flat = await sharp({ create: white }).png().toBuffer()
    wrinkleMapsOf(document)
      .listLayers()[0]
      .getTexture('occlusionTexture')!
      .setImage(flat as Uint8Array as Uint8Array<ArrayBuffer>)
    before = summary(document)
    await document.transform(
      dedup(),
      prune(),
      textureCompress({ encoder: sharp, targetFormat: 'webp', resize: [8, 8], lossless: true }),
      quantize(),
      meshopt({ encoder: MeshoptEncoder, level: 'medium' }),
      unpartition(),
    )
    after = await io.readBinary(await io.writeBinary(document))
  })

  it('preserves every layer, area and driver in dedup, prune, resize, webp, quantize and meshopt', () => {
    const merged = structuredClone(before)
    merged.layers[1].textures[0] = 'up'
    expect(summary(after)).toEqual(merged)
  })

  it('leaves every image readable, in its new size and format', async () => {
    const wrinkles = wrinkleMapsOf(after)
    const images = [
      ...wrinkles.listAreas().map((area) => area.getTexture()!),
      ...wrinkles.listLayers().map((layer) => layer.getTexture('normalTexture')!),
    ]
    for (const image of images) {
      expect(image.getMimeType()).toBe('image/webp')
      expect(await sharp(image.getImage()!).metadata()).toMatchObject({ format: 'webp', width: 8, height: 8 })
    }
  })

  it('refers to WebP images only by their extension', async () => {
    const { json } = await io.writeJSON(after)
    expect(json.extensionsUsed).toEqual(
      expect.arrayContaining([NAME, 'EXT_texture_webp', 'EXT_meshopt_compression']),
    )
    for (const texture of json.textures!) {
      expect(texture.source).toBeUndefined()
      expect(texture.extensions!.EXT_texture_webp).toEqual({ source: expect.any(Number) })
    }
  })
})
