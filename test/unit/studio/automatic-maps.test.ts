import type { GrayImage } from 'furrow'
import { autoWrinkles } from 'furrow/author'
import { findSkin } from 'furrow-files'
import { encodePng, packAuto, readDocument } from 'furrow-files/node'
import sharp from 'sharp'
import { beforeAll, describe, expect, it } from 'vitest'
import type { PackedWrinkles } from '../../../packages/files/src/pack/embed.ts'
import { autoMaps, automaticDocument, remake } from '../../../studio/src/document/automatic.ts'
import type { AutoSettings, ImageFile, StudioDocument } from '../../../studio/src/document/document.ts'
import { setLayer, setMap } from '../../../studio/src/document/layers.ts'
import { readProject } from '../../../studio/src/export/read-document.ts'
import { FACES } from '../author/auto/faces.ts'
import { opened, projectFiles } from './project-files.ts'

const SETTINGS: AutoSettings = { age: 60, strength: 1, size: 128, seed: 1 }
const AREA = 128

let document: StudioDocument
let packed: PackedWrinkles
let files: Map<string, Uint8Array>

beforeAll(async () => {
  const [[, path]] = FACES
  const { skin } = findSkin(await readDocument(path, 'test'), path, 'test')
  const wrinkles = autoWrinkles(skin, { ...SETTINGS, areaSize: AREA })
  const images = autoMaps(wrinkles).map(async ({ blood }) => ({ blood: await fileOf(blood) }))
  document = automaticDocument(wrinkles, SETTINGS, {}, await Promise.all(images))
  const drawn = new Map(wrinkles.layers.map(({ name, ...maps }) => [name, maps]))
  files = projectFiles({ document, drawn })
  packed = await packAuto(wrinkles, false, 'test')
})

async function fileOf(map: GrayImage): Promise<ImageFile> {
  return { mimeType: 'image/png', bytes: Uint8Array.from(await encodePng({ ...map, channels: 1 })) }
}

/** Returns one channel of an image file. */
async function channel(bytes: Uint8Array, index: 0 | 1 | 2 | 3): Promise<Buffer> {
  return sharp(bytes).toColourspace('srgb').removeAlpha().extractChannel(index).raw().toBuffer()
}

const text = (bytes: Uint8Array) => JSON.parse(new TextDecoder().decode(bytes))

describe('a project of automatic wrinkles equals the output of `furrow auto`', () => {
  it('in its areas and their layers, including areas that flush or turn pale', async () => {
    const { layers, areas } = text(files.get('wrinkles.json')!)
    const names = packed.layers.map(({ name }) => name)
    expect(areas.map(({ name, layer }: { name: string; layer: string }) => [name, layer])).toEqual(
      packed.areas.map(({ name, layer }) => [name, names[layer]]),
    )
    expect(areas.map(({ name }: { name: string }) => name)).toContain('flushBrows')
    expect(layers.map(({ name }: { name: string }) => name)).toEqual(names)
    for (const [i, { image, channel: index }] of packed.areas.entries()) {
      const own = await channel(files.get(areas[i].image)!, 0)
      expect(
        Buffer.from(own.map((value) => 255 - value)).equals(await channel(image.bytes, index as 0 | 1 | 2)),
      ).toBe(true)
    }
  })

  it('in its drivers', async () => {
    expect(text(files.get('wrinkles.json')!).drivers).toEqual(JSON.parse(JSON.stringify(packed.drivers)))
  })

  it('in the maps of each layer, including blood and onset', async () => {
    const { layers } = text(files.get('wrinkles.json')!)
    for (const [i, made] of packed.layers.entries()) {
      const own = layers[i]
      expect(own).toMatchObject({
        kind: made.kind,
        bloodAmplitude: made.bloodAmplitude,
        heightAmplitude: made.heightAmplitude,
      })
      const [occlusion, blood] = [files.get(own.occlusion)!, files.get(own.blood)!]
      // The layer of bulges has no onset map.
      expect(own.onset === undefined).toBe(i === packed.layers.length - 1)
      if (own.onset) {
        const onset = await channel(files.get(own.onset)!, 0)
        expect(onset.equals(await channel(made.onset!.bytes, 1))).toBe(true)
        expect(onset.some((value) => value > 0)).toBe(true)
      }
      expect((await channel(occlusion, 0)).equals(await channel(made.occlusion!.bytes, 0))).toBe(true)
      expect((await channel(blood, 0)).equals(await channel(made.blood!.bytes, 2))).toBe(true)
      expect((await channel(files.get(own.normal)!, 0)).equals(await channel(made.normal!.bytes, 0))).toBe(
        true,
      )
    }
  })

  it('after it is saved and read again with its automatic blood and drawn onset', async () => {
    const read = await readProject(opened(files), 'Face')
    expect(read.document.layers).toEqual(document.layers)
  })
})

describe('remaking automatic wrinkles', () => {
  let other: StudioDocument
  const image: ImageFile = { mimeType: 'image/png', bytes: Uint8Array.of(1, 2, 3) }
  const bloodOf = (each: StudioDocument, i = 0) => each.layers[i].maps.blood

  beforeAll(async () => {
    const layers = document.layers.map((layer) => ({
      ...layer,
      maps: { blood: { ...image } },
    }))
    other = { ...document, mapSize: 256, layers }
  })

  it('replaces the blood maps by those of the new lines, and keeps the strength that the artist set', () => {
    const { name } = document.layers[0]
    const made = remake(setLayer(document, name, { bloodAmplitude: 0.5 }), other)
    expect(bloodOf(made)).toBe(bloodOf(other))
    expect(made.layers[0]).toMatchObject({ bloodAmplitude: 0.5, isBloodAutomatic: true })
    // The automatic maps of the old project do not determine the size of the new maps.
    expect(made.mapSize).toBe(256)
    const stronger = { ...other, auto: { ...SETTINGS, strength: 2 } }
    expect(remake(made, stronger).layers[0].bloodAmplitude).toBe(other.layers[0].bloodAmplitude)
  })

  it('draws the onset maps from lines, unless the artist imported them', () => {
    const [{ name }] = document.layers
    const made = remake(setMap(document, name, 'blood', image), other)
    expect(made.layers[0].maps.onset).toBeUndefined()
    expect(made.layers[0].isOnsetDrawn).toBe(true)
    const kept = remake(setMap(document, name, 'onset', image), other).layers[0]
    expect(kept.maps.onset).toBe(image)
    expect(kept.isOnsetDrawn).toBeUndefined()
  })

  it('adds onset maps to a project that was made without them', () => {
    const layers = document.layers.map(({ isOnsetDrawn: _, ...layer }) => layer)
    const made = remake({ ...document, layers }, other)
    const drawn = (each: StudioDocument) => each.layers.map(({ isOnsetDrawn }) => isOnsetDrawn)
    expect(drawn(made)).toEqual(drawn(other))
    expect(drawn(made)).toContain(true)
  })

  it('keeps a blood map imported by the artist', () => {
    const [{ name }] = document.layers
    const made = remake(setMap(document, name, 'blood', image), other)
    expect(bloodOf(made)).toBe(image)
    expect(made.layers[0].isBloodAutomatic).toBeUndefined()
    expect(bloodOf(made, 1)).toBe(bloodOf(other, 1))
  })

  it('replaces areas that flush, except a painted one, which stays with its drivers', () => {
    const painted = document.areas.map((area) =>
      area.name === 'flushBrows' ? { ...area, isAutomatic: false } : area,
    )
    const made = remake({ ...document, areas: painted }, { ...other, areas: [], drivers: [] })
    expect(made.areas.map(({ name }) => name)).toEqual(['flushBrows'])
    expect(made.drivers.map(({ type }) => type)).toEqual(['morph', 'time'])
  })
})
