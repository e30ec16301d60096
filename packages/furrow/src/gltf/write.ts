import type { Property, Texture, TextureInfo, WriterContext } from '@gltf-transform/core'
import { FurrowError } from '../core/error.ts'
import { parseWrinkleMaps } from '../drivers/parse.ts'
import type { MaterialWrinkles } from './material-wrinkles.ts'
import type { WrinkleArea } from './wrinkle-area.ts'
import { LAYER_SLOTS, type LayerSlot, type WrinkleLayer } from './wrinkle-layer.ts'

type Json = Record<string, unknown>

/**
 * Creates the extension's JSON for one material. Fields with default values are omitted.
 *
 * @param who name of the material in errors.
 * @throws FurrowError if a texture or layer is missing, or if a value is invalid.
 */
export function writeMaterialWrinkles(context: WriterContext, wrinkles: MaterialWrinkles, who: string): Json {
  const layers = wrinkles.listLayers()
  const drivers = wrinkles.getDrivers()
  const strokes = wrinkles.getStrokes()
  const shapes = wrinkles.getShapes()
  const json = {
    ...wrinkles.getUnknownFields(),
    ...context.createPropertyDef(wrinkles),
    layers: layers.map((layer) => writeLayer(context, layer, who)),
    areas: wrinkles.listAreas().map((area) => writeArea(context, area, layers, who)),
    ...(drivers.length > 0 && { drivers }),
    ...(strokes !== null && { strokes }),
    ...(shapes !== null && { shapes }),
  }
  parseWrinkleMaps(json, Infinity, who)
  return json
}

function writeLayer(context: WriterContext, layer: WrinkleLayer, who: string): Json {
  const json: Json = { ...layer.getUnknownFields(), ...context.createPropertyDef(layer) }
  if (layer.getKind() !== 'replace') json.kind = layer.getKind()
  if (!layer.getTexture('normalTexture')) throw missing(who, 'layer', layer, 'normal texture')
  for (const slot of Object.keys(LAYER_SLOTS) as LayerSlot[]) {
    const info = textureInfo(context, layer.getTexture(slot), layer.getTextureInfo(slot))
    if (info) json[slot] = Object.assign(info, sliceOf(layer.getSlice(slot)), numberOf(slot, layer))
  }
  return json
}

function sliceOf(slice: number | null): Json {
  return slice === null ? {} : { slice }
}

function numberOf(slot: LayerSlot, layer: WrinkleLayer): Json {
  if (slot === 'heightTexture') return { amplitude: layer.getHeightAmplitude() }
  if (slot === 'bloodTexture') return { amplitude: layer.getBloodAmplitude() }
  if (slot === 'normalTexture' && layer.getNormalScale() !== 1) return { scale: layer.getNormalScale() }
  if (slot === 'occlusionTexture' && layer.getOcclusionStrength() !== 1) {
    return { strength: layer.getOcclusionStrength() }
  }
  if (slot === 'onsetTexture' && layer.getOnsetStrength() !== 1) return { strength: layer.getOnsetStrength() }
  return {}
}

function writeArea(
  context: WriterContext,
  area: WrinkleArea,
  layers: readonly WrinkleLayer[],
  who: string,
): Json {
  const json: Json = { ...area.getUnknownFields(), ...context.createPropertyDef(area) }
  const own = area.getLayer()
  const layer = own ? layers.indexOf(own) : 0
  if (layer < 0) throw missing(who, 'area', area, 'layer of the same material')
  if (layer > 0) json.layer = layer
  const info = textureInfo(context, area.getTexture(), area.getTextureInfo())
  if (!info) throw missing(who, 'area', area, 'texture')
  json.texture = Object.assign(info, sliceOf(area.getSlice()))
  if (area.getChannel() !== 0) json.channel = area.getChannel()
  if (area.getCombine() !== 'sum') json.combine = area.getCombine()
  if (area.getActivation() !== 0) json.activation = area.getActivation()
  return json
}

/** Creates a glTF texture info. The object must not be copied, because other extensions may modify it later. */
function textureInfo(context: WriterContext, texture: Texture | null, info: TextureInfo | null) {
  return texture && info && context.createTextureInfoDef(texture, info)
}

function missing(who: string, kind: string, property: Property, part: string): FurrowError {
  return new FurrowError({
    who,
    problem: `${kind} "${property.getName()}" has no ${part}`,
    remedy: `set a ${part}, or remove the ${kind}`,
  })
}
