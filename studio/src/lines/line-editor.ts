import { computed, type ReadonlySignal, signal } from '@preact/signals'
import { smoothStroke, type Uv } from 'furrow/author'
import { detachStroke, type Fork, mirrorStroke } from 'furrow/internal'
import type { LayerStroke } from '../document/document.ts'
import { linesStep, STEP } from '../labels/steps.ts'
import type { Session } from '../session/session.ts'
import type { Handle } from './handles.ts'
import { addLine, type NewLine } from './line-area.ts'
import { addWithImage, removeLines, splitAt } from './line-changes.ts'
import { LineEdits } from './line-edits.ts'
import { LineFields } from './line-fields.ts'
import { LinePoints } from './line-points.ts'
import { LineSelection } from './line-selection.ts'
import type { LineSurface } from './line-surface.ts'

/**
 * Effect of the pointer on lines. `off`: none. `select`: chooses a line, and deepens it by a drag. `edit`: moves points. `smooth` and `erase`
 * change the lines that the pointer touches.
 */
export type LineMode = 'off' | 'select' | 'edit' | 'draw' | 'smooth' | 'erase'

/** Strength of the command Smooth, 0..1. */
const SMOOTHING = 0.8

/** Edits the chosen wrinkle lines. */
export class LineEditor {
  readonly mode = signal<LineMode>('off')
  /** Whether lines are being edited. In the mode `select`, the pointer also has other uses. */
  readonly isEditing = computed(() => this.mode.value !== 'off' && this.mode.value !== 'select')
  /** Areas that the last drawn line added, because it was drawn on bare skin. The user has not chosen yet when they show. */
  readonly added = signal<readonly string[]>([])
  readonly session: Session
  readonly fields: LineFields
  readonly points: LinePoints
  readonly #selection: LineSelection
  readonly #edits: LineEdits

  /** @param surface returns the skin of the current face, or null if there is no document. */
  constructor(session: Session, surface: () => LineSurface | null) {
    this.session = session
    this.#selection = new LineSelection(session, surface)
    this.#edits = new LineEdits(session, this.#selection, surface)
    this.points = new LinePoints(this.#edits)
    const isNew = computed(() => this.mode.value === 'draw' && !this.chosen.value)
    this.fields = new LineFields(this.#edits, isNew)
  }

  /** Whether a change of a line also changes its counterpart on the other half of the face. */
  get mirrored() {
    return this.#edits.mirrored
  }

  /** Main chosen line, or null. */
  get chosen(): ReadonlySignal<LayerStroke | null> {
    return this.#selection.main
  }

  /** All chosen lines, first the main one. */
  get allChosen(): ReadonlySignal<readonly LayerStroke[]> {
    return this.#selection.all
  }

  /** Index of the chosen point in `handles`, or -1. */
  get point() {
    return this.#selection.point
  }

  /** Forks of all lines. */
  get forks(): ReadonlySignal<readonly Fork[]> {
    return this.#selection.forks
  }

  /** Points of the main chosen line, and forks on it, from its start to its end. */
  get handles(): ReadonlySignal<readonly Handle[]> {
    return this.#selection.handles
  }

  /** Ends of the main chosen line that are in a fork. 0: its start, 1: its end. */
  readonly attachedEnds: ReadonlySignal<readonly (0 | 1)[]> = computed(() => {
    this.forks.value
    this.chosen.value
    return this.#selection.attachedEnds(this.#selection.index)
  })

  /** Whether the current gesture has changed a line. */
  isMoving(stroke: LayerStroke): boolean {
    const { strokes } = this.session.document.peek() ?? {}
    return this.points.isMoving(strokes?.indexOf(stroke) ?? -1)
  }

  choose(stroke: LayerStroke | null): void {
    this.#selection.choose(stroke)
    this.added.value = []
    this.#edits.forgetCounterparts()
  }

  /** Adds a line to the chosen lines, or removes it from them. */
  toggle(stroke: LayerStroke): void {
    this.#selection.toggle(stroke)
    this.added.value = []
    this.#edits.forgetCounterparts()
  }

  /** Chooses all lines with the group of the main line. */
  chooseGroup(): void {
    this.#selection.chooseGroup()
    this.#edits.forgetCounterparts()
  }

  /** Makes a chosen line the main one, whose points can be moved. */
  makeMain(stroke: LayerStroke): void {
    this.#selection.makeMain(stroke)
  }

  /** Chooses a fork and a line at it: the fork's trunk, or a line that ends at the fork if there is no trunk. */
  chooseFork(fork: Fork): void {
    this.#selection.chooseFork(fork)
  }

  /** Removes the chosen point. Removes the chosen lines if no point is chosen, or if the line has only two points. */
  remove(): void {
    if (!this.points.remove()) this.removeLine()
  }

  /** Removes the chosen lines. */
  removeLine(): void {
    const [{ indices }, document] = [this.#selection, this.session.document.peek()]
    if (indices.length === 0 || !document) return
    const chosen = new Map(indices.map((index) => [index, document.strokes[index]]))
    const all = [...this.#edits.withCounterparts(chosen, document.strokes).keys()]
    const key = this.mode.peek() === 'erase' ? 'erase' : undefined
    this.session.edit(linesStep('Remove', indices.length), (old) => removeLines(old, all), key)
    this.choose(null)
  }

  /** Smooths the chosen lines. */
  smooth(): void {
    const { indices } = this.#selection
    const make = (stroke: LayerStroke, { canvas }: LineSurface) => smoothStroke(stroke, SMOOTHING, canvas)
    const key = this.mode.peek() === 'smooth' ? 'smooth' : undefined
    this.#edits.changeTrunks(linesStep('Smooth', indices.length), indices, make, { key })
  }

  /** Shortens the chosen line at its ends that are in forks. If it ends in the chosen fork, changes only that end. */
  detach(): void {
    const { handle, index } = this.#selection
    const fork = handle?.fork
    const strokes = this.session.document.peek()?.strokes ?? []
    const isEnd = fork?.ends.some(({ stroke }) => stroke === index)
    const forks = fork && isEnd ? [fork] : this.forks.peek()
    this.#edits.replaceMain(STEP.detachLine, (_, { lines }) => [detachStroke(strokes, index, forks, lines)])
    this.point.value = -1
  }

  /** Splits the main line at its chosen point or fork, or in the middle. The first part stays chosen. */
  split(): void {
    const { handle, index } = this.#selection
    this.#edits.replaceMain(STEP.splitLine, (stroke, surface) => splitAt(stroke, handle, surface))
    this.#selection.chooseIndices([index])
  }

  /** Adds the mirror images of the chosen lines and chooses them. */
  mirror(): void {
    const [{ indices }, { surface }] = [this.#selection, this.#edits]
    if (indices.length === 0 || !surface) return
    const { canvas, middle } = surface
    this.session.edit(linesStep('Mirror', indices.length), (document) =>
      indices.reduce(
        (added, index) => addLine(added, mirrorStroke(document.strokes[index], canvas, middle), canvas),
        document,
      ),
    )
    const count = this.session.document.peek()!.strokes.length
    this.#selection.chooseIndices(indices.map((_, i) => count - indices.length + i))
  }

  /** Adds a line with the fields of new lines, and chooses it. Also adds its mirror image if `mirrored` is true. */
  draw(points: Uv[]): void {
    const { surface } = this.#edits
    if (!surface) return
    const line: NewLine = { ...this.fields.ofNewLine, curve: 'spline', points, waviness: 0 }
    const known = new Set(this.session.document.peek()?.areas.map(({ name }) => name))
    this.session.edit(STEP.drawLine, (document) =>
      this.mirrored.peek() ? addWithImage(document, line, surface) : addLine(document, line, surface.canvas),
    )
    const { strokes, areas } = this.session.document.peek()!
    this.added.value = areas.map(({ name }) => name).filter((name) => !known.has(name))
    this.#selection.chooseIndices([strokes.findLastIndex((stroke) => stroke.points === points)])
  }

  /** Ends a gesture and its undo step. */
  settle(): void {
    this.#edits.forgetCounterparts()
    this.points.settle()
    this.session.settle()
  }
}
