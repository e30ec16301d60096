import { type AutoWrinkles, strokesOf } from 'furrow/author'
import { type AutoSettings, LAYER_DEFAULTS, type LayerStroke, type StudioDocument } from './document.ts'

/** A document of automatic wrinkles: their lines as strokes, which draw the maps; areas, drivers and expressions. */
export function automaticDocument(
  wrinkles: AutoWrinkles,
  auto: AutoSettings,
  areaSize: number,
  names: Pick<StudioDocument, 'mesh' | 'material'>,
): StudioDocument {
  const { layers, areas, expressions, scale } = wrinkles
  return {
    ...names,
    scale,
    mapSize: auto.size,
    areaSize,
    layers: layers.map(({ name }) => ({ ...LAYER_DEFAULTS, name })),
    areas: areas.map(({ name, layer, weights }) => ({
      name,
      layer: layers[layer].name,
      combine: 'sum',
      activation: 0,
      weights,
    })),
    strokes: strokesOf(wrinkles).strokes as LayerStroke[],
    drivers: [...areas.map(({ driver }) => driver), ...expressions],
    auto,
  }
}
