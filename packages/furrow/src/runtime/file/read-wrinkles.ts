import { CHANNEL } from '../../core/channels.ts'
import type { FurrowError } from '../../core/error.ts'
import { WRINKLE_MAPS } from '../../core/maps/declared.ts'
import { DecodedBytes } from '../../core/maps/decoded-bytes.ts'
import type { WrinkleMapsLayer } from '../../core/maps/wrinkle-maps.ts'
import type { Area, ArraySlice, GrayImage, Layer, WrinkleSet } from '../../core/types.ts'
import type { WrinkleMaps } from '../../drivers/parse.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import { readUsualMaps } from '../../drivers/usual-maps.ts'
import { MAP_KINDS, type ValueKind } from '../layer-maps.ts'
import type { ArraySource } from './array-source.ts'
import { fileError } from './file-error.ts'
import { MapSource, once, UNREADABLE } from './map-source.ts'
import type { WrinkledFile } from './wrinkled-file.ts'

/** The wrinkles of a material in a file. */
export interface FileWrinkles {
  /** The same object for all faces that have the same material in the file. */
  set: WrinkleSet<ArraySlice>
  /** For `addDrivers`. */
  drivers: WrinkleDriver[]
}

/** How the wrinkles of materials are read. */
export interface ReadOptions {
  /** Is told of each malformed driver, which is then left out; by default it is thrown. */
  onFault?: (fault: FurrowError) => void
  /** Is told what a material has, before its images are decoded. */
  onMaps?: (maps: WrinkleMaps) => void
}

/**
 * Reads the wrinkles of materials, of each once; layers with heights have `readHeight`, see `RaisedLayer`.
 *
 * @returns a function of a material's index, which throws FurrowError when the extension is malformed or an image cannot be read.
 */
export function wrinkleReader(
  file: WrinkledFile,
  options: ReadOptions = {},
): (material: number) => Promise<FileWrinkles> {
  const known = new Map<number, Promise<FileWrinkles>>()
  const decoded = new DecodedBytes()
  const read = async (material: number): Promise<FileWrinkles> => {
    try {
      const json = extensionOf(material, file)
      const usual = readUsualMaps(json, file.json)
      const unusual = usual ? null : await importUnusual()
      const maps = usual ?? unusual!.parseMaps(json, file.json, options.onFault)
      options.onMaps?.(maps)
      const createSource = () => {
        const images = new MapSource(file, decoded)
        return unusual ? new unusual.ArraySource(images, file, decoded) : images
      }
      return { set: await readSet(maps, createSource), drivers: maps.drivers }
    } catch (error) {
      throw fileError(error, WRINKLE_MAPS, UNREADABLE)
    }
  }
  return (material) => once(known, material, () => read(material))
}

/** Begins to fetch what reads a file that is out of the usual, so that it arrives while the rest is loaded. */
export function prefetchUnusual({ json }: Pick<WrinkledFile, 'json'>): void {
  const { materials } = json
  if (!Array.isArray(materials)) return
  const all = materials.flatMap((material) => material?.extensions?.[WRINKLE_MAPS] ?? [])
  if (all.some((maps) => !readUsualMaps(maps, json))) importUnusual().catch(() => {})
}

/** What reads a file that is out of the usual, or says what is wrong with it. */
const importUnusual = () => import('./unusual-file.ts')

/** The extension's JSON of a material, malformed or not; undefined where it has none. */
export function extensionOf(material: number, { json }: Pick<WrinkledFile, 'json'>): unknown {
  return json.materials[material].extensions?.[WRINKLE_MAPS]
}

type Source = MapSource | ArraySource

async function readSet(maps: WrinkleMaps, createSource: () => Source): Promise<WrinkleSet<ArraySlice>> {
  const source = createSource()
  // Everything at once: what decodes images has several threads.
  const [layers, areas] = await Promise.all([
    Promise.all(maps.layers.map((layer) => readLayer(layer, source))),
    Promise.all(
      maps.areas.map(
        async ({ name, layer, texture, channel, combine, activation }): Promise<Area<ArraySlice>> => ({
          name,
          layer: maps.layers[layer].name,
          combine,
          activation,
          weights: await source.gray(texture, channel, 'areas'),
        }),
      ),
    ),
  ])
  const set = await source.finish({ layers, areas }, maps)
  for (const [i, { heightTexture }] of maps.layers.entries()) {
    if (!heightTexture) continue
    let height: Promise<GrayImage | ArraySlice> | undefined
    // By a source of its own: nothing else that was decoded stays in memory until heights are wanted. As precise as areas are: a surface
    // shows steps sooner than a colour does.
    const readHeight = () => (height ??= createSource().gray(heightTexture, CHANNEL.height, 'areas'))
    Object.assign(set.layers[i], { heightAmplitude: heightTexture.amplitude, readHeight })
  }
  return set
}

/** All maps but heights, which only relief needs. */
async function readLayer(maps: WrinkleMapsLayer, source: Source): Promise<Layer<ArraySlice>> {
  const { name, kind, normalTexture, occlusionTexture, bloodTexture } = maps
  const layer = { name, kind, normalScale: normalTexture.scale } as Layer<ArraySlice>
  const readMap = async (map: 'normal' | ValueKind) => {
    const texture = maps[`${map}Texture`]
    if (!texture) return
    if (map === 'normal') layer.normal = await source.colours(texture, 'maps')
    else if (map === 'baseColor') layer.baseColor = await source.colours(texture, 'colours')
    else layer[map] = await source.gray(texture, CHANNEL[map], 'maps')
  }
  await Promise.all(MAP_KINDS.map(readMap))
  if (occlusionTexture) layer.occlusionStrength = occlusionTexture.strength
  if (bloodTexture) layer.bloodAmplitude = bloodTexture.amplitude
  return layer
}
