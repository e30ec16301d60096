import { signal } from '@preact/signals'
import { pullBranches } from 'furrow/internal'
import type { LayerStroke } from '../document/document.ts'
import { replaceStroke, replaceStrokes } from '../document/strokes.ts'
import type { Session } from '../session/session.ts'
import { Counterparts } from './counterpart.ts'
import type { LineSelection } from './line-selection.ts'
import type { LineSurface } from './line-surface.ts'

/** Changed strokes. The keys are their indices in the document. */
export type ChangedStrokes = ReadonlyMap<number, LayerStroke>

/** Applies changes of the chosen lines to the document. If lines are mirrored, changes their counterparts too. */
export class LineEdits {
  /** Whether a change of a line also changes its counterpart on the other half of the face. */
  readonly mirrored = signal(false)
  readonly session: Session
  readonly selection: LineSelection
  readonly #surface: () => LineSurface | null
  readonly #counterparts = new Counterparts()

  /** @param surface returns the skin of the current face, or null if there is no document. */
  constructor(session: Session, selection: LineSelection, surface: () => LineSurface | null) {
    this.session = session
    this.selection = selection
    this.#surface = surface
  }

  get surface(): LineSurface | null {
    return this.#surface()
  }

  /** Returns the key that joins consecutive changes of the chosen lines to one undo step. */
  keyOf(gesture: string): string {
    return `line-${this.selection.indices}-${gesture}`
  }

  /** Ends a gesture, during which the counterparts of lines stay the same. */
  forgetCounterparts(): void {
    this.#counterparts.forget()
  }

  /**
   * Adds the counterparts of changed lines, if lines are mirrored.
   *
   * @param strokes strokes of the document before the change.
   * @param change returns the changed counterpart. Default: the mirror image of the changed line.
   */
  withCounterparts(
    changed: ChangedStrokes,
    strokes: readonly LayerStroke[],
    change?: (other: LayerStroke, stroke: LayerStroke, index: number) => LayerStroke,
  ): ChangedStrokes {
    const { surface } = this
    return this.mirrored.peek() && surface
      ? this.#counterparts.add(changed, strokes, surface, change)
      : changed
  }

  /** Replaces the main chosen line by one or several lines. @param gesture see `keyOf`. */
  replaceMain(
    label: string,
    make: (stroke: LayerStroke, surface: LineSurface) => readonly LayerStroke[],
    gesture?: string,
  ): void {
    const [stroke, { surface }] = [this.selection.main.peek(), this]
    if (!stroke || !surface) return
    const changed = make(stroke, surface)
    if (changed[0] === stroke) return
    const key = gesture && this.keyOf(gesture)
    this.session.edit(label, (document) => replaceStroke(document, stroke, changed), key)
  }

  /**
   * Changes lines. Lines that end on them stay attached.
   *
   * @param removed index of a point that the change removes.
   * @param key consecutive changes with the same key become one undo step.
   */
  changeTrunks(
    label: string,
    indices: readonly number[],
    make: (stroke: LayerStroke, surface: LineSurface) => LayerStroke,
    { removed, key }: { removed?: number; key?: string | undefined } = {},
  ): void {
    const [{ surface }, document] = [this, this.session.document.peek()]
    if (indices.length === 0 || !surface || !document) return
    const { strokes } = document
    const forked = { strokes, forks: this.selection.forks.peek(), lines: surface.lines }
    const made = new Map(indices.map((index) => [index, make(strokes[index], surface)]))
    const all = this.withCounterparts(pullBranches(forked, made, removed), strokes)
    this.session.edit(label, (old) => replaceStrokes(old, all), key)
  }
}
