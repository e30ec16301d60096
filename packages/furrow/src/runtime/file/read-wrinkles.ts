import { CHANNEL } from '../../core/channels.ts'
import type { FurrowError } from '../../core/error.ts'
import { checkDeclared, WRINKLE_MAPS } from '../../core/maps/declared.ts'
import { DecodedBytes } from '../../core/maps/decoded-bytes.ts'
import type { WrinkleMapsLayer } from '../../core/maps/wrinkle-maps.ts'
import type { Area, ArraySlice, GrayImage, Layer, WrinkleSet } from '../../core/types.ts'
import { parseWrinkleMaps, type WrinkleMaps } from '../../drivers/parse.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import { MAP_KINDS, type ValueKind } from '../maps/layer-maps.ts'
import { fileError } from './file-error.ts'
import type { GltfSource } from './gltf-source.ts'
import { cached, MapSource, UNREADABLE } from './map-source.ts'

/** Wrinkles of one material in a glTF file. */
export interface FileWrinkles {
  /** Layers and areas. All faces with the material share this object. */
  set: WrinkleSet<ArraySlice>
  /** Drivers to pass to `addDrivers`. */
  drivers: WrinkleDriver[]
}

/** Is called once per material with the errors of malformed drivers. These drivers are skipped. */
export type OnDriverErrors = (errors: readonly FurrowError[]) => void

/**
 * Creates a function that reads the wrinkles of a material and caches them. Layers with a height map get a method `readHeight`; see
 * `RaisedLayer`.
 *
 * @param onDriverErrors receives the errors of malformed drivers. Without it, the first error is thrown.
 * @returns a function of the material's index. It throws a FurrowError if the extension is malformed or an image cannot be read.
 */
export function wrinkleReader(
  file: GltfSource,
  onDriverErrors?: OnDriverErrors,
): (material: number) => Promise<FileWrinkles> {
  const known = new Map<number, Promise<FileWrinkles>>()
  const decoded = new DecodedBytes()
  const read = async (material: number): Promise<FileWrinkles> => {
    try {
      const { textures } = file.json
      const count = Array.isArray(textures) ? textures.length : 0
      const errors: FurrowError[] = []
      const onError = onDriverErrors && ((error: FurrowError) => errors.push(error))
      const maps = parseWrinkleMaps(extensionOf(material, file), count, WRINKLE_MAPS, onError)
      if (errors.length > 0) onDriverErrors?.(errors)
      checkDeclared(file.json, WRINKLE_MAPS)
      return { set: await readSet(maps, () => new MapSource(file, decoded)), drivers: maps.drivers }
    } catch (error) {
      throw fileError(error, WRINKLE_MAPS, UNREADABLE)
    }
  }
  return (material) => cached(known, material, () => read(material))
}

/** Returns the unchecked JSON of the wrinkle extension in a material, or undefined if there is none. */
export function extensionOf(material: number, { json }: Pick<GltfSource, 'json'>): unknown {
  return json.materials[material].extensions?.[WRINKLE_MAPS]
}

async function readSet(maps: WrinkleMaps, createSource: () => MapSource): Promise<WrinkleSet<ArraySlice>> {
  const source = createSource()
  // Maps are read in parallel, because browsers decode images on several threads.
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
    // Heights are read later, from another source, so that `source` and its decoded images can be freed now. Heights use the GPU format of
    // areas, which is more precise than the format of other maps. Rounding steps are more visible in a surface than in colours.
    const readHeight = () => (height ??= createSource().gray(heightTexture, CHANNEL.height, 'areas'))
    Object.assign(set.layers[i], { heightAmplitude: heightTexture.amplitude, readHeight })
  }
  return set
}

/** Reads all maps of a layer except the height map, which only relief needs. */
async function readLayer(maps: WrinkleMapsLayer, source: MapSource): Promise<Layer<ArraySlice>> {
  const { name, kind, normalTexture, occlusionTexture, bloodTexture, onsetTexture } = maps
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
  if (onsetTexture) layer.onsetStrength = onsetTexture.strength
  return layer
}
