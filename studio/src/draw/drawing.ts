import { type Remote, wrap } from 'comlink'
import { FurrowError, type RgbaImage } from 'furrow'
import type { HeightMap, Stroke } from 'furrow/author'
import type { Bounds } from 'furrow/internal'
import type { LayerStroke } from '../document/document.ts'
import type { DrawnMaps } from '../document/drawn-maps.ts'
import { endOf } from '../workers/life.ts'
import { changesOf } from './changes.ts'
import { pasteRect } from './copy-rect.ts'
import type { DrawingService, DrawingSurface } from './messages.ts'

/** Maps of a layer, and the strokes that they show. */
interface Sheet {
  maps: DrawnMaps
  strokes: readonly Stroke[]
  base: RgbaImage | null
}

/** The maps that a worker draws from strokes. Calls are answered in their order. */
export class Drawing {
  readonly #worker: Worker
  readonly #service: Remote<DrawingService>
  readonly #disposed = new AbortController()
  readonly #end: Promise<never>
  readonly #sheets = new Map<string, Sheet>()
  #surface: DrawingSurface | null = null

  constructor() {
    this.#worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
    this.#end = endOf(this.#worker, died, this.#disposed.signal)
    this.#service = wrap<DrawingService>(this.#worker)
  }

  /** Rejects with a FurrowError when the worker ends by itself; so does all that is asked of it then. */
  get end(): Promise<never> {
    return this.#end
  }

  /** Begins with another skin, or maps of another size. */
  async begin(surface: DrawingSurface): Promise<void> {
    this.#surface = surface
    this.#sheets.clear()
    await this.#ask((service) => service.begin(surface))
  }

  /** The maps of a layer, which `draw` changes in place; undefined before they were drawn. */
  mapsOf(layer: string): DrawnMaps | undefined {
    return this.#sheets.get(layer)?.maps
  }

  /**
   * Draws what changed since the last call for this layer.
   *
   * @param base smooth normal map under the strokes.
   * @returns the rectangles that changed; null where all did.
   */
  async draw(layer: string, strokes: readonly Stroke[], base: RgbaImage | null): Promise<Bounds[] | null> {
    const known = this.#sheets.get(layer)
    const sheet = known?.base === base ? known : await this.#addLayer(layer, base)
    const before = sheet.strokes
    sheet.strokes = strokes
    const patches = await this.#ask((service) => service.draw(layer, changesOf(before, strokes)))
    for (const { bounds, normal, occlusion } of patches) {
      pasteRect(sheet.maps.normal, bounds, 4, normal)
      pasteRect(sheet.maps.occlusion, bounds, 1, occlusion)
    }
    return sheet === known ? patches.map(({ bounds }) => bounds) : null
  }

  /** Takes maps that show these strokes already; the worker draws them too, so that it can draw the next edit. */
  async adopt(layer: string, strokes: readonly Stroke[], maps: DrawnMaps): Promise<void> {
    this.#sheets.set(layer, { maps, strokes, base: null })
    // Both at once: whatever is asked next comes after them.
    await this.#ask((service) =>
      Promise.all([service.addLayer(layer, null), service.draw(layer, [...strokes])]),
    )
  }

  /**
   * Lets the worker find, while nothing else is asked of it, what it needs when a stroke is edited; null for none. A stroke that it was not told of
   * changes nothing.
   */
  async prepare(stroke: LayerStroke | null): Promise<void> {
    const index = stroke ? (this.#sheets.get(stroke.layer)?.strokes.indexOf(stroke) ?? -1) : -1
    if (stroke && index < 0) return
    const known = stroke && { layer: stroke.layer, index }
    await this.#ask((service) => service.prepare(known))
  }

  /** The heights of a layer's strokes alone; undefined before they were drawn. */
  async heightsOf(layer: string): Promise<HeightMap | undefined> {
    const maps = this.mapsOf(layer)
    if (!maps) return undefined
    const { width, height } = maps.normal
    return { width, height, data: await this.#ask((service) => service.heights(layer)) }
  }

  dispose(): void {
    this.#disposed.abort()
    this.#worker.terminate()
  }

  #ask<T>(question: (service: Remote<DrawingService>) => Promise<T>): Promise<T> {
    return Promise.race([question(this.#service), this.#end])
  }

  async #addLayer(layer: string, base: RgbaImage | null): Promise<Sheet> {
    const { size } = this.#surface!
    const sheet: Sheet = { maps: flatMaps(size, base), strokes: [], base }
    this.#sheets.set(layer, sheet)
    await this.#ask((service) => service.addLayer(layer, base))
    return sheet
  }
}

function died(reason: string | undefined): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who: 'Studio',
    problem: 'the worker that draws strokes has ended',
    value: reason,
    remedy: 'it is started again, and nothing is lost; close other pages if it runs out of memory',
  })
}

/** Maps of skin without strokes: normals that point outwards, or those of the base. */
function flatMaps(size: number, base: RgbaImage | null): DrawnMaps {
  const data = base ? base.data.slice() : new Uint8Array(4 * size * size)
  if (!base) new Uint32Array(data.buffer).fill(FLAT)
  return {
    normal: { width: size, height: size, data },
    occlusion: { width: size, height: size, data: new Uint8Array(size * size).fill(255) },
  }
}

/** 128, 128, 255, 255 in the order of memory: all browsers run on little-endian machines. */
const FLAT = 0xffff8080
