import { type ReadonlySignal, signal } from '@preact/signals'
import type { LayerStroke } from '../document/document.ts'
import { otherSide } from '../document/sides.ts'
import { replaceStrokes } from '../document/strokes.ts'
import { lineFieldsStep } from '../labels/steps.ts'
import { coverLine, type NewLine } from './line-area.ts'
import type { LineEdits } from './line-edits.ts'
import { LINE_SHAPE, type LineShape, withShape } from './line-shape.ts'

/** Shape, group and layer of the chosen lines, and of new lines. */
export class LineFields {
  /** Shape of new lines. */
  readonly shape = signal(LINE_SHAPE)
  /** Group of new lines. If empty, each line gets the name of the area that covers it. */
  readonly group = signal('')
  /** Layer of new lines. If empty, each line gets the layer of its area. */
  readonly layer = signal('')
  /** Whether changes apply to new lines. */
  readonly isNew: ReadonlySignal<boolean>
  readonly #edits: LineEdits

  constructor(edits: LineEdits, isNew: ReadonlySignal<boolean>) {
    this.#edits = edits
    this.isNew = isNew
  }

  /** Fields of a new line. */
  get ofNewLine(): Omit<NewLine, 'points' | 'curve' | 'waviness'> {
    const [group, layer] = [this.group.peek(), this.layer.peek()]
    return { ...this.shape.peek(), ...(group && { group }), ...(layer && { layer }) }
  }

  /** Sets the shape of the chosen lines, or of new lines. Changes of a field until `LineEditor.settle` are one undo step. */
  setShape(fields: Partial<LineShape>): void {
    if (this.isNew.peek()) {
      this.shape.value = { ...this.shape.peek(), ...fields }
      return
    }
    const { selection, session, surface } = this.#edits
    const document = session.document.peek()
    if (!document || !surface) return
    const { indices } = selection
    const change = (stroke: LayerStroke, index: number) =>
      withShape(stroke, fields, selection.attachedEnds(index))
    const { strokes } = document
    const changed = new Map(indices.map((index) => [index, change(strokes[index], index)]))
    const all = this.#edits.withCounterparts(changed, strokes, (other, _, index) => change(other, index))
    const names = Object.keys(fields) as (keyof LineShape)[]
    const key = this.#edits.keyOf(`shape-${names}`)
    session.edit(lineFieldsStep(names, indices.length), (old) => replaceStrokes(old, all), key)
  }

  /** Sets the group of the chosen lines, or of new lines. Adds an area with this name if there is none. */
  setGroup(group: string): void {
    if (this.isNew.peek()) {
      this.group.value = group
      return
    }
    const { selection, session, surface } = this.#edits
    const { strokes = [] } = session.document.peek() ?? {}
    const others = selection.indices.filter((index) => strokes[index].group !== group)
    if (!surface || others.length === 0 || group === '') return
    const changed = new Map(others.map((index) => [index, { ...strokes[index], group }]))
    const other = otherSide(group)
    const all = this.#edits.withCounterparts(changed, strokes, (stroke) => ({ ...stroke, group: other }))
    session.edit(lineFieldsStep(['group'], others.length), (old) =>
      [...all.values()].reduce(
        (next, stroke) => coverLine(next, stroke, surface.canvas),
        replaceStrokes(old, all),
      ),
    )
  }

  /** Sets the layer of the chosen lines, or of new lines. */
  setLayer(layer: string): void {
    if (this.isNew.peek()) {
      this.layer.value = layer
      return
    }
    const { selection, session } = this.#edits
    const { indices } = selection
    session.edit(lineFieldsStep(['layer'], indices.length), (document) =>
      replaceStrokes(
        document,
        new Map(indices.map((index) => [index, { ...document.strokes[index], layer }])),
      ),
    )
  }
}
