import { CHANNEL } from '../../core/channels.ts'
import type { FurrowError } from '../../core/error.ts'
import { checkDeclared, WRINKLE_MAPS } from '../../core/maps/declared.ts'
import { DecodedBytes } from '../../core/maps/decoded-bytes.ts'
import type { WrinkleMapsLayer } from '../../core/maps/wrinkle-maps.ts'
import type { Area, ArraySlice, GrayImage, Layer, WrinkleSet } from '../../core/types.ts'
import { parseWrinkleMaps, type WrinkleMaps } from '../../drivers/parse.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import { MAP_KINDS, type ValueKind } from '../layer-maps.ts'
import { fileError } from './file-error.ts'
import type { GltfSource } from './gltf-source.ts'
import { MapSource, once, UNREADABLE } from './map-source.ts'

/** The wrinkles of a material in a file. */
export interface FileWrinkles {
  /** The same object for all faces that have the same material in the file. */
  set: WrinkleSet<ArraySlice>
  /** For `addDrivers`. */
  drivers: WrinkleDriver[]
}

/** Called once per material with the faults of its malformed drivers, which are left out. Without it, the first is thrown. */
export type OnFaults = (faults: readonly FurrowError[]) => void

/**
 * Reads the wrinkles of materials, each material once. Layers with heights get `readHeight`, see `RaisedLayer`.
 *
 * @returns a function of a material's index, which throws FurrowError when the extension is malformed or an image cannot be read.
 */
export function wrinkleReader(
  file: GltfSource,
  onFaults?: OnFaults,
): (material: number) => Promise<FileWrinkles> {
  const known = new Map<number, Promise<FileWrinkles>>()
  const decoded = new DecodedBytes()
  const read = async (material: number): Promise<FileWrinkles> => {
    try {
      const { textures } = file.json
      const count = Array.isArray(textures) ? textures.length : 0
      const faults: FurrowError[] = []
      const onFault = onFaults && ((fault: FurrowError) => faults.push(fault))
      const maps = parseWrinkleMaps(extensionOf(material, file), count, WRINKLE_MAPS, onFault)
      if (faults.length > 0) onFaults?.(faults)
      checkDeclared(file.json, WRINKLE_MAPS)
      return { set: await readSet(maps, () => new MapSource(file, decoded)), drivers: maps.drivers }
    } catch (error) {
      throw fileError(error, WRINKLE_MAPS, UNREADABLE)
    }
  }
  return (material) => once(known, material, () => read(material))
}

/** The extension's JSON of a material, malformed or not; undefined where it has none. */
export function extensionOf(material: number, { json }: Pick<GltfSource, 'json'>): unknown {
  return json.materials[material].extensions?.[WRINKLE_MAPS]
}

async function readSet(maps: WrinkleMaps, createSource: () => MapSource): Promise<WrinkleSet<ArraySlice>> {
  const source = createSource()
  // All at once: browsers decode images on several threads.
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
    // A separate source, so that no other decoded image stays in memory until heights are wanted. Heights are as precise as areas: a
    // surface shows steps sooner than a colour does.
    const readHeight = () => (height ??= createSource().gray(heightTexture, CHANNEL.height, 'areas'))
    Object.assign(set.layers[i], { heightAmplitude: heightTexture.amplitude, readHeight })
  }
  return set
}

/** All maps but heights, which only relief needs. */
async function readLayer(maps: WrinkleMapsLayer, source: MapSource): Promise<Layer<ArraySlice>> {
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
