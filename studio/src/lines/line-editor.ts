import { computed, effect, type ReadonlySignal, signal } from '@preact/signals'
import { insertPoint, removePoint, type SkinCanvas, smoothStroke, splitStroke, type Uv } from 'furrow/author'
import { type MirrorPlane, mirrorStroke, splineOf } from 'furrow/internal'
import type { LayerStroke, StudioDocument } from '../document/document.ts'
import { replaceStroke } from '../document/strokes.ts'
import type { Session } from '../session/session.ts'
import { addLine, coverLine, isShownAt, type NewLine } from './line-area.ts'

/** Pointer mode on the face: orbit only, edit lines, or draw lines. */
export type LineMode = 'off' | 'edit' | 'draw'

/** Cross-section and ends of a line. */
export type LineShape = Pick<
  LayerStroke,
  'width' | 'depth' | 'softness' | 'shoulder' | 'bank' | 'lean' | 'taper'
>

/** Default: similar to a forehead wrinkle. */
const SHAPE: LineShape = { width: 3, depth: 0.6, softness: 0.4, shoulder: [0.6, 0.6], taper: [0.3, 0.3] }

/** Strength of "Smooth", 0..1. */
const SMOOTHING = 0.5

/** Surface on which lines are edited. */
export interface LineSurface {
  readonly canvas: SkinCanvas
  readonly middle: MirrorPlane | undefined
}

/** Holds the chosen line and edits it through operations of the session. */
export class LineEditor {
  readonly mode = signal<LineMode>('off')
  /** Shape of new lines. */
  readonly shape = signal<LineShape>(SHAPE)
  /** Group of new lines; if empty, the group of the area below them. */
  readonly group = signal('')
  /** Layer of new lines; if empty, the layer of their area. */
  readonly layer = signal('')
  /** Index of the chosen point, or -1. */
  readonly point = signal(-1)
  readonly session: Session
  readonly #surface: () => LineSurface | null
  /** Index of the chosen line. Operations and undo keep it. */
  readonly #index = signal(-1)
  /** Whether the current gesture moved a point. */
  #hasMoved = false

  /** Chosen line, or null. */
  readonly chosen: ReadonlySignal<LayerStroke | null> = computed(
    () => this.session.document.value?.strokes[this.#index.value] ?? null,
  )

  /** @param surface surface of the current face, or null without a document. */
  constructor(session: Session, surface: () => LineSurface | null) {
    this.session = session
    this.#surface = surface
    // Remaking the automatic wrinkles replaces their lines.
    const auto = computed(() => session.document.value?.auto)
    effect(() => {
      auto.value
      this.choose(null)
    })
  }

  /** Number of points of the chosen line, or 0. */
  get pointCount(): number {
    const [stroke, surface] = [this.chosen.value, this.#surface()]
    return stroke && surface ? splineOf(stroke, surface.canvas).points.length : 0
  }

  choose(stroke: LayerStroke | null): void {
    const { strokes } = this.session.document.peek() ?? {}
    this.#index.value = (stroke && strokes?.indexOf(stroke)) ?? -1
    this.point.value = -1
  }

  /** Moves the chosen point. Moves are one undo step until `settle`. */
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

  /** Adds a point to the chosen line and chooses it. Following moves belong to the same undo step until `settle`. */
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

  /** Removes the chosen point, or the line if no point is chosen or only two are left. */
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

  /** Splits the chosen line at its chosen point, or in the middle. The first part stays chosen. */
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

  /** Adds the mirror image of the chosen line and chooses it. */
  mirror(): void {
    const stroke = this.chosen.peek()
    const surface = this.#surface()
    if (!stroke || !surface) return
    this.#add('Mirror a line', mirrorStroke(stroke, surface.canvas, surface.middle))
  }

  /** Adds a line with the current shape, group and layer, and chooses it. */
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

  /** Changes the shape of the chosen line, or of new lines in draw mode. One undo step until `settle`. */
  setShape(fields: Partial<LineShape>): void {
    if (this.mode.peek() === 'draw') {
      this.shape.value = { ...this.shape.peek(), ...fields }
      return
    }
    const key = `shape-${Object.keys(fields)}`
    this.#change(`Change the ${Object.keys(fields)} of a line`, (stroke) => [{ ...stroke, ...fields }], key)
  }

  /** Assigns the line to another area. An area with a new name is added around the line. */
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
      return coverLine(replaceStroke(document, stroke, [changed]), changed, canvas)
    })
  }

  setLayer(layer: string): void {
    if (this.mode.peek() === 'draw') this.layer.value = layer
    else this.#change('Change the layer of a line', (stroke) => [{ ...stroke, layer }])
  }

  /** Ends a gesture and its undo step. Extends the line's area if a point was moved off it, so that the line stays visible. */
  settle(): void {
    if (this.#hasMoved) this.#coverPoint()
    this.#hasMoved = false
    this.session.settle()
  }

  /** Extends the area in the same undo step as the move. */
  #coverPoint(): void {
    const [stroke, surface] = [this.chosen.peek(), this.#surface()]
    const document = this.session.document.peek()
    if (!stroke || !surface || !document) return
    const { canvas } = surface
    const point = splineOf(stroke, canvas).points[this.point.peek()]
    if (!point || isShownAt(document, stroke, point)) return
    const cover = (old: StudioDocument) => coverLine(old, stroke, canvas)
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
