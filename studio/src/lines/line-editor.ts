import { computed, effect, type ReadonlySignal, signal } from '@preact/signals'
import { insertPoint, removePoint, smoothStroke, splitStroke, type Uv } from 'furrow/author'
import { detachStroke, type Fork, findForks, mirrorStroke, pullBranches, splineOf } from 'furrow/internal'
import type { LayerStroke, StudioDocument } from '../document/document.ts'
import { removeStroke, replaceStroke, replaceStrokes } from '../document/strokes.ts'
import type { Session } from '../session/session.ts'
import { counterpartOf, mirrorOnto } from './counterpart.ts'
import { type Handle, handlesOf } from './handles.ts'
import { addLine, coverLine, isShownAt, type NewLine } from './line-area.ts'
import { LINE_SHAPE, type LineShape, withShape } from './line-shape.ts'
import type { LineSurface } from './line-surface.ts'
import { PointMove } from './point-move.ts'

/**
 * Effect of the pointer on lines. `off`: none. `select`: chooses a line, and deepens it by a drag. `edit`: moves points. `smooth` and `erase`
 * change the lines that the pointer touches.
 */
export type LineMode = 'off' | 'select' | 'edit' | 'draw' | 'smooth' | 'erase'

/** Strength of the command Smooth, 0..1. */
const SMOOTHING = 0.5

/** Stores which wrinkle line is chosen, and edits this line. */
export class LineEditor {
  readonly mode = signal<LineMode>('off')
  /** Whether lines are being edited. In the mode `select`, the pointer also has other uses. */
  readonly isEditing = computed(() => this.mode.value !== 'off' && this.mode.value !== 'select')
  /** Whether a change of a line also changes its counterpart on the other half of the face. */
  readonly mirrored = signal(false)
  readonly shape = signal(LINE_SHAPE)
  /** Group of new lines. If empty, each line gets the name of the area that covers it. */
  readonly group = signal('')
  /** Layer of new lines. If empty, each line gets the layer of its area. */
  readonly layer = signal('')
  /** Index of the chosen point in `handles`, or -1. */
  readonly point = signal(-1)
  /** Areas that the last drawn line added, because it was drawn on bare skin. The user has not chosen yet when they show. */
  readonly added = signal<readonly string[]>([])
  readonly session: Session
  readonly #surface: () => LineSurface | null
  /** Index of the chosen line. It stays valid when an operation or undo replaces the object of the line. */
  readonly #index = signal(-1)
  /** Current gesture that moves a point, or null. */
  #move: PointMove | null = null
  /** Counterparts of lines, found since the last call of `settle`. The keys and values are indices of lines. */
  readonly #counterparts = new Map<number, number>()

  readonly chosen: ReadonlySignal<LayerStroke | null> = computed(
    () => this.session.document.value?.strokes[this.#index.value] ?? null,
  )

  /** Forks of all lines. */
  readonly forks: ReadonlySignal<readonly Fork[]> = computed(() => {
    const [document, surface] = [this.session.document.value, this.#surface()]
    return document && surface ? findForks(document.strokes, surface.lines) : []
  })

  /** Points of the chosen line, and forks on it, from its start to its end. */
  readonly handles: ReadonlySignal<readonly Handle[]> = computed(() => {
    const line = this.chosen.value && this.#surface()?.lines.lineOf(this.chosen.value)
    return line ? handlesOf(this.#index.value, line, this.forks.value) : []
  })

  /** Ends of the chosen line that are in a fork. 0: its start, 1: its end. */
  readonly attachedEnds: ReadonlySignal<readonly (0 | 1)[]> = computed(() =>
    this.forks.value.flatMap(({ ends }) =>
      ends.flatMap(({ stroke, end }) => (stroke === this.#index.value ? end : [])),
    ),
  )

  /** @param surface returns the skin of the current face, or null if there is no document. */
  constructor(session: Session, surface: () => LineSurface | null) {
    this.session = session
    this.#surface = surface
    // New automatic wrinkles replace lines, so the index of the chosen line would mean another line.
    const auto = computed(() => session.document.value?.auto)
    effect(() => {
      auto.value
      this.choose(null)
    })
  }

  /** Whether the current gesture has changed a line. */
  isMoving(stroke: LayerStroke): boolean {
    const { strokes } = this.session.document.peek() ?? {}
    return this.#move?.changed.has(strokes?.indexOf(stroke) ?? -1) ?? false
  }

  choose(stroke: LayerStroke | null): void {
    const { strokes } = this.session.document.peek() ?? {}
    this.#index.value = (stroke && strokes?.indexOf(stroke)) ?? -1
    this.added.value = []
    this.#counterparts.clear()
    this.point.value = -1
  }

  /** Chooses a fork and a line at it: the fork's trunk, or a line that ends at the fork if there is no trunk. */
  chooseFork(fork: Fork): void {
    const [{ stroke }] = [...fork.trunks, ...fork.ends]
    this.#index.value = stroke
    this.point.value = this.handles.peek().findIndex((handle) => handle.fork === fork)
  }

  /** Moves the chosen point. At a fork, moves all lines that meet there. All moves until `settle` are one undo step. */
  movePoint(uv: Uv): void {
    const [handle, surface] = [this.handles.peek()[this.point.peek()], this.#surface()]
    const document = this.session.document.peek()
    if (!handle || !surface || !document) return
    if (this.#move?.last !== document.strokes)
      this.#move = new PointMove(document.strokes, this.#index.peek(), handle, surface.lines)
    const changed = this.#withCounterparts(this.#move.to(uv), document)
    const label = this.#move.isFork ? 'Move a fork' : 'Move a point'
    this.session.edit(label, (old) => replaceStrokes(old, changed), this.#keyOf('points'))
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
      'Add a point',
      (stroke, { canvas }) => {
        const inserted = insertPoint(stroke, along, canvas)
        index = inserted.index
        return [inserted.stroke]
      },
      'points',
    )
    if (index >= 0) this.point.value = this.handles.peek().findIndex(({ knot }) => knot === index)
  }

  /** Removes the chosen point. Removes the line if no point is chosen or the line has only two points. */
  remove(): void {
    const { knot = -1, fork } = this.handles.peek()[this.point.peek()] ?? {}
    const stroke = this.chosen.peek()
    const canvas = this.#surface()?.canvas
    // A fork between two points of the chosen line has no point to remove: it is the end of another line.
    if (!stroke || !canvas || (fork && knot < 0)) return
    this.point.value = -1
    if (knot >= 0 && splineOf(stroke, canvas).points.length > 2)
      this.#changeTrunk('Remove a point', () => removePoint(stroke, knot, canvas), knot)
    else this.removeLine()
  }

  removeLine(): void {
    const stroke = this.chosen.peek()
    if (!stroke) return
    const other = this.#counterpart()
    const key = this.mode.peek() === 'erase' ? 'erase' : undefined
    const remove = (document: StudioDocument) => {
      const left = removeStroke(document, stroke)
      if (!other) return left
      // Removing a stroke can replace the objects of other strokes, but not their order.
      return removeStroke(
        left,
        left.strokes[other.index - (document.strokes.indexOf(stroke) < other.index ? 1 : 0)],
      )
    }
    this.session.edit('Remove a line', remove, key)
    this.choose(null)
  }

  smooth(): void {
    this.#changeTrunk('Smooth a line', (stroke, { canvas }) => smoothStroke(stroke, SMOOTHING, canvas))
  }

  /** Shortens the chosen line at its ends that are in forks. If it ends in the chosen fork, changes only that end. */
  detach(): void {
    const { fork } = this.handles.peek()[this.point.peek()] ?? {}
    const index = this.#index.peek()
    const strokes = this.session.document.peek()?.strokes ?? []
    const isEnd = fork?.ends.some(({ stroke }) => stroke === index)
    const forks = fork && isEnd ? [fork] : this.forks.peek()
    this.#change('Detach a line', (_, { lines }) => [detachStroke(strokes, index, forks, lines)])
    this.point.value = -1
  }

  /** Splits the chosen line at its chosen point or fork, or in the middle. The first part stays chosen. */
  split(): void {
    const { knot = -1, place = 0, fork } = this.handles.peek()[this.point.peek()] ?? {}
    this.#change('Split a line', (stroke, { canvas, lines }) => {
      const spline = splineOf(stroke, canvas)
      if (knot > 0 && knot < spline.points.length - 1) return splitStroke(spline, knot, canvas)
      const { lengths } = lines.lineOf(stroke)!
      const along = fork && knot < 0 ? lengths[place] / lengths[lengths.length - 1] : 0.5
      const added = insertPoint(spline, along, canvas)
      const at = added.index > 0 ? added.index : Math.floor(spline.points.length / 2)
      return splitStroke(added.stroke, at, canvas)
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
    const image = this.mirrored.peek() ? mirrorStroke(line, surface.canvas, surface.middle) : null
    this.session.edit('Draw a line', (document) => {
      const drawn = addLine(document, line, surface.canvas)
      if (!image) return drawn
      // A line across the middle of the face is its own counterpart.
      const probe = {
        ...drawn,
        strokes: [...drawn.strokes, { ...drawn.strokes.at(-1)!, ...image }] as LayerStroke[],
      }
      const isOwn = counterpartOf(probe.strokes, drawn.strokes.length - 1, surface) < 0
      return isOwn ? drawn : addLine(drawn, image, surface.canvas)
    })
    const { strokes, areas } = this.session.document.peek()!
    this.added.value = areas.map(({ name }) => name).filter((name) => !known.has(name))
    this.#index.value = strokes.findLastIndex((stroke) => stroke.points === points)
    this.point.value = -1
  }

  /** Changes the shape of the chosen line, or of new lines in draw mode. Changes of a field until `settle` are one undo step. */
  setShape(fields: Partial<LineShape>): void {
    if (this.#isNew) {
      this.shape.value = { ...this.shape.peek(), ...fields }
      return
    }
    const key = `shape-${Object.keys(fields)}`
    const attached = this.attachedEnds.peek()
    const make = (stroke: LayerStroke) => [withShape(stroke, fields, attached)]
    this.#change(`Change the ${Object.keys(fields)} of a line`, make, key, (other) =>
      withShape(other, fields, attached),
    )
  }

  /** Whether changes apply to new lines, because no line is chosen. */
  get #isNew(): boolean {
    return this.mode.peek() === 'draw' && !this.chosen.peek()
  }

  /** Sets the group of the chosen line, or of new lines in draw mode. Adds an area with this name if there is none. */
  setGroup(group: string): void {
    if (this.#isNew) {
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
    if (this.#isNew) this.layer.value = layer
    else this.#change('Change the layer of a line', (stroke) => [{ ...stroke, layer }])
  }

  /** Ends a gesture and its undo step. If the gesture moved a point out of the line's area, extends the area to keep the line visible. */
  settle(): void {
    this.#counterparts.clear()
    if (this.#move) this.#coverPoint(this.#move)
    this.#move = null
    this.session.settle()
  }

  /** Extends areas to the moved point, in the same undo step as the move. */
  #coverPoint({ indices, uv }: PointMove): void {
    const canvas = this.#surface()?.canvas
    if (!canvas) return
    for (const index of indices) {
      const document = this.session.document.peek()
      const stroke = document?.strokes[index]
      if (!stroke || isShownAt(document, stroke, uv)) continue
      const cover = (old: StudioDocument) => coverLine(old, stroke, canvas)
      this.session.edit('Move a point', cover, this.#keyOf('points'))
    }
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

  /** Changes the chosen line. Lines that end on it stay attached. @param removed index of a point that the change removes. */
  #changeTrunk(
    label: string,
    make: (stroke: LayerStroke, surface: LineSurface) => LayerStroke,
    removed?: number,
  ): void {
    const [stroke, surface, document] = [this.chosen.peek(), this.#surface(), this.session.document.peek()]
    if (!stroke || !surface || !document) return
    const forked = { strokes: document.strokes, forks: this.forks.peek(), lines: surface.lines }
    const changed = pullBranches(forked, new Map([[this.#index.peek(), make(stroke, surface)]]), removed)
    const all = this.#withCounterparts(changed, document)
    this.session.edit(label, (old) => replaceStrokes(old, all))
  }

  /**
   * Replaces the chosen line.
   *
   * @param changeOther returns the changed counterpart of the line. Default: the counterpart does not change.
   */
  #change(
    label: string,
    make: (stroke: LayerStroke, surface: LineSurface) => readonly LayerStroke[],
    key?: string,
    changeOther?: (other: LayerStroke) => LayerStroke,
  ): void {
    const stroke = this.chosen.peek()
    const surface = this.#surface()
    if (!stroke || !surface) return
    const changed = make(stroke, surface)
    if (changed[0] === stroke) return
    const other = changeOther && this.#counterpart()
    const operation = (document: StudioDocument) => {
      const own = other ? replaceStroke(document, other.stroke, [changeOther(other.stroke)]) : document
      return replaceStroke(own, stroke, changed)
    }
    this.session.edit(label, operation, key && this.#keyOf(key))
  }

  /** Returns the counterpart of the chosen line. Null if there is none, or if `mirrored` is false. */
  #counterpart(): { stroke: LayerStroke; index: number } | null {
    const [document, surface] = [this.session.document.peek(), this.#surface()]
    if (!this.mirrored.peek() || !document || !surface) return null
    const index = this.#counterpartIndex(this.#index.peek(), document, surface)
    return index < 0 ? null : { stroke: document.strokes[index], index }
  }

  #counterpartIndex(index: number, { strokes }: StudioDocument, surface: LineSurface): number {
    const known = this.#counterparts.get(index)
    if (known !== undefined) return known
    const found = counterpartOf(strokes, index, surface)
    this.#counterparts.set(index, found)
    return found
  }

  /** Adds the counterparts of changed lines, as mirror images, if `mirrored` is true. @param document document before the change. */
  #withCounterparts(
    changed: ReadonlyMap<number, LayerStroke>,
    document: StudioDocument,
  ): ReadonlyMap<number, LayerStroke> {
    const surface = this.#surface()
    if (!this.mirrored.peek() || !surface) return changed
    const all = new Map(changed)
    for (const [index, stroke] of changed) {
      const other = this.#counterpartIndex(index, document, surface)
      if (other >= 0 && !changed.has(other))
        all.set(other, mirrorOnto(stroke, document.strokes[other], surface))
    }
    return all
  }
}
