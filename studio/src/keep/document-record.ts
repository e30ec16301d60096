import { FurrowError, type GrayImage } from 'furrow'
import type { ImageFile, StudioDocument } from '../document/document.ts'
import { type Sculpted, type SculptedTile, TILE_TEXELS } from '../document/sculpted.ts'
import { parseStored, type StoredDocument, type StoredSculpted } from './stored-document.ts'

/** Version of the record's format. */
const VERSION = 1

/** Document in the database. It has a number in place of each image, and a separate record stores the image. */
export interface DocumentRecord {
  version: number
  document: StoredDocument
}

/** Weights of an area, an encoded map, a tile of sculpted heights, or the weights of a take. */
export type ImageRecord = GrayImage | ImageFile | SculptedTile | Float32Array

export function imagesOf({ layers, areas, takes = [] }: StudioDocument): Set<ImageRecord> {
  return new Set([
    ...layers.flatMap(({ maps }) => Object.values(maps)),
    ...layers.flatMap(({ sculpted }) => [...(sculpted?.tiles.values() ?? [])]),
    ...areas.map(({ weights }) => weights),
    ...takes.map(({ motion }) => motion.weights),
  ])
}

/** Makes the record of a document. @param numberOf returns the number of an image. */
export function recordOf(document: StudioDocument, numberOf: (image: ImageRecord) => number): DocumentRecord {
  const layers = document.layers.map(({ sculpted, ...layer }) => ({
    ...layer,
    maps: Object.fromEntries(Object.entries(layer.maps).map(([name, image]) => [name, numberOf(image)])),
    ...(sculpted && { sculpted: recordOfSculpted(sculpted, numberOf) }),
  }))
  const areas = document.areas.map((area) => ({ ...area, weights: numberOf(area.weights) }))
  const { takes, ...others } = document
  const stored = takes?.map(({ motion: { names, weights }, ...take }) => {
    return { ...take, names: [...names], weights: numberOf(weights) }
  })
  return { version: VERSION, document: { ...others, layers, areas, ...(stored && { takes: stored }) } }
}

function recordOfSculpted(
  { size, tiles }: Sculpted,
  numberOf: (image: ImageRecord) => number,
): StoredSculpted {
  return { size, tiles: Array.from(tiles, ([index, tile]) => [index, numberOf(tile)]) }
}

/**
 * Restores the document of a record.
 *
 * @param images stored images. The keys are their numbers.
 * @param name project name, for errors.
 * @throws FurrowError if a later version wrote the record, or if a part is missing or invalid.
 */
export function documentOf(
  record: DocumentRecord | undefined,
  images: ReadonlyMap<number, ImageRecord>,
  name: string,
): StudioDocument {
  if (!record) throw damagedError(name, 'it has no document')
  checkVersion(record.version, name)
  try {
    const document = parseStored(record.document)
    const layers = document.layers.map(({ sculpted, ...layer }) => ({
      ...layer,
      maps: Object.fromEntries(
        Object.entries(layer.maps).map(([map, number]) => [map, mapOf(images.get(number), map)]),
      ),
      ...(sculpted && {
        sculpted: {
          size: sculpted.size,
          tiles: new Map(sculpted.tiles.map(([i, number]) => [i, tileOf(images.get(number), layer.name)])),
        },
      }),
    }))
    const areas = document.areas.map((area) => ({
      ...area,
      weights: weightsOf(images.get(area.weights), area.name, document.areaSize),
    }))
    const { takes, ...others } = document
    const read = takes?.map(({ names, weights, ...take }) => {
      return { ...take, motion: { names, weights: motionOf(images.get(weights), take.name, names.length) } }
    })
    return { ...others, layers, areas, ...(read && { takes: read }) }
  } catch (error) {
    throw damagedError(name, error instanceof Missing ? error.message : reasonOf(error), error)
  }
}

/** Throws FurrowError if a later version wrote the record. */
export function checkVersion(version: unknown, name: string): void {
  if (version === VERSION) return
  throw new FurrowError({
    code: 'unsupported',
    who: 'Studio',
    problem: `${name} was stored by a later version of the studio`,
    value: version,
    limit: `${VERSION}`,
    remedy: 'reload the page',
  })
}

class Missing extends Error {}

function reasonOf(error: unknown): string {
  return error instanceof FurrowError ? `its document: ${error.problem}` : 'its document is incomplete'
}

function mapOf(image: ImageRecord | undefined, map: string): ImageFile {
  if (image && 'bytes' in image && image.bytes instanceof Uint8Array) return image
  throw new Missing(`its map ${map} is missing`)
}

function weightsOf(image: ImageRecord | undefined, area: string, side: number): GrayImage {
  if (image && 'data' in image && image.width === side && image.data.length === side * side) return image
  throw new Missing(`its area ${area} is missing`)
}

function tileOf(image: ImageRecord | undefined, layer: string): SculptedTile {
  if (image instanceof Int16Array && image.length === TILE_TEXELS) return image
  throw new Missing(`its sculpted heights of ${layer} are missing`)
}

function motionOf(weights: ImageRecord | undefined, take: string, shapes: number): Float32Array {
  if (weights instanceof Float32Array && weights.length % shapes === 0 && weights.length >= 2 * shapes)
    return weights
  throw new Missing(`its take ${take} is missing`)
}

function damagedError(name: string, reason: string, cause?: unknown): FurrowError {
  const problem = `cannot open ${name} (${reason})`
  const remedy = 'open its folder or file, if you saved one'
  return new FurrowError({ code: 'unreadable', who: 'Studio', problem, remedy }, { cause })
}
