import type { GrayImage } from 'furrow'
import type { AutoWrinkles, HeightMap } from 'furrow/author'
import { type Bounds, CHANNEL, channelOf, resampleGray } from 'furrow/internal'
import { decodeImage } from 'furrow/three'
import type { ImageFile, LayerStroke, MapName, StudioDocument, StudioLayer } from '../document/document.ts'
import type { DrawnMaps } from '../document/drawn-maps.ts'
import { strokesOf } from '../document/strokes.ts'
import type { SkinSource } from '../open/skin-source.ts'
import type { LayerMaps } from '../viewer/document-view.ts'
import { Drawing } from './drawing.ts'

/** Changed rectangles of maps updated in place. */
export type MapChanges = ReadonlyMap<LayerMaps, readonly Bounds[]>

/** Makes the maps of a document's layers. A worker draws strokes over the images. */
export class MapMaker {
  #drawing: Drawing | null = null
  #source: SkinSource | null = null
  #size = 0
  #changes = new Map<LayerMaps, Bounds[]>()
  readonly #combined = new WeakMap<DrawnMaps, LayerMaps>()
  readonly #onEnd: (error: unknown) => void

  /** @param onEnd called when the worker dies. The next call starts another one. */
  constructor(onEnd: (error: unknown) => void) {
    this.#onEnd = onEnd
  }

  /**
   * Makes the maps of each layer, in layer order. Returns the same objects for unchanged or updated maps. Calls must not overlap. If the
   * worker dies, another one draws everything.
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
   * Takes over the maps of automatic wrinkles, which already show the strokes of the document.
   *
   * @param bloods blood maps of the layers, equal to their images.
   */
  async adopt(
    document: StudioDocument,
    { layers }: AutoWrinkles,
    bloods: readonly GrayImage[],
    source: SkinSource,
  ): Promise<void> {
    for (const [i, { maps }] of document.layers.entries()) {
      decodedImages.set(maps, Promise.resolve({ blood: bloods[i] }))
    }
    // If the worker ends, `make` draws everything.
    const drawing = await this.#begin(document, source).catch(() => null)
    if (!drawing) return
    for (const { name, normal, occlusion } of layers) {
      drawing.adopt(name, strokesOf(document, name), { normal, occlusion }).catch(() => {})
    }
  }

  /** Prepares the next edit of a stroke, so that the first change is as fast as later ones. Null cancels. */
  prepare(stroke: LayerStroke | null): void {
    // If the worker ends, `make` starts another one.
    this.#drawing?.prepare(stroke).catch(() => {})
  }

  /** Returns the heights of drawn strokes, by name of each layer with strokes. */
  async heights(document: StudioDocument, source: SkinSource): Promise<ReadonlyMap<string, HeightMap>> {
    // The worker may have ended meanwhile.
    if (!this.#drawing) await this.make(document, source)
    const heights = new Map<string, HeightMap>()
    for (const { name } of document.layers) {
      if (strokesOf(document, name).length === 0) continue
      const own = await this.#drawing?.heightsOf(name)
      if (own) heights.set(name, own)
    }
    return heights
  }

  /** Returns the changes since the last call. */
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
    if (strokes.length === 0 && hasNormals(own)) return fitBlood(own, this.#size)
    const changes = await drawing.draw(layer.name, strokes, own.normal ?? null)
    const maps = this.#combine(drawing.mapsOf(layer.name)!, own)
    if (changes?.length) this.#changes.set(maps, [...(this.#changes.get(maps) ?? []), ...changes])
    return maps
  }

  /** Adds the layer's other maps to the drawn ones. Returns the same object while the maps are the same. */
  #combine(drawn: DrawnMaps, { baseColor, roughness, blood }: StoredMaps): LayerMaps {
    if (!baseColor && !roughness && !blood) return drawn
    const fitting = blood && scaledBlood(blood, drawn.occlusion.width)
    const known = this.#combined.get(drawn)
    if (known && known.baseColor === baseColor && known.roughness === roughness && known.blood === fitting)
      return known
    const maps = {
      ...drawn,
      ...(baseColor && { baseColor }),
      ...(roughness && { roughness }),
      ...(fitting && { blood: fitting }),
    }
    this.#combined.set(drawn, maps)
    return maps
  }
}

/** Decoded images of a layer. The normal map can be missing. */
type StoredMaps = Partial<LayerMaps>

function hasNormals(maps: StoredMaps): maps is LayerMaps {
  return maps.normal !== undefined
}

/** Cache of scaled blood maps. */
const scaledBloods = new WeakMap<GrayImage, GrayImage>()

/** Scales a blood map to the size of the drawn occlusion map. */
function scaledBlood(blood: GrayImage, size: number): GrayImage {
  const known = scaledBloods.get(blood)
  if (known?.width === size) return known
  const scaled = resampleGray(blood, size)
  scaledBloods.set(blood, scaled)
  return scaled
}

const fittingMaps = new WeakMap<LayerMaps, LayerMaps>()

/** Scales the blood map of a layer without strokes. @param size side of drawn maps, texels. */
function fitBlood(own: LayerMaps, size: number): LayerMaps {
  if (!own.blood) return own
  const blood = scaledBlood(own.blood, own.occlusion?.width ?? size)
  const known = fittingMaps.get(own)
  if (known?.blood === blood) return known
  const maps = { ...own, blood }
  fittingMaps.set(own, maps)
  return maps
}

const decodedImages = new WeakMap<StudioLayer['maps'], Promise<StoredMaps>>()

/** Decodes the images of a layer. Cached. Rejects with a FurrowError if an image is invalid. */
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
  const { normal, baseColor, roughness, occlusion, blood } = maps
  const [normals, colours, rough, open, flushed] = await Promise.all([
    decode('normal', normal),
    decode('baseColor', baseColor),
    decode('roughness', roughness),
    decode('occlusion', occlusion),
    decode('blood', blood),
  ])
  return {
    ...(normals && { normal: normals }),
    ...(colours && { baseColor: colours }),
    ...(rough && { roughness: channelOf(rough, CHANNEL.roughness) }),
    ...(open && { occlusion: channelOf(open, CHANNEL.occlusion) }),
    ...(flushed && { blood: channelOf(flushed, CHANNEL.blood) }),
  }
}
