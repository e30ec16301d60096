import type { GrayImage, WrinkleSetDocument } from 'furrow'
import { fileNamesOf, type TextureReference } from 'furrow/internal'
import { checkDecodable, decodeImage, encodeMap } from '#images'
import { utf8 } from '../base/bytes.ts'
import { jsonFile } from '../base/json-file.ts'
import type { OutputFile } from '../base/output-file.ts'
import type { Progress } from '../base/progress.ts'
import { imageOf, isKtx2 } from '../gltf/texture-image.ts'
import { pixelsOf } from '../gltf/texture-pixels.ts'
import { paintedArea } from '../images/painted-area.ts'
import { isOpaque, withoutAlpha } from '../images/pixels.ts'
import { correctionsIn } from '../json/corrections.ts'
import { namesOfTarget, targetOfMaterial } from '../json/target-names.ts'
import { addressOf, STROKES_FILE, WRINKLES_FILE } from './folder-document.ts'
import { weightsOf } from './inspect.ts'
import { MAP_SLOTS } from './map-slots.ts'
import { partOfImage } from './shared-image.ts'
import { strokesIn } from './strokes.ts'
import type { WrinkledFile } from './wrinkled-file.ts'

type LayerEntry = WrinkleSetDocument['layers'][number]

/** Files of an unpacked wrinkle set, with paths relative to its folder. */
export interface UnpackedWrinkles {
  files: OutputFile[]
  warnings: string[]
}

/**
 * Converts the wrinkles of a material to the files of a folder: `wrinkles.json`, `layers/NAME/*.png`, `areas/NAME.png`
 * and `strokes.json`. If a name is not valid as a file name, the path contains a valid name instead, and
 * `wrinkles.json` keeps the name.
 *
 * @param whiteIsVisible how areas are written: true for white = visible, false for black = visible (as in the paper of
 *   Reis, De Martino and Batagelo).
 * @throws FurrowError if an image cannot be decoded.
 */
export async function unpackWrinkles(
  file: WrinkledFile,
  whiteIsVisible: boolean,
  who: string,
  progress: Progress,
): Promise<UnpackedWrinkles> {
  const { maps } = file
  const total = maps.layers.length + maps.areas.length
  const outputs: OutputFile[] = []
  const layers: LayerEntry[] = []
  const fileNames = fileNamesOf(maps.layers.map(({ name }) => name))
  for (const [i, layer] of maps.layers.entries()) {
    const entry: Partial<LayerEntry> = { name: layer.name, kind: layer.kind }
    for (const [map, slot] of MAP_SLOTS) {
      const info = layer[slot]
      if (!info) continue
      const path = `layers/${fileNames[i]}/${map}.png`
      const part = await partOfImage(file.glb, layer, map, who)
      outputs.push({
        path,
        bytes: part ? await encodeMap({ ...part, channels: 1 }) : await pngOf(file, info, who),
      })
      entry[map] = addressOf(path)
    }
    if (layer.normalTexture.scale !== 1) entry.normalScale = layer.normalTexture.scale
    if (layer.occlusionTexture && layer.occlusionTexture.strength !== 1) {
      entry.occlusionStrength = layer.occlusionTexture.strength
    }
    if (layer.bloodTexture) entry.bloodAmplitude = layer.bloodTexture.amplitude
    if (layer.onsetTexture && layer.onsetTexture.strength !== 1) {
      entry.onsetStrength = layer.onsetTexture.strength
    }
    if (layer.heightTexture) entry.heightAmplitude = layer.heightTexture.amplitude
    layers.push(entry as LayerEntry)
    progress(i + 1, total)
  }

  const areas = await Promise.all(maps.areas.map((_, i) => weightsOf(file, i, who)))
  const areaFiles = fileNamesOf(maps.areas.map(({ name }) => name))
  const areaEntries: WrinkleSetDocument['areas'] = []
  for (const [i, area] of maps.areas.entries()) {
    const path = `areas/${areaFiles[i]}.png`
    outputs.push({ path, bytes: await encodeWeights(areas[i], whiteIsVisible) })
    areaEntries.push({
      name: area.name,
      image: addressOf(path),
      ...(area.layer !== 0 && { layer: layers[area.layer].name }),
      ...(area.combine !== 'sum' && { combine: area.combine }),
      ...(whiteIsVisible && { convention: 'weight' as const }),
      ...(area.activation !== 0 && { activation: area.activation }),
    })
    progress(layers.length + i + 1, total)
  }

  const { strokes, problem } = strokesIn(file, `${who}: the strokes are left out`)
  if (strokes) outputs.push({ path: STROKES_FILE, bytes: jsonFile(strokes) })
  const shapes = correctionsIn(file.glb.json, file.material, `${who}: a correction is left out`)
  const target = targetOfMaterial(file.glb.json, file.material, maps.drivers)
  const document: WrinkleSetDocument = {
    version: 1,
    ...(target && namesOfTarget(file.glb.json, target)),
    layers,
    areas: areaEntries,
    ...(maps.drivers.length > 0 && { drivers: maps.drivers }),
    areaSize: Math.max(2, ...areas.flatMap(({ width, height }) => [width, height])),
    ...(strokes && { strokes: STROKES_FILE }),
    ...(shapes.corrections.length > 0 && { shapes: shapes.corrections }),
  }
  const text = `${JSON.stringify(document, null, 2)}\n`
  const warnings = [problem, shapes.problem].filter((text) => text !== undefined)
  return { files: [{ path: WRINKLES_FILE, bytes: utf8(text) }, ...outputs], warnings }
}

/** Returns a map as a PNG file. If its image is already PNG, checks that it decodes and returns its bytes unchanged. */
async function pngOf({ glb }: WrinkledFile, info: TextureReference, who: string): Promise<Uint8Array> {
  const image = imageOf(glb, info.index, who)
  if (image.mimeType === 'image/png') {
    await checkDecodable(image.bytes, `"${image.name}"`, who)
    return image.bytes
  }
  const pixels = isKtx2(image)
    ? await pixelsOf(glb, info, who)
    : await decodeImage(image.bytes, `"${image.name}"`, who)
  return encodeMap(isOpaque(pixels) ? withoutAlpha(pixels) : pixels)
}

/** Encodes an area as 8-bit gray PNG. */
function encodeWeights(area: GrayImage, whiteIsVisible: boolean): Promise<Uint8Array> {
  return encodeMap(whiteIsVisible ? { ...area, channels: 1 } : paintedArea(area))
}
