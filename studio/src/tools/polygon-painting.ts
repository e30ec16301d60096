import { type ReadonlySignal, signal } from '@preact/signals'
import { type Camera, Vector3 } from 'three'
import type { Brush } from '../paint/brush.ts'
import type { SkinHit, SkinPicker } from '../paint/picker.ts'
import { paintPolygon } from '../paint/polygon.ts'
import { shortcutOf } from '../shortcuts.ts'
import type { PaintTarget } from './paint-tool.ts'
import { PolygonOutline } from './polygon-outline.ts'
import { PolygonTool } from './polygon-tool.ts'
import type { StagePointer } from './stage-tool.ts'

/** Millimetres within which a polygon fades, at first. */
const FEATHER = 4

export interface PolygonPaintingParts {
  /** The element over which the polygon is drawn. */
  stage: HTMLElement
  brush: ReadonlySignal<Brush>
  /** Null where there is nothing to paint. */
  target(): (PaintTarget & { picker: SkinPicker }) | null
  camera(): Camera | null
  keep(area: string, painted: PaintTarget['area']['weights']): void
  /** Requests the next frame. */
  wake(): void
  attempt(task: () => void): unknown
}

/** Paints an area by polygons that are drawn on the face. */
export class PolygonPainting {
  /** Millimetres across the outline within which it fades. */
  readonly feather = signal(FEATHER)
  readonly tool: PolygonTool
  readonly #parts: PolygonPaintingParts
  readonly #outline: PolygonOutline
  readonly #count = signal(0)

  constructor(parts: PolygonPaintingParts) {
    this.#parts = parts
    this.#outline = new PolygonOutline(parts.stage)
    this.tool = new PolygonTool({
      pick: (pointer: StagePointer) => parts.target()?.picker.pick(pointer.ray),
      project: (hit) => this.#project(hit),
      close: (points) => parts.attempt(() => this.#paint(points)),
      changed: () => {
        this.#count.value = this.tool.points.length
        parts.wake()
      },
    })
    addEventListener('keydown', (event) => this.#onKey(event))
  }

  /** How many points there are. */
  get count(): ReadonlySignal<number> {
    return this.#count
  }

  /** Before a frame is drawn. */
  advance(): void {
    this.#outline.show(this.tool.points.map((hit) => this.#project(hit)))
  }

  #paint(points: readonly SkinHit[]): void {
    const target = this.#parts.target()
    if (!target) return
    const { mode, opacity, mirror } = this.#parts.brush.peek()
    const brush = {
      mode: mode === 'remove' ? 'remove' : 'add',
      opacity,
      mirror,
      feather: this.feather.peek(),
    } as const
    const { image, dirty } = paintPolygon(target.area.weights, points, brush, target.skin, target.sight)
    if (dirty) this.#parts.keep(target.area.name, image)
  }

  #project({ triangle, weights }: SkinHit): { x: number; y: number } {
    const { stage, target, camera } = this.#parts
    const [picker, eye] = [target()?.picker, camera()]
    if (!picker || !eye) return { x: 0, y: 0 }
    const { x, y } = picker.positionOf(triangle, weights, new Vector3()).project(eye)
    return { x: ((1 + x) / 2) * stage.clientWidth, y: ((1 - y) / 2) * stage.clientHeight }
  }

  #onKey(event: KeyboardEvent): void {
    const name = this.#count.peek() > 0 && shortcutOf('polygon', event)
    if (!name) return
    event.preventDefault()
    if (name === 'close') this.tool.close()
    else if (name === 'back') this.tool.removeLast()
    else this.tool.clear()
  }
}
