import { addArea } from './areas.ts'
import type { ImageFile, MapName, StudioDocument } from './document.ts'
import { isActivated } from './drivers.ts'
import { type LayerFields, setLayer, setMap } from './layers.ts'
import { freeName } from './names.ts'

/** Default amplitudes of imported maps. */
const AMPLITUDES: Partial<Record<MapName, LayerFields>> = {
  /** Height difference between black and white, metres. */
  height: { heightAmplitude: 0.002 },
  /** Optical depth. With this default, white is a clearly visible flush. */
  blood: { bloodAmplitude: 0.3 },
}

/** Name of the area over the whole skin that shows an imported map. */
const WHOLE_SKIN = 'wholeSkin'

/**
 * Puts an image into a layer. Height and blood maps get a default amplitude if the layer has none. If nothing shows the layer, adds an area over
 * the whole skin that is always visible.
 *
 * @throws FurrowError if the layer is unknown, or the area is needed and there are already 256 areas.
 */
export function importMap(
  document: StudioDocument,
  layer: string,
  map: MapName,
  image: ImageFile,
): StudioDocument {
  const old = document.layers.find(({ name }) => name === layer)
  const missing = Object.entries(AMPLITUDES[map] ?? {}).filter(
    ([field]) => old?.[field as keyof LayerFields] === undefined,
  )
  const imported = setLayer(setMap(document, layer, map, image), layer, Object.fromEntries(missing))
  return isShown(document, layer) ? imported : addWholeSkin(imported, layer)
}

/** Whether an area that is not empty shows a layer, at rest or by a driver. */
function isShown(document: StudioDocument, layer: string): boolean {
  return document.areas.some(
    ({ name, layer: own, weights }) =>
      own === layer && isActivated(document, name) && weights.data.some((weight) => weight > 0),
  )
}

function addWholeSkin(document: StudioDocument, layer: string): StudioDocument {
  const { areaSize: side, areas } = document
  const weights = { width: side, height: side, data: new Uint8Array(side * side).fill(255) }
  return addArea(document, {
    name: freeName(areas, WHOLE_SKIN),
    layer,
    combine: 'sum',
    activation: 1,
    weights,
  })
}
