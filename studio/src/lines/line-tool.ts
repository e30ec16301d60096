import type { Uv } from 'furrow/author'
import type { LayerStroke } from '../document/document.ts'
import type { LineEditor } from '../lines/line-editor.ts'
import {
  nearestFork,
  nearestHandle,
  nearestLine,
  type ProjectedLine,
  projectForks,
} from '../lines/project-lines.ts'
import { type PathPoint, reducePath } from '../lines/reduce-path.ts'
import type { SkinHit, SkinPicker } from '../paint/picker.ts'
import type { StagePointer, StageTool } from '../tools/stage-tool.ts'
import { acrossLine, DepthDrag } from './depth-drag.ts'

/** Maximum distance at which the pointer hits a line, CSS pixels. */
const ON_LINE = 8
/** Distance that the pointer must move before a line is dragged, CSS pixels. */
const THRESHOLD = 4
/** Maximum distance at which the pointer hits a point of the chosen line, or a fork, CSS pixels. */
const ON_POINT = 10

export interface LineStage {
  /** Finds the skin under the pointer. Null while lines cannot be edited. */
  readonly picker: Pick<SkinPicker, 'pick'> | null
  readonly lines: readonly ProjectedLine[]
  /** Returns a promise that resolves when `picker` is ready, or null if no preparation is running. */
  preparation(): Promise<unknown> | null
  /** Called when the line under the pointer or the path of the pointer changes. */
  onChange(): void
  /** In the mode `select`, called with the point of the skin under the pointer; with null if a line or no skin is there. */
  onSkin?(hit: SkinHit | null): void
}

/** Pointer tool for wrinkle lines: chooses lines, moves their points and forks, and draws new lines. */
export class LineTool implements StageTool {
  hovered: LayerStroke | null = null
  /** Index of the handle under the pointer, or -1. */
  hoveredPoint = -1
  /** Pointer path of the line that the user is drawing, CSS pixels. */
  path: { x: number; y: number }[] = []
  readonly #editor: LineEditor
  readonly #stage: LineStage
  #drawn: PathPoint[] = []
  /** Whether the current gesture has changed the document. */
  #isChanged = false
  /** Gesture that changes the depth of the chosen line, or null. */
  #depth: DepthDrag | null = null
  /** Start of a gesture on a line between its points, or null. `along` is the place on the line. */
  #between: { x: number; y: number; along: number; uv: Uv } | null = null
  /** Line under the pointer when it was pressed. A click chooses only this line, but a drag changes all chosen lines. */
  #pressed: LayerStroke | null = null
  /** Lines that the current gesture has smoothed. */
  readonly #touched = new Set<number>()

  constructor(editor: LineEditor, stage: LineStage) {
    this.#editor = editor
    this.#stage = stage
  }

  /** Whether the current gesture has moved or added a point of a line. */
  get isBending(): boolean {
    return this.#isChanged
  }

  get isQuiet(): boolean {
    return this.#editor.mode.peek() === 'select'
  }

  preparation(): Promise<unknown> | null {
    // Until lines can be chosen, the pointer orbits the camera.
    return this.isQuiet ? null : this.#stage.preparation()
  }

  begin(pointer: StagePointer): boolean {
    const { picker } = this.#stage
    if (!picker) return false
    this.#isChanged = false
    const mode = this.#editor.mode.peek()
    if (mode === 'edit') return this.#choose(pointer)
    if (mode === 'select') return this.#grab(pointer)
    if (mode === 'smooth' || mode === 'erase') return this.#touch(pointer)
    if (!picker.pick(pointer.ray)) return false
    this.#editor.choose(null)
    this.#drawTo([pointer])
    return true
  }

  move(pointers: readonly StagePointer[]): void {
    const mode = this.#editor.mode.peek()
    if (mode === 'draw') this.#drawTo(pointers)
    else if (mode === 'select') this.#deepen(pointers)
    else if (mode === 'edit') this.#moveTo(pointers)
    else for (const pointer of pointers) this.#touch(pointer)
  }

  end(): void {
    const points = reducePath(this.#drawn).map(({ uv }) => [uv[0], uv[1]] as [number, number])
    this.#forgetPath()
    if (points.length >= 2) this.#editor.draw(points)
    this.#editor.settle()
    if (this.#pressed && !this.#isChanged) this.#editor.choose(this.#pressed)
    this.#pressed = null
    this.#between = null
    this.#isChanged = false
    this.#depth = null
    this.#touched.clear()
  }

  cancel(): void {
    this.#forgetPath()
    this.#depth = null
    this.#pressed = null
    this.#between = null
    this.#touched.clear()
    if (!this.#isChanged) return
    this.#editor.settle()
    this.#editor.session.undo()
    this.#isChanged = false
  }

  hover(pointer: StagePointer | null): void {
    const mode = this.#editor.mode.peek()
    const found = pointer && mode !== 'draw' ? this.#lineAt(pointer)?.stroke : undefined
    if (mode === 'select')
      this.#stage.onSkin?.(found || !pointer ? null : (this.#stage.picker?.pick(pointer.ray) ?? null))
    const point = pointer && mode === 'edit' ? this.#handleAt(pointer) : -1
    if ((found ?? null) === this.hovered && point === this.hoveredPoint) return
    this.hovered = found ?? null
    this.hoveredPoint = point
    this.#stage.onChange()
  }

  /** Adds a point to the chosen line at the pointer. */
  insert(pointer: Pick<StagePointer, 'x' | 'y'>): void {
    const hit = this.#lineAt(pointer)
    if (hit?.stroke !== this.#editor.chosen.peek() || this.#handleAt(pointer) >= 0) return
    this.#editor.points.insert(hit.along)
    this.#editor.settle()
  }

  /** Chooses the line at the pointer, and begins to change the depth of the chosen lines. With Shift, adds or removes the line. */
  #grab(pointer: StagePointer): boolean {
    const hit = this.#lineAt(pointer)
    if (!hit) return false
    if (pointer.shift) {
      this.#editor.toggle(hit.stroke)
      return true
    }
    if (!this.#editor.allChosen.peek().includes(hit.stroke)) this.#editor.choose(hit.stroke)
    this.#pressed = hit.stroke
    const line = this.#stage.lines.find(({ stroke }) => stroke === hit.stroke)
    if (line) this.#depth = new DepthDrag(pointer, hit.stroke.depth, acrossLine(line, hit.along))
    return true
  }

  #deepen(pointers: readonly StagePointer[]): void {
    const last = pointers.at(-1)
    const depth = last && this.#depth?.to(last)
    if (depth === undefined) return
    this.#editor.fields.setShape({ depth })
    this.#isChanged = true
  }

  /** Smooths or erases the line at the pointer. Smooths each line once per gesture. */
  #touch(pointer: StagePointer): boolean {
    const hit = this.#lineAt(pointer)
    if (!hit) return this.#isChanged
    const { session } = this.#editor
    const index = session.document.peek()?.strokes.indexOf(hit.stroke) ?? -1
    if (index < 0 || this.#touched.has(index)) return true
    this.#editor.choose(hit.stroke)
    if (this.#editor.mode.peek() === 'erase') this.#editor.removeLine()
    else {
      this.#touched.add(index)
      this.#editor.smooth()
    }
    this.#isChanged = true
    return true
  }

  #choose(pointer: StagePointer): boolean {
    const handle = this.#handleAt(pointer)
    if (handle >= 0) {
      this.#editor.point.value = handle
      return true
    }
    const hit = this.#lineAt(pointer)
    if (!hit) return false
    const fork = this.#forkAt(pointer)
    const all = this.#editor.allChosen.peek()
    if (all.length > 1 && all.includes(hit.stroke) && !pointer.shift) this.#pressed = hit.stroke
    if (hit.stroke !== all[0]) {
      if (pointer.shift) this.#editor.toggle(hit.stroke)
      else if (this.#pressed) this.#editor.makeMain(hit.stroke)
      else if (fork) this.#editor.chooseFork(fork)
      else this.#editor.choose(hit.stroke)
    } else if (pointer.shift) {
      this.#editor.points.insert(hit.along)
      this.#isChanged = true
    } else this.#editor.point.value = -1
    const uv = this.#stage.picker?.pick(pointer.ray)?.uv
    if (uv && !pointer.shift && this.#editor.point.peek() < 0)
      this.#between = { x: pointer.x, y: pointer.y, along: hit.along, uv }
    return true
  }

  /**
   * Moves the chosen point to the pointer, unless the pointer is off the skin. With Alt, the point moves alone. If the gesture began between points
   * of a line, moves the nearest point along with the pointer.
   */
  #moveTo(pointers: readonly StagePointer[]): void {
    const last = pointers.at(-1)
    if (!last) return
    if (this.#between && this.#editor.point.peek() < 0) {
      const { x, y, along } = this.#between
      if (Math.hypot(last.x - x, last.y - y) < THRESHOLD) return
      this.#editor.points.chooseNear(along)
    }
    const hit = this.#stage.picker?.pick(last.ray)
    if (!hit || this.#editor.point.peek() < 0) return
    if (this.#between) this.#editor.points.drag(this.#between.uv, hit.uv, last.alt)
    else this.#editor.points.move(hit.uv, last.alt)
    this.#isChanged = true
  }

  #drawTo(pointers: readonly StagePointer[]): void {
    for (const { ray, x, y } of pointers) {
      const hit = this.#stage.picker?.pick(ray)
      if (!hit) continue
      this.#drawn.push(hit)
      this.path.push({ x, y })
    }
    this.#stage.onChange()
  }

  #forgetPath(): void {
    this.#drawn = []
    this.path = []
    this.#stage.onChange()
  }

  #lineAt({ x, y }: Pick<StagePointer, 'x' | 'y'>) {
    const { lines } = this.#stage
    const chosen = lines.filter(({ stroke }) => stroke === this.#editor.chosen.peek())
    // The chosen line has precedence over crossing lines.
    return nearestLine(chosen, x, y, ON_LINE) ?? nearestLine(lines, x, y, ON_LINE)
  }

  #handleAt({ x, y }: Pick<StagePointer, 'x' | 'y'>): number {
    const chosen = this.#stage.lines.find(({ stroke }) => stroke === this.#editor.chosen.peek())
    return chosen ? nearestHandle(chosen, this.#editor.handles.peek(), x, y, ON_POINT) : -1
  }

  #forkAt({ x, y }: Pick<StagePointer, 'x' | 'y'>) {
    const { forks, session } = this.#editor
    const strokes = session.document.peek()?.strokes ?? []
    return nearestFork(projectForks(forks.peek(), strokes, this.#stage.lines), x, y, ON_POINT)
  }
}
