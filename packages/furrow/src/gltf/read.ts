import type { GLTF, ReaderContext, Texture, TextureInfo } from '@gltf-transform/core'
import { FurrowError } from '../core/error.ts'
import { WRINKLE_MAPS } from '../core/maps/declared.ts'
import { parseWrinkleMaps } from '../drivers/parse.ts'
import type { MaterialWrinkles } from './material-wrinkles.ts'
import type { WrinkleArea } from './wrinkle-area.ts'
import { LAYER_SLOTS, type LayerSlot, type WrinkleLayer } from './wrinkle-layer.ts'

type Json = Record<string, unknown>

/** Methods of `FurrowWrinkleMaps` that create properties of a glTF-Transform document. */
interface PropertyFactory {
  createMaterialWrinkles(): MaterialWrinkles
  createLayer(name: string): WrinkleLayer
  createArea(name: string): WrinkleArea
}

/** Fields of the extension's JSON that `MaterialWrinkles`, `WrinkleLayer` and `WrinkleArea` represent. Other fields are kept as unknown. */
const KNOWN = {
  root: ['name', 'extras', 'layers', 'areas', 'drivers', 'strokes', 'shapes'],
  layer: ['name', 'extras', 'kind', ...Object.keys(LAYER_SLOTS)],
  area: ['name', 'extras', 'layer', 'texture', 'channel', 'combine', 'activation'],
}

/**
 * Reads the wrinkles of one material.
 *
 * @param who name of the material in errors.
 * @throws FurrowError that names the first invalid field.
 */
export function readMaterialWrinkles(
  properties: PropertyFactory,
  context: ReaderContext,
  material: GLTF.IMaterial,
  who: string,
): MaterialWrinkles {
  const json = material.extensions?.[WRINKLE_MAPS]
  const maps = parseWrinkleMaps(json, context.jsonDoc.json.textures?.length ?? 0, who)
  const raw = json as Json & { layers: Json[]; areas: Json[] }
  const textureAt = (at: number) => textureOf(context, at, who)

  const layers = maps.layers.map((layer, i) => {
    const property = properties
      .createLayer(layer.name)
      .setKind(layer.kind)
      .setNormalScale(layer.normalTexture.scale)
      .setOcclusionStrength(layer.occlusionTexture?.strength ?? 1)
      .setHeightAmplitude(layer.heightTexture?.amplitude ?? 0)
      .setBloodAmplitude(layer.bloodTexture?.amplitude ?? 0)
      .setOnsetStrength(layer.onsetTexture?.strength ?? 1)
      .setExtras(extrasOf(raw.layers[i]))
      .setUnknownFields(without(raw.layers[i], KNOWN.layer))
    for (const slot of Object.keys(LAYER_SLOTS) as LayerSlot[]) {
      const info = layer[slot]
      if (!info) continue
      property.setTexture(slot, textureAt(info.index)).setSlice(slot, info.slice ?? null)
      readTextureInfo(context, property.getTextureInfo(slot)!, info, who)
    }
    return property
  })
  const areas = maps.areas.map((area, i) => {
    const property = properties
      .createArea(area.name)
      .setLayer(layers[area.layer])
      .setTexture(textureAt(area.texture.index), area.channel)
      .setSlice(area.texture.slice ?? null)
      .setCombine(area.combine)
      .setActivation(area.activation)
      .setExtras(extrasOf(raw.areas[i]))
      .setUnknownFields(without(raw.areas[i], KNOWN.area))
    readTextureInfo(context, property.getTextureInfo()!, area.texture, who)
    return property
  })

  const wrinkles = properties.createMaterialWrinkles()
  for (const layer of layers) wrinkles.addLayer(layer)
  for (const area of areas) wrinkles.addArea(area)
  return wrinkles
    .setDrivers(maps.drivers)
    .setStrokes(raw.strokes)
    .setShapes(raw.shapes)
    .setExtras(extrasOf(raw))
    .setUnknownFields(without(raw, KNOWN.root))
}

/** Returns the texture with an index in the glTF file. Throws if the texture has no image that glTF-Transform has read. */
function textureOf(context: ReaderContext, index: number, who: string): Texture {
  const texture = context.textures[context.jsonDoc.json.textures![index]?.source ?? -1]
  if (texture) return texture
  throw new FurrowError({
    code: 'unreadable',
    who,
    problem: 'texture without a readable image',
    value: index,
    remedy: 'register the extension of its image format, or export the file again',
  })
}

function readTextureInfo(context: ReaderContext, info: TextureInfo, def: { index: number }, who: string) {
  const { texCoord, extras } = def as GLTF.ITextureInfo
  const sampler = context.jsonDoc.json.textures![def.index].sampler
  const wrong =
    (texCoord !== undefined &&
      !(Number.isInteger(texCoord) && texCoord >= 0) &&
      'texCoord is not an index') ||
    (extras !== undefined && !isObject(extras) && 'extras are not an object') ||
    (sampler !== undefined && !context.jsonDoc.json.samplers?.[sampler] && 'sampler is missing')
  if (wrong) {
    throw new FurrowError({
      who,
      problem: `${wrong} at texture ${def.index}`,
      remedy: 'export the file again',
    })
  }
  context.setTextureInfo(info, def as GLTF.ITextureInfo)
}

function extrasOf(json: Json): Json {
  return isObject(json.extras) ? json.extras : {}
}

function isObject(value: unknown): value is Json {
  return typeof value === 'object' && value !== null && !Array.isArray(value)
}

function without(json: Json, known: readonly string[]): Json {
  return Object.fromEntries(Object.entries(json).filter(([key]) => !known.includes(key)))
}
