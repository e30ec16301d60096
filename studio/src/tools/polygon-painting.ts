import { type ReadonlySignal, signal } from '@preact/signals'
import type { GrayImage } from 'furrow'
import type { Camera, Vector3 } from 'three'
import type { Brush } from '../paint/brush.ts'
import type { SkinHit } from '../paint/picker.ts'
import { paintPolygon } from '../paint/polygon.ts'
import { shortcutOf } from '../shortcuts.ts'
import type { AreaTarget } from './area-target.ts'
import { Polygon } from './polygon.ts'
import { PolygonOutline } from './polygon-outline.ts'
import { PolygonTool } from './polygon-tool.ts'

/** Default of `feather`, millimetres. */
const FEATHER = 4

/** View in which the user can draw a polygon: the face or its texture. */
export interface PolygonView {
  /** Element over which the polygon is drawn. */
  element: HTMLElement
  camera(): Camera | null
  /** Returns null if there is nothing to paint. */
  target(): AreaTarget | null
  /** Returns the position of a skin point in the scene of the camera, or null if no face is open. */
  positionOf(hit: SkinHit): Vector3 | null
}

export interface PolygonPaintingParts {
  brush: ReadonlySignal<Brush>
  /** Returns a promise that settles when the skin is ready, or null if there is nothing to wait for. */
  preparation(): Promise<unknown> | null
  keep(target: AreaTarget, painted: GrayImage): void
  /** Requests the next frame. */
  wake(): void
  attempt(task: () => void): unknown
}

/** Lets the user paint an area with polygons on the face or on its texture. */
export class PolygonPainting {
  /** Width of the band along the polygon's border in which the painted weight falls to 0, millimetres. */
  readonly feather = signal(FEATHER)
  readonly #parts: PolygonPaintingParts
  readonly #polygon: Polygon
  readonly #views: { view: PolygonView; outline: PolygonOutline }[] = []
  /** View in which the user clicked last. */
  #last: PolygonView | null = null
  readonly #count = signal(0)

  constructor(parts: PolygonPaintingParts) {
    this.#parts = parts
    this.#polygon = new Polygon(() => {
      this.#count.value = this.#polygon.points.length
      parts.wake()
    })
    addEventListener('keydown', (event) => this.#onKey(event))
  }

  /** Number of points of the unfinished polygon. */
  get count(): ReadonlySignal<number> {
    return this.#count
  }

  /** Adds a view and returns its pointer tool. */
  addView(view: PolygonView): PolygonTool {
    this.#views.push({ view, outline: new PolygonOutline(view.element) })
    return new PolygonTool({
      polygon: this.#polygon,
      pick: ({ ray }) => {
        this.#last = view
        return view.target()?.picker.pick(ray)
      },
      preparation: this.#parts.preparation,
      project: (hit) => project(hit, view),
      close: () => this.close(),
    })
  }

  /** Paints the inside of the polygon and starts a new one. Does nothing if the polygon has too few points. */
  close(): void {
    const points = this.#polygon.take()
    if (points) this.#parts.attempt(() => this.#paint(points))
  }

  clear(): void {
    this.#polygon.clear()
  }

  /** Updates the outlines before a frame is drawn. */
  advance(): void {
    for (const { view, outline } of this.#views)
      outline.show(this.#polygon.points.map((hit) => project(hit, view)))
  }

  #paint(points: readonly SkinHit[]): void {
    const target = this.#last?.target()
    if (!target) return
    const { mode, opacity, mirror } = this.#parts.brush.peek()
    const brush = {
      mode: mode === 'remove' ? 'remove' : 'add',
      opacity,
      mirror,
      feather: this.feather.peek(),
    } as const
    const { image, dirty } = paintPolygon(target.image, points, brush, target.skin, target.sight)
    if (dirty) this.#parts.keep(target, image)
  }

  #onKey(event: KeyboardEvent): void {
    const name = this.#count.peek() > 0 && shortcutOf('polygon', event)
    if (!name) return
    event.preventDefault()
    if (name === 'close') this.close()
    else if (name === 'back') this.#polygon.removeLast()
    else this.clear()
  }
}

function project(hit: SkinHit, { element, camera, positionOf }: PolygonView): { x: number; y: number } {
  const [position, eye] = [positionOf(hit), camera()]
  if (!position || !eye) return { x: 0, y: 0 }
  const { x, y } = position.project(eye)
  return { x: ((1 + x) / 2) * element.clientWidth, y: ((1 - y) / 2) * element.clientHeight }
}
