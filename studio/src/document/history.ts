import type { StudioDocument } from './document.ts'

/** Number of steps kept regardless of size, maximum number of steps, and bytes allowed for the additional ones. */
const MIN_STEPS = 200
const MAX_STEPS = 2000
const MAX_BYTES = 64 * 2 ** 20

interface Step {
  /** Action name, shown in the undo tooltip. */
  label: string
  before: StudioDocument
  after: StudioDocument
  /** Bytes that this step keeps in memory; see `lostBytes`. */
  bytes: number
  /** Consecutive changes with the same key are one step, for example while a slider is dragged. */
  key?: string | undefined
}

/** The current document with undo and redo. Documents share unchanged parts, so old ones are kept as they are. */
export class History {
  #document: StudioDocument
  #done: Step[] = []
  #undone: Step[] = []

  constructor(document: StudioDocument) {
    this.#document = document
  }

  get document(): StudioDocument {
    return this.#document
  }

  /** Label of the next undo step, if any. */
  get undoLabel(): string | undefined {
    return this.#done.at(-1)?.label
  }

  get redoLabel(): string | undefined {
    return this.#undone.at(-1)?.label
  }

  /**
   * Adds a step.
   *
   * @param key merges this step with the last one of the same key, until `settle` is called.
   */
  push(label: string, after: StudioDocument, key?: string): void {
    if (after === this.#document) return
    const last = this.#done.at(-1)
    const isMerged = key !== undefined && last?.key === key
    if (isMerged) this.#done.pop()
    const before = isMerged ? last.before : this.#document
    const step = { label, before, after, key, bytes: lostBytes(before, after) }
    this.#done.push(isMerged ? { ...step, label: last.label } : step)
    this.#undone = []
    this.#document = after
    this.#trim()
  }

  /** Ends a series of merged changes. */
  settle(): void {
    const last = this.#done.at(-1)
    if (last) last.key = undefined
  }

  undo(): void {
    const step = this.#done.pop()
    if (!step) return
    this.#undone.push({ ...step, key: undefined })
    this.#document = step.before
    this.settle()
  }

  redo(): void {
    const step = this.#undone.pop()
    if (!step) return
    this.#done.push(step)
    this.#document = step.after
  }

  #trim(): void {
    let bytes = this.#done.reduce((sum, step) => sum + step.bytes, 0)
    while (this.#done.length > MAX_STEPS || (this.#done.length > MIN_STEPS && bytes > MAX_BYTES)) {
      bytes -= this.#done.shift()!.bytes
    }
  }
}

/** Bytes of the images in `before` that `after` does not share, plus an estimate for strokes. */
function lostBytes(before: StudioDocument, after: StudioDocument): number {
  const [old, next] = [partsOf(before), partsOf(after)]
  const isLost = (part: object) => !next.has(part)
  return [...old].reduce((sum, [part, bytes]) => sum + (isLost(part) ? bytes : 0), 0)
}

function partsOf({ areas, layers, strokes }: StudioDocument): Map<object, number> {
  const images = layers.flatMap(({ maps }) => Object.values(maps))
  return new Map<object, number>([
    ...areas.map(({ weights }) => [weights, weights.data.length] as const),
    ...images.map((image) => [image, image.bytes.length] as const),
    ...strokes.map((stroke) => [stroke, 64 * stroke.points.length] as const),
  ])
}
