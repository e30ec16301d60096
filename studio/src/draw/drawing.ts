import { type Remote, wrap } from 'comlink'
import { FurrowError } from 'furrow'
import type { HeightMap, Stroke } from 'furrow/author'
import type { Bounds } from 'furrow/internal'
import type { LayerStroke } from '../document/document.ts'
import type { DrawnMaps } from '../document/drawn-maps.ts'
import type { Sculpted } from '../document/sculpted.ts'
import { deathOf } from '../workers/life.ts'
import { changesOf, sculptedChanges } from './changes.ts'
import { pasteRect } from './copy-rect.ts'
import type { DrawingService, DrawingSurface, LayerSettings } from './messages.ts'

/** Maps of a layer, and the strokes and sculpted heights drawn in them. */
interface Sheet {
  maps: DrawnMaps
  strokes: readonly Stroke[]
  sculpted: Sculpted | null
  settings: LayerSettings
}

/** Draws wrinkle strokes into the maps of layers, in a worker. Calls run in order. */
export class Drawing {
  readonly #worker: Worker
  readonly #service: Remote<DrawingService>
  readonly #disposed = new AbortController()
  readonly #end: Promise<never>
  readonly #sheets = new Map<string, Sheet>()
  #surface: DrawingSurface | null = null

  constructor() {
    this.#worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
    this.#end = deathOf(this.#worker, workerError, this.#disposed.signal)
    this.#service = wrap<DrawingService>(this.#worker)
  }

  /** Promise that rejects with a FurrowError if the worker dies. Pending calls then reject too. */
  get end(): Promise<never> {
    return this.#end
  }

  /** Sets the skin and the size of the maps. Removes all layers. */
  async begin(surface: DrawingSurface): Promise<void> {
    this.#surface = surface
    this.#sheets.clear()
    await this.#call((service) => service.begin(surface))
  }

  /** Returns the maps of a layer. `draw` updates them in place. Undefined before the first draw. */
  mapsOf(layer: string): DrawnMaps | undefined {
    return this.#sheets.get(layer)?.maps
  }

  /**
   * Updates the maps of a layer after changes of its strokes or sculpted heights.
   *
   * @returns changed rectangles in texels, or null if everything changed.
   */
  async draw(
    layer: string,
    strokes: readonly Stroke[],
    settings: LayerSettings,
    sculpted: Sculpted | null = null,
  ): Promise<Bounds[] | null> {
    const known = this.#sheets.get(layer)
    const sheet = known && isSame(known.settings, settings) ? known : await this.#addLayer(layer, settings)
    const changes = changesOf(sheet.strokes, strokes)
    const heights = sculptedChanges(sheet.sculpted, sculpted)
    Object.assign(sheet, { strokes, sculpted })
    const patches = await this.#call((service) => service.draw(layer, changes, heights))
    for (const { bounds, normal, occlusion, onset } of patches) {
      pasteRect(sheet.maps.normal, bounds, 4, normal)
      pasteRect(sheet.maps.occlusion, bounds, 1, occlusion)
      if (onset && sheet.maps.onset) pasteRect(sheet.maps.onset, bounds, 1, onset)
    }
    return sheet === known ? patches.map(({ bounds }) => bounds) : null
  }

  /**
   * Sets the maps of a layer. The strokes must already be drawn in `maps`. The worker draws the strokes into its own copy of the maps, to be
   * ready for edits.
   */
  async adopt(layer: string, strokes: readonly Stroke[], maps: DrawnMaps): Promise<void> {
    const settings = { base: null, hasOnset: maps.onset !== undefined }
    this.#sheets.set(layer, { maps, strokes, sculpted: null, settings })
    // Send both calls at once, so that later calls run after them.
    await this.#call((service) =>
      Promise.all([service.addLayer(layer, settings), service.draw(layer, [...strokes], null)]),
    )
  }

  /** Lets the worker prepare for edits of a stroke while it has no other work. Null cancels the preparation. Ignores unknown strokes. */
  async prepare(stroke: LayerStroke | null): Promise<void> {
    const index = stroke ? (this.#sheets.get(stroke.layer)?.strokes.indexOf(stroke) ?? -1) : -1
    if (stroke && index < 0) return
    const known = stroke && { layer: stroke.layer, index }
    await this.#call((service) => service.prepare(known))
  }

  /** Returns the height map of a layer's strokes and sculpted heights, or undefined before the first draw. */
  async heightsOf(layer: string): Promise<HeightMap | undefined> {
    const maps = this.mapsOf(layer)
    if (!maps) return undefined
    const { width, height } = maps.normal
    return { width, height, data: await this.#call((service) => service.heights(layer)) }
  }

  dispose(): void {
    this.#disposed.abort()
    this.#worker.terminate()
  }

  #call<T>(call: (service: Remote<DrawingService>) => Promise<T>): Promise<T> {
    return Promise.race([call(this.#service), this.#end])
  }

  async #addLayer(layer: string, settings: LayerSettings): Promise<Sheet> {
    const { size } = this.#surface!
    const sheet: Sheet = { maps: flatMaps(size, settings), strokes: [], sculpted: null, settings }
    this.#sheets.set(layer, sheet)
    await this.#call((service) => service.addLayer(layer, settings))
    return sheet
  }
}

function workerError(reason: string | undefined): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who: 'Studio',
    problem: 'the worker that draws strokes has ended',
    value: reason,
    remedy: 'it is started again, and nothing is lost; close other pages if it runs out of memory',
  })
}

function isSame(a: LayerSettings, b: LayerSettings): boolean {
  return a.base === b.base && a.hasOnset === b.hasOnset
}

/** Makes maps without strokes. The normal map is a copy of `base`, or flat. */
function flatMaps(size: number, { base, hasOnset }: LayerSettings): DrawnMaps {
  const data = base ? base.data.slice() : new Uint8Array(4 * size * size)
  if (!base) new Uint32Array(data.buffer).fill(FLAT)
  return {
    normal: { width: size, height: size, data },
    occlusion: { width: size, height: size, data: new Uint8Array(size * size).fill(255) },
    ...(hasOnset && { onset: { width: size, height: size, data: new Uint8Array(size * size) } }),
  }
}

/** Flat normal: RGBA 128, 128, 255, 255 as a little-endian number. All browsers run on little-endian machines. */
const FLAT = 0xffff8080
