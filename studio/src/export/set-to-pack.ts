import { FurrowError, parseDrivers } from 'furrow'
import { checkStrokes, type MapToPack, type SetToPack } from 'furrow-files'
import { type DocumentToPack, type LayerMap, packedLayers } from '../document/packed-layers.ts'
import { strokesDocument } from '../document/stroke-document.ts'

/**
 * Converts a document to a wrinkle set, equal to the one that `furrow pack` reads from the document's folder.
 *
 * @param who module name for errors.
 * @throws FurrowError if there are no areas, or a driver is invalid.
 */
export function setToPack(source: DocumentToPack, who: string): SetToPack {
  const { document } = source
  const { mesh, material, areaSize, shapes } = document
  if (document.areas.length === 0) throw noAreasError(who)
  const layers = packedLayers(source).map(({ layer, maps, heightAmplitude }) => {
    const { name, kind, normalScale, occlusionStrength, bloodAmplitude, onsetStrength } = layer
    const images = Object.entries(maps).map(([map, image]) => [
      map,
      async () => mapToPack(image, `${map} of ${name}`),
    ])
    return {
      name,
      kind,
      normalScale,
      occlusionStrength,
      ...(heightAmplitude !== undefined && { heightAmplitude }),
      ...(bloodAmplitude !== undefined && { bloodAmplitude }),
      ...(onsetStrength !== undefined && { onsetStrength }),
      maps: Object.fromEntries(images) as SetToPack['layers'][number]['maps'],
    }
  })
  const strokes = strokesDocument(document)
  const layerNames = layers.map(({ name }) => name)
  const areaNames = document.areas.map(({ name }) => name)
  return {
    ...(mesh !== undefined && { mesh }),
    ...(material !== undefined && { material }),
    areaSize,
    layers,
    areas: document.areas.map(({ name, layer, combine, activation, weights }) => ({
      name,
      layer,
      combine,
      activation,
      weights: async () => weights,
    })),
    drivers: parseDrivers(document.drivers, areaNames, who),
    ...(shapes && { shapes }),
    ...(strokes && { strokes: async () => checkStrokes(strokes, layerNames, who) }),
  }
}

function mapToPack(map: LayerMap, path: string): MapToPack {
  return 'bytes' in map ? { path, bytes: map.bytes } : map
}

function noAreasError(who: string): FurrowError {
  return new FurrowError({
    who,
    problem: 'the document has no areas',
    limit: 'at least one',
    remedy: 'add an area, and paint it where wrinkles should appear',
  })
}
