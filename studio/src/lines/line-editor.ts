import { computed, effect, type ReadonlySignal, signal } from '@preact/signals'
import { insertPoint, removePoint, type SkinCanvas, smoothStroke, splitStroke, type Uv } from 'furrow/author'
import { type MirrorPlane, mirrorStroke, splineOf } from 'furrow/internal'
import type { LayerStroke, StudioDocument } from '../document/document.ts'
import { replaceStroke } from '../document/strokes.ts'
import type { Session } from '../session/session.ts'
import { addLine, isShownAt, type NewLine, withArea } from './line-area.ts'

/** What the pointer does on the face: orbits only, edits lines, or draws new ones. */
export type LineMode = 'off' | 'edit' | 'draw'

/** The cross-section of a line, and how it ends. */
export type LineShape = Pick<
  LayerStroke,
  'width' | 'depth' | 'softness' | 'shoulder' | 'bank' | 'lean' | 'taper'
>

/** A wrinkle of the forehead, about. */
const SHAPE: LineShape = { width: 3, depth: 0.6, softness: 0.4, shoulder: [0.6, 0.6], taper: [0.3, 0.3] }

/** Fraction of the way that "Smooth" moves points. */
const SMOOTHING = 0.5

/** What lines are edited on. */
export interface LineSurface {
  readonly canvas: SkinCanvas
  readonly middle: MirrorPlane | undefined
}

/** The line that is chosen, and what can be done with it: operations on the session's document. */
export class LineEditor {
  readonly mode = signal<LineMode>('off')
  /** Of lines that are drawn. */
  readonly shape = signal<LineShape>(SHAPE)
  /** Group of lines that are drawn; empty for that of the area under them. */
  readonly group = signal('')
  /** Layer of lines that are drawn; empty for that of their area. */
  readonly layer = signal('')
  /** Index of the chosen point of the chosen line; -1 for none. */
  readonly point = signal(-1)
  readonly session: Session
  readonly #surface: () => LineSurface | null
  /** Operations keep a line at its index in the document, and undo brings it back to it. */
  readonly #index = signal(-1)
  /** Whether the present gesture has moved a point. */
  #hasMoved = false

  /** Null while no line is chosen. */
  readonly chosen: ReadonlySignal<LayerStroke | null> = computed(
    () => this.session.document.value?.strokes[this.#index.value] ?? null,
  )

  /** @param surface of the present face; null where it has no document. */
  constructor(session: Session, surface: () => LineSurface | null) {
    this.session = session
    this.#surface = surface
    // Other automatic wrinkles are other lines.
    const auto = computed(() => session.document.value?.auto)
    effect(() => {
      auto.value
      this.choose(null)
    })
  }

  /** How many points the chosen line has; 0 without one. */
  get pointCount(): number {
    const [stroke, surface] = [this.chosen.value, this.#surface()]
    return stroke && surface ? splineOf(stroke, surface.canvas).points.length : 0
  }

  choose(stroke: LayerStroke | null): void {
    const { strokes } = this.session.document.peek() ?? {}
    this.#index.value = (stroke && strokes?.indexOf(stroke)) ?? -1
    this.point.value = -1
  }

  /** Moves the chosen point to another point of the skin; one step until `settle`. */
  movePoint(uv: Uv): void {
    const index = this.point.peek()
    this.#hasMoved = true
    this.#change(
      'Move a point',
      (stroke, { canvas }) => {
        const spline = splineOf(stroke, canvas)
        return [{ ...spline, points: spline.points.with(index, uv) }]
      },
      'points',
    )
  }

  /** Adds a point to the chosen line, and chooses it: one step with the moves of it that follow, until `settle`. */
  insertPoint(along: number): void {
    let index = -1
    this.#change(
      'Add a point',
      (stroke, { canvas }) => {
        const inserted = insertPoint(stroke, along, canvas)
        index = inserted.index
        return [inserted.stroke]
      },
      'points',
    )
    if (index >= 0) this.point.value = index
  }

  /** Removes the chosen point, or the line where no point is chosen or it has no more than two. */
  remove(): void {
    const index = this.point.peek()
    const stroke = this.chosen.peek()
    const canvas = this.#surface()?.canvas
    if (!stroke || !canvas) return
    this.point.value = -1
    if (index >= 0 && splineOf(stroke, canvas).points.length > 2) {
      this.#change('Remove a point', () => [removePoint(stroke, index, canvas)])
      return
    }
    this.removeLine()
  }

  removeLine(): void {
    this.#change('Remove a line', () => [])
    this.choose(null)
  }

  smooth(): void {
    this.#change('Smooth a line', (stroke, { canvas }) => [smoothStroke(stroke, SMOOTHING, canvas)])
  }

  /** Splits the chosen line at its chosen point, or else in its middle; the first part stays chosen. */
  split(): void {
    const index = this.point.peek()
    this.#change('Split a line', (stroke, { canvas }) => {
      const spline = splineOf(stroke, canvas)
      if (index > 0 && index < spline.points.length - 1) return splitStroke(spline, index, canvas)
      const middle = insertPoint(spline, 0.5, canvas)
      const at = middle.index > 0 ? middle.index : Math.floor(spline.points.length / 2)
      return splitStroke(middle.stroke, at, canvas)
    })
    this.point.value = -1
  }

  /** Adds the mirror image of the chosen line, and chooses it. */
  mirror(): void {
    const stroke = this.chosen.peek()
    const surface = this.#surface()
    if (!stroke || !surface) return
    this.#add('Mirror a line', mirrorStroke(stroke, surface.canvas, surface.middle))
  }

  /** Adds a line with the shape, group and layer that are set, and chooses it. */
  draw(points: Uv[]): void {
    const [group, layer] = [this.group.peek(), this.layer.peek()]
    this.#add('Draw a line', {
      ...this.shape.peek(),
      ...(group && { group }),
      ...(layer && { layer }),
      curve: 'spline',
      points,
      waviness: 0,
    })
  }

  /** Changes the cross-section of the chosen line, or of lines that are drawn; one step until `settle`. */
  setShape(fields: Partial<LineShape>): void {
    if (this.mode.peek() === 'draw') {
      this.shape.value = { ...this.shape.peek(), ...fields }
      return
    }
    const key = `shape-${Object.keys(fields)}`
    this.#change(`Change the ${Object.keys(fields)} of a line`, (stroke) => [{ ...stroke, ...fields }], key)
  }

  /** Shows the line with another area; one of a new name is made round it. */
  setGroup(group: string): void {
    if (this.mode.peek() === 'draw') {
      this.group.value = group
      return
    }
    const { canvas } = this.#surface() ?? {}
    const stroke = this.chosen.peek()
    if (!canvas || !stroke || group === '' || group === stroke.group) return
    this.session.edit('Change the group of a line', (document) => {
      const changed = { ...stroke, group }
      return withArea(replaceStroke(document, stroke, [changed]), changed, canvas)
    })
  }

  setLayer(layer: string): void {
    if (this.mode.peek() === 'draw') this.layer.value = layer
    else this.#change('Change the layer of a line', (stroke) => [{ ...stroke, layer }])
  }

  /** Ends a gesture: the next change is another step. A point that was moved off its line's area takes the area along: nothing that is drawn fades. */
  settle(): void {
    if (this.#hasMoved) this.#coverPoint()
    this.#hasMoved = false
    this.session.settle()
  }

  /** As part of the step that has moved the point. */
  #coverPoint(): void {
    const [stroke, surface] = [this.chosen.peek(), this.#surface()]
    const document = this.session.document.peek()
    if (!stroke || !surface || !document) return
    const { canvas } = surface
    const point = splineOf(stroke, canvas).points[this.point.peek()]
    if (!point || isShownAt(document, stroke, point)) return
    const cover = (old: StudioDocument) => withArea(old, stroke, canvas)
    this.session.edit('Move a point', cover, this.#keyOf('points'))
  }

  #keyOf(gesture: string): string {
    return `line-${this.#index.peek()}-${gesture}`
  }

  #add(label: string, stroke: NewLine): void {
    const { canvas } = this.#surface()!
    this.session.edit(label, (document) => addLine(document, stroke, canvas))
    this.#index.value = this.session.document.peek()!.strokes.length - 1
    this.point.value = -1
  }

  #change(
    label: string,
    make: (stroke: LayerStroke, surface: LineSurface) => readonly LayerStroke[],
    key?: string,
  ): void {
    const stroke = this.chosen.peek()
    const surface = this.#surface()
    if (!stroke || !surface) return
    const changed = make(stroke, surface)
    if (changed[0] === stroke) return
    const operation = (document: StudioDocument) => replaceStroke(document, stroke, changed)
    this.session.edit(label, operation, key && this.#keyOf(key))
  }
}
