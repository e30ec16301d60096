import type { GrayImage } from 'furrow'
import type { AutoWrinkles, HeightMap } from 'furrow/author'
import { type Bounds, CHANNEL, channelOf, hasOnset, resampleGray } from 'furrow/internal'
import { decodeImage } from 'furrow/three'
import type { AutoMaps } from '../document/automatic.ts'
import type { ImageFile, LayerStroke, MapName, StudioDocument, StudioLayer } from '../document/document.ts'
import type { DrawnMaps } from '../document/drawn-maps.ts'
import { strokesOf } from '../document/strokes.ts'
import type { SkinSource } from '../open/skin-source.ts'
import type { LayerMaps } from '../viewer/document-view.ts'
import { Drawing } from './drawing.ts'

/** For each layer whose maps were updated in place: the changed rectangles, in texels. */
export type MapChanges = ReadonlyMap<LayerMaps, readonly Bounds[]>

/** Makes the maps of a document's layers: decodes their images, and lets a worker draw wrinkle strokes and sculpted heights over them. */
export class MapMaker {
  #drawing: Drawing | null = null
  #source: SkinSource | null = null
  #size = 0
  #changes = new Map<LayerMaps, Bounds[]>()
  readonly #combined = new WeakMap<DrawnMaps, LayerMaps>()
  readonly #onEnd: (error: unknown) => void

  /** @param onEnd called when the worker dies. The next call of `make` starts another worker. */
  constructor(onEnd: (error: unknown) => void) {
    this.#onEnd = onEnd
  }

  /**
   * Makes the maps of each layer, in the order of the layers. For maps that are unchanged or updated in place, returns the same objects as the
   * last call. Calls must not overlap. If the worker dies, starts another one and draws everything again.
   */
  async make(document: StudioDocument, source: SkinSource): Promise<LayerMaps[]> {
    try {
      return await this.#make(document, source)
    } catch (error) {
      const hasEnded = this.#drawing === null && (error as Error).name !== 'AbortError'
      if (!hasEnded) throw error
      return this.#make(document, source)
    }
  }

  async #make(document: StudioDocument, source: SkinSource): Promise<LayerMaps[]> {
    const drawing = await this.#begin(document, source)
    const maps: LayerMaps[] = []
    for (const layer of document.layers) {
      maps.push(await this.#makeLayer(drawing, layer, strokesOf(document, layer.name)))
    }
    return maps
  }

  /**
   * Uses the maps of automatic wrinkles. They already contain the strokes of the document, so `make` need not draw strokes.
   *
   * @param images decoded images of each layer.
   */
  async adopt(
    document: StudioDocument,
    { layers }: AutoWrinkles,
    images: readonly AutoMaps<GrayImage>[],
    source: SkinSource,
  ): Promise<void> {
    for (const [i, { maps }] of document.layers.entries()) {
      decodedImages.set(maps, Promise.resolve(images[i]))
    }
    // If the worker has died, `make` draws everything later.
    const drawing = await this.#begin(document, source).catch(() => null)
    if (!drawing) return
    for (const { name, normal, occlusion, onset } of layers) {
      const maps = { normal, occlusion, ...(onset && { onset }) }
      drawing.adopt(name, strokesOf(document, name), maps).catch(() => {})
    }
  }

  /** Prepares the edit of a stroke, so that its first change is as fast as later ones. Null cancels the preparation. */
  prepare(stroke: LayerStroke | null): void {
    // If the worker has died, `make` starts another one later.
    this.#drawing?.prepare(stroke).catch(() => {})
  }

  /** Returns drawn height maps. The keys are names of the layers that have strokes or sculpted heights. */
  async heights(document: StudioDocument, source: SkinSource): Promise<ReadonlyMap<string, HeightMap>> {
    // If the worker has died, start another one.
    if (!this.#drawing) await this.make(document, source)
    const heights = new Map<string, HeightMap>()
    for (const { name, sculpted } of document.layers) {
      if (strokesOf(document, name).length === 0 && !sculpted) continue
      const own = await this.#drawing?.heightsOf(name)
      if (own) heights.set(name, own)
    }
    return heights
  }

  /** Returns the rectangles that changed since the last call. */
  takeChanges(): MapChanges {
    const changes = this.#changes
    this.#changes = new Map()
    return changes
  }

  /** Stops the worker. Pending draws reject with an AbortError. */
  close(): void {
    this.#drawing?.dispose()
    this.#drawing = null
    this.#source = null
  }

  async #begin({ mapSize, scale }: StudioDocument, source: SkinSource): Promise<Drawing> {
    this.#drawing ??= this.#start()
    if (source === this.#source && mapSize === this.#size) return this.#drawing
    this.#source = source
    this.#size = mapSize
    const { skin, frame } = source
    const mesh = { positions: skin.positions, uvs: skin.uvs, indices: skin.indices }
    await this.#drawing.begin({ mesh, size: mapSize, scale, frame })
    return this.#drawing
  }

  #start(): Drawing {
    const drawing = new Drawing()
    drawing.end.catch((error) => {
      if (drawing !== this.#drawing) return
      this.close()
      this.#onEnd(error)
    })
    return drawing
  }

  async #makeLayer(
    drawing: Drawing,
    layer: StudioLayer,
    strokes: readonly LayerStroke[],
  ): Promise<LayerMaps> {
    const own = await decoded(layer)
    const { sculpted = null } = layer
    if (strokes.length === 0 && !sculpted && hasNormals(own)) return fitMaps(own, this.#size)
    // Without strokes, the onset map would be 0 everywhere. Wrinkles would then be deeper at the same influence than without an onset map.
    const isOnsetDrawn = layer.isOnsetDrawn === true && hasOnset(strokes)
    const settings = { base: own.normal ?? null, hasOnset: isOnsetDrawn }
    const changes = await drawing.draw(layer.name, strokes, settings, sculpted)
    // Only strokes are drawn into the occlusion.
    const { occlusion, ...others } = own
    const maps = this.#combine(
      drawing.mapsOf(layer.name)!,
      occlusion && strokes.length === 0 ? { ...others, occlusion } : others,
    )
    if (changes?.length) this.#changes.set(maps, [...(this.#changes.get(maps) ?? []), ...changes])
    return maps
  }

  /** Adds the maps in `OTHER_MAPS` to the drawn maps of a layer, and caches the result. */
  #combine(drawn: DrawnMaps, { baseColor, roughness, occlusion, blood, onset }: StoredMaps): LayerMaps {
    if (!baseColor && !roughness && !occlusion && !blood && !onset) return drawn
    const { width } = drawn.occlusion
    const maps: LayerMaps = {
      ...drawn,
      ...(baseColor && { baseColor }),
      ...(roughness && { roughness }),
      ...(occlusion && { occlusion: scaledMap(occlusion, width) }),
      ...(blood && { blood: scaledMap(blood, width) }),
      ...(onset && { onset: scaledMap(onset, width) }),
    }
    const known = this.#combined.get(drawn)
    if (known && OTHER_MAPS.every((map) => known[map] === maps[map])) return known
    this.#combined.set(drawn, maps)
    return maps
  }
}

/** Decoded images of a layer. The normal map can be missing. */
type StoredMaps = Partial<LayerMaps>

function hasNormals(maps: StoredMaps): maps is LayerMaps {
  return maps.normal !== undefined
}

/** Maps of a layer that can be images beside the drawn maps. */
const OTHER_MAPS = ['baseColor', 'roughness', 'occlusion', 'blood', 'onset'] as const

const scaledMaps = new WeakMap<GrayImage, GrayImage>()

/** Scales a map to the size of the drawn occlusion map. */
function scaledMap(map: GrayImage, size: number): GrayImage {
  const known = scaledMaps.get(map)
  if (known?.width === size) return known
  const scaled = resampleGray(map, size)
  scaledMaps.set(map, scaled)
  return scaled
}

const fittingMaps = new WeakMap<LayerMaps, LayerMaps>()

/** Scales the blood and onset maps of a layer without strokes to the size of its occlusion map, or to `size` texels if it has none. */
function fitMaps(own: LayerMaps, size: number): LayerMaps {
  if (!own.blood && !own.onset) return own
  const side = own.occlusion?.width ?? size
  const blood = own.blood && scaledMap(own.blood, side)
  const onset = own.onset && scaledMap(own.onset, side)
  const known = fittingMaps.get(own)
  if (known && known.blood === blood && known.onset === onset) return known
  const maps = { ...own, ...(blood && { blood }), ...(onset && { onset }) }
  fittingMaps.set(own, maps)
  return maps
}

const decodedImages = new WeakMap<StudioLayer['maps'], Promise<StoredMaps>>()

/** Decodes the images of a layer, and caches the result. Rejects with a FurrowError if an image is invalid. */
function decoded({ name, maps }: StudioLayer): Promise<StoredMaps> {
  const known = decodedImages.get(maps)
  if (known) return known
  const images = decodeMaps(maps, name)
  decodedImages.set(maps, images)
  return images
}

async function decodeMaps(maps: StudioLayer['maps'], layer: string): Promise<StoredMaps> {
  const decode = (name: MapName, image: ImageFile | undefined) => {
    return (
      image &&
      decodeImage(new Blob([image.bytes as BlobPart], { type: image.mimeType }), `layer "${layer}" ${name}`)
    )
  }
  const { normal, baseColor, roughness, occlusion, blood, onset } = maps
  const [normals, colours, rough, open, flushed, begun] = await Promise.all([
    decode('normal', normal),
    decode('baseColor', baseColor),
    decode('roughness', roughness),
    decode('occlusion', occlusion),
    decode('blood', blood),
    decode('onset', onset),
  ])
  return {
    ...(normals && { normal: normals }),
    ...(colours && { baseColor: colours }),
    ...(rough && { roughness: channelOf(rough, CHANNEL.roughness) }),
    ...(open && { occlusion: channelOf(open, CHANNEL.occlusion) }),
    ...(flushed && { blood: channelOf(flushed, CHANNEL.blood) }),
    ...(begun && { onset: channelOf(begun, CHANNEL.onset) }),
  }
}
