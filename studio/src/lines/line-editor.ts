import { computed, type ReadonlySignal, signal } from '@preact/signals'
import { insertPoint, removePoint, smoothStroke, type Uv } from 'furrow/author'
import {
  detachStroke,
  type Fork,
  grabWeights,
  heldEnds,
  mirrorStroke,
  pullBranches,
  splineOf,
} from 'furrow/internal'
import type { LayerStroke, StudioDocument } from '../document/document.ts'
import { otherSide } from '../document/sides.ts'
import { replaceStroke, replaceStrokes } from '../document/strokes.ts'
import { lineFieldsStep, linesStep, STEP } from '../labels/steps.ts'
import type { Session } from '../session/session.ts'
import { Counterparts } from './counterpart.ts'
import type { Handle } from './handles.ts'
import { addLine, coverLine, coverMoved, type NewLine } from './line-area.ts'
import { addWithImage, removeLines, splitAt } from './line-changes.ts'
import { LineSelection } from './line-selection.ts'
import { LINE_SHAPE, type LineShape, withShape } from './line-shape.ts'
import type { LineSurface } from './line-surface.ts'
import { PointMove } from './point-move.ts'

/**
 * Effect of the pointer on lines. `off`: none. `select`: chooses a line, and deepens it by a drag. `edit`: moves points. `smooth` and `erase`
 * change the lines that the pointer touches.
 */
export type LineMode = 'off' | 'select' | 'edit' | 'draw' | 'smooth' | 'erase'

/** Strength of the command Smooth, 0..1. */
const SMOOTHING = 0.8

/** Range of `LineEditor.reach`, and its default, millimetres. */
export const REACH_RANGE = [0, 60] as const
const REACH = 15
/** Minimum distance from all points at which a dragged line gets a new point, millimetres. It also depends on the reach. */
const NEAR = 4
/** Change of `LineEditor.reach` per key press, millimetres. */
const REACH_STEP = 2.5

/** Edits the chosen wrinkle lines. */
export class LineEditor {
  readonly mode = signal<LineMode>('off')
  /** Whether lines are being edited. In the mode `select`, the pointer also has other uses. */
  readonly isEditing = computed(() => this.mode.value !== 'off' && this.mode.value !== 'select')
  /** Whether a change of a line also changes its counterpart on the other half of the face. */
  readonly mirrored = signal(false)
  /** Distance along the line up to which a moved point takes its neighbours along, millimetres. 0: it moves alone. */
  readonly reach = signal(REACH)
  readonly shape = signal(LINE_SHAPE)
  /** Group of new lines. If empty, each line gets the name of the area that covers it. */
  readonly group = signal('')
  /** Layer of new lines. If empty, each line gets the layer of its area. */
  readonly layer = signal('')
  /** Areas that the last drawn line added, because it was drawn on bare skin. The user has not chosen yet when they show. */
  readonly added = signal<readonly string[]>([])
  readonly session: Session
  readonly #surface: () => LineSurface | null
  readonly #selection: LineSelection
  /** Current gesture that moves a point, or null. */
  #move: PointMove | null = null
  /** Indices of the lines that the current gesture has changed. */
  #moved: ReadonlySet<number> = new Set()
  readonly #counterparts = new Counterparts()

  /** @param surface returns the skin of the current face, or null if there is no document. */
  constructor(session: Session, surface: () => LineSurface | null) {
    this.session = session
    this.#surface = surface
    this.#selection = new LineSelection(session, surface)
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
    return this.#moved.has(strokes?.indexOf(stroke) ?? -1)
  }

  choose(stroke: LayerStroke | null): void {
    this.#selection.choose(stroke)
    this.added.value = []
    this.#counterparts.forget()
  }

  /** Adds a line to the chosen lines, or removes it from them. */
  toggle(stroke: LayerStroke): void {
    this.#selection.toggle(stroke)
    this.added.value = []
    this.#counterparts.forget()
  }

  /** Chooses all lines with the group of the main line. */
  chooseGroup(): void {
    this.#selection.chooseGroup()
    this.#counterparts.forget()
  }

  /** Makes a chosen line the main one, whose points can be moved. */
  makeMain(stroke: LayerStroke): void {
    this.#selection.makeMain(stroke)
  }

  /** Chooses a fork and a line at it: the fork's trunk, or a line that ends at the fork if there is no trunk. */
  chooseFork(fork: Fork): void {
    this.#selection.chooseFork(fork)
  }

  /** Returns the fraction of a handle's motion that each handle would make. @param index index of the moved handle. */
  grabWeights(index: number): readonly number[] {
    const [handles, stroke] = [this.handles.peek(), this.chosen.peek()]
    const line = stroke && this.#surface()?.lines.lineOf(stroke)
    const moved = handles[index]
    if (!line || !moved) return []
    const places = { lengths: line.lengths, knots: handles.map(({ place }) => place) }
    return grabWeights(
      places,
      index,
      this.reach.peek(),
      heldEnds(this.forks.peek(), this.#selection.index, moved.fork),
    )
  }

  /**
   * Moves the chosen point of the main line, and points near it; a fork with all lines that meet there. Moves the other chosen lines alike. All
   * moves until `settle` are one undo step.
   *
   * @param isAlone whether no neighbouring points move, whatever `reach` is.
   */
  movePoint(uv: Uv, isAlone = false): void {
    this.#moveTo(() => uv, isAlone)
  }

  /** Moves the chosen point like `movePoint`, by the motion of the pointer from one place to another. */
  dragPoint(from: Uv, to: Uv, isAlone = false): void {
    this.#moveTo((move) => move.follow(from, to), isAlone)
  }

  #moveTo(target: (move: PointMove) => Uv | null, isAlone: boolean): void {
    const [{ handle, indices }, surface] = [this.#selection, this.#surface()]
    const document = this.session.document.peek()
    if (!handle || !surface || !document) return
    if (this.#move?.last !== document.strokes)
      this.#move = new PointMove(document.strokes, indices, handle, surface.lines)
    const uv = target(this.#move)
    if (!uv) return
    const changed = this.#withCounterparts(this.#move.to(uv, isAlone ? 0 : this.reach.peek()), document)
    this.#moved = new Set(changed.keys())
    this.session.edit(this.#move.label, (old) => replaceStrokes(old, changed), this.#keyOf('points'))
    this.#move.last = this.session.document.peek()!.strokes
  }

  /**
   * Adds a point to the chosen line and chooses the point. The addition and all moves of the point until `settle` are one undo step.
   *
   * @param along position on the line, 0..1.
   */
  insertPoint(along: number): void {
    let index = -1
    this.#change(
      STEP.addPoint,
      (stroke, { canvas }) => {
        const inserted = insertPoint(stroke, along, canvas)
        index = inserted.index
        return [inserted.stroke]
      },
      'points',
    )
    if (index >= 0) this.point.value = this.handles.peek().findIndex(({ knot }) => knot === index)
  }

  /** Chooses the handle of the main line that is nearest to a place. If none is near, adds a point there. @param along place on the line, 0..1. */
  choosePointNear(along: number): void {
    const line = this.chosen.peek() && this.#surface()?.lines.lineOf(this.chosen.peek()!)
    if (!line) return
    const total = line.lengths[line.lengths.length - 1]
    const apart = this.handles.peek().map(({ place }) => Math.abs(line.lengths[place] - along * total))
    const least = Math.min(...apart)
    if (least <= Math.max(this.reach.peek() / 2, NEAR)) this.point.value = apart.indexOf(least)
    else this.insertPoint(along)
  }

  /** Removes the chosen point. Removes the chosen lines if no point is chosen, or if the line has only two points. */
  remove(): void {
    const { knot = -1, fork } = this.#selection.handle ?? {}
    const stroke = this.chosen.peek()
    const canvas = this.#surface()?.canvas
    // A fork between two points of the chosen line has no point to remove: it is the end of another line.
    if (!stroke || !canvas || (fork && knot < 0)) return
    this.point.value = -1
    if (knot >= 0 && splineOf(stroke, canvas).points.length > 2)
      this.#changeTrunks(STEP.removePoint, [this.#selection.index], () => removePoint(stroke, knot, canvas), {
        removed: knot,
      })
    else this.removeLine()
  }

  /** Removes the chosen lines. */
  removeLine(): void {
    const [{ indices }, document] = [this.#selection, this.session.document.peek()]
    if (indices.length === 0 || !document) return
    const chosen = new Map(indices.map((index) => [index, document.strokes[index]]))
    const all = [...this.#withCounterparts(chosen, document).keys()]
    const key = this.mode.peek() === 'erase' ? 'erase' : undefined
    this.session.edit(linesStep('Remove', indices.length), (old) => removeLines(old, all), key)
    this.choose(null)
  }

  /** Smooths the chosen lines. */
  smooth(): void {
    const { indices } = this.#selection
    const make = (stroke: LayerStroke, { canvas }: LineSurface) => smoothStroke(stroke, SMOOTHING, canvas)
    const key = this.mode.peek() === 'smooth' ? 'smooth' : undefined
    this.#changeTrunks(linesStep('Smooth', indices.length), indices, make, { key })
  }

  /** Shortens the chosen line at its ends that are in forks. If it ends in the chosen fork, changes only that end. */
  detach(): void {
    const [{ handle, index }] = [this.#selection]
    const fork = handle?.fork
    const strokes = this.session.document.peek()?.strokes ?? []
    const isEnd = fork?.ends.some(({ stroke }) => stroke === index)
    const forks = fork && isEnd ? [fork] : this.forks.peek()
    this.#change(STEP.detachLine, (_, { lines }) => [detachStroke(strokes, index, forks, lines)])
    this.point.value = -1
  }

  /** Splits the main line at its chosen point or fork, or in the middle. The first part stays chosen. */
  split(): void {
    const { handle, index } = this.#selection
    this.#change(STEP.splitLine, (stroke, surface) => splitAt(stroke, handle, surface))
    this.#selection.chooseIndices([index])
  }

  /** Adds the mirror images of the chosen lines and chooses them. */
  mirror(): void {
    const [{ indices }, surface] = [this.#selection, this.#surface()]
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

  /** Adds a line with the current shape, group and layer, and chooses it. Also adds its mirror image if `mirrored` is true. */
  draw(points: Uv[]): void {
    const [group, layer, surface] = [this.group.peek(), this.layer.peek(), this.#surface()]
    if (!surface) return
    const line: NewLine = {
      ...this.shape.peek(),
      ...(group && { group }),
      ...(layer && { layer }),
      curve: 'spline',
      points,
      waviness: 0,
    }
    const known = new Set(this.session.document.peek()?.areas.map(({ name }) => name))
    this.session.edit(STEP.drawLine, (document) =>
      this.mirrored.peek() ? addWithImage(document, line, surface) : addLine(document, line, surface.canvas),
    )
    const { strokes, areas } = this.session.document.peek()!
    this.added.value = areas.map(({ name }) => name).filter((name) => !known.has(name))
    this.#selection.chooseIndices([strokes.findLastIndex((stroke) => stroke.points === points)])
  }

  /** Changes the shape of the chosen lines, or of new lines in draw mode. Changes of a field until `settle` are one undo step. */
  setShape(fields: Partial<LineShape>): void {
    if (this.#isNew) {
      this.shape.value = { ...this.shape.peek(), ...fields }
      return
    }
    const [{ indices }, document, surface] = [this.#selection, this.session.document.peek(), this.#surface()]
    if (!document || !surface) return
    const change = (stroke: LayerStroke, index: number) =>
      withShape(stroke, fields, this.#selection.attachedEnds(index))
    const changed = new Map(indices.map((index) => [index, change(document.strokes[index], index)]))
    const all = this.mirrored.peek()
      ? this.#counterparts.add(changed, document.strokes, surface, (other, _, index) => change(other, index))
      : changed
    const label = lineFieldsStep(Object.keys(fields) as (keyof LineShape)[], indices.length)
    this.session.edit(label, (old) => replaceStrokes(old, all), this.#keyOf(`shape-${Object.keys(fields)}`))
  }

  /** Whether changes apply to new lines, because no line is chosen. */
  get #isNew(): boolean {
    return this.mode.peek() === 'draw' && !this.chosen.peek()
  }

  /** Sets the group of the chosen lines, or of new lines in draw mode. Adds an area with this name if there is none. */
  setGroup(group: string): void {
    if (this.#isNew) {
      this.group.value = group
      return
    }
    const [{ indices }, document, surface] = [this.#selection, this.session.document.peek(), this.#surface()]
    const others = indices.filter((index) => document?.strokes[index].group !== group)
    if (!document || !surface || others.length === 0 || group === '') return
    const changed = new Map(others.map((index) => [index, { ...document.strokes[index], group }]))
    const other = otherSide(group)
    const all = this.mirrored.peek()
      ? this.#counterparts.add(changed, document.strokes, surface, (stroke) => ({ ...stroke, group: other }))
      : changed
    this.session.edit(lineFieldsStep(['group'], others.length), (old) =>
      [...all.values()].reduce(
        (next, stroke) => coverLine(next, stroke, surface.canvas),
        replaceStrokes(old, all),
      ),
    )
  }

  /** Sets the layer of the chosen lines, or of new lines in draw mode. */
  setLayer(layer: string): void {
    if (this.#isNew) {
      this.layer.value = layer
      return
    }
    const { indices } = this.#selection
    this.session.edit(lineFieldsStep(['layer'], indices.length), (document) =>
      replaceStrokes(
        document,
        new Map(indices.map((index) => [index, { ...document.strokes[index], layer }])),
      ),
    )
  }

  /** Ends a gesture and its undo step. If the gesture moved points out of the areas of their lines, extends the areas to keep the lines visible. */
  settle(): void {
    this.#counterparts.forget()
    if (this.#move) this.#coverPoints(this.#move)
    this.#move = null
    this.#moved = new Set()
    this.session.settle()
  }

  /** Extends areas to the moved points, in the same undo step as the move. */
  #coverPoints(move: PointMove): void {
    const canvas = this.#surface()?.canvas
    if (!canvas) return
    const cover = (document: StudioDocument) =>
      [...this.#moved].reduce((covered, index) => {
        const handle = move.hasHandle(index) ? move.uv : null
        return coverMoved(covered, document.strokes[index], move.first[index], handle, canvas)
      }, document)
    this.session.edit(move.label, cover, this.#keyOf('points'))
  }

  #keyOf(gesture: string): string {
    return `line-${this.#selection.indices}-${gesture}`
  }

  /**
   * Changes lines. Lines that end on them stay attached.
   *
   * @param removed index of a point that the change removes.
   * @param key consecutive changes with the same key become one undo step.
   */
  #changeTrunks(
    label: string,
    indices: readonly number[],
    make: (stroke: LayerStroke, surface: LineSurface) => LayerStroke,
    { removed, key }: { removed?: number; key?: string | undefined } = {},
  ): void {
    const [surface, document] = [this.#surface(), this.session.document.peek()]
    if (indices.length === 0 || !surface || !document) return
    const forked = { strokes: document.strokes, forks: this.forks.peek(), lines: surface.lines }
    const made = new Map(indices.map((index) => [index, make(document.strokes[index], surface)]))
    const all = this.#withCounterparts(pullBranches(forked, made, removed), document)
    this.session.edit(label, (old) => replaceStrokes(old, all), key)
  }

  /** Replaces the main chosen line by one or several lines. */
  #change(
    label: string,
    make: (stroke: LayerStroke, surface: LineSurface) => readonly LayerStroke[],
    key?: string,
  ): void {
    const [stroke, surface] = [this.chosen.peek(), this.#surface()]
    if (!stroke || !surface) return
    const changed = make(stroke, surface)
    if (changed[0] === stroke) return
    this.session.edit(label, (document) => replaceStroke(document, stroke, changed), key && this.#keyOf(key))
  }

  /** Adds the counterparts of changed lines, as mirror images, if `mirrored` is true. @param document document before the change. */
  #withCounterparts(
    changed: ReadonlyMap<number, LayerStroke>,
    { strokes }: StudioDocument,
  ): ReadonlyMap<number, LayerStroke> {
    const surface = this.#surface()
    return this.mirrored.peek() && surface ? this.#counterparts.add(changed, strokes, surface) : changed
  }
}

/** Returns `LineEditor.reach` after a key press. */
export function nextReach(reach: number, change: 'smaller' | 'larger'): number {
  const next = reach + (change === 'larger' ? REACH_STEP : -REACH_STEP)
  return Math.min(Math.max(next, REACH_RANGE[0]), REACH_RANGE[1])
}
