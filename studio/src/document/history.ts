import type { StudioDocument } from './document.ts'

/** Steps that are kept however many bytes they hold, and bytes up to which more are kept. */
const LEAST_STEPS = 200
const MOST_STEPS = 2000
const BYTES = 64 * 2 ** 20

interface Step {
  /** What was done, for the tooltip of undo. */
  label: string
  before: StudioDocument
  after: StudioDocument
  /** Changes with the same key in a row are one step, as those of a slider that is dragged. */
  key?: string | undefined
}

/**
 * The present document, and the steps that led to it. Old documents are kept as they are: they hold what was changed, and nothing twice, since
 * documents have in common what a step left alone.
 */
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

  /** What undo and redo would do; undefined where there is nothing. */
  get undoLabel(): string | undefined {
    return this.#done.at(-1)?.label
  }

  get redoLabel(): string | undefined {
    return this.#undone.at(-1)?.label
  }

  /**
   * Moves on to another document.
   *
   * @param key merges this step with the last one of the same key, until `settle` is called.
   */
  push(label: string, after: StudioDocument, key?: string): void {
    if (after === this.#document) return
    const last = this.#done.at(-1)
    if (key !== undefined && last?.key === key) last.after = after
    else this.#done.push({ label, before: this.#document, after, key })
    this.#undone = []
    this.#document = after
    this.#trim()
  }

  /** Ends a series of changes that are one step: the next one is a step of its own. */
  settle(): void {
    const last = this.#done.at(-1)
    if (last) last.key = undefined
  }

  undo(): void {
    const step = this.#done.pop()
    if (!step) return
    this.#undone.push({ ...step, key: undefined })
    this.#document = step.before
  }

  redo(): void {
    const step = this.#undone.pop()
    if (!step) return
    this.#done.push(step)
    this.#document = step.after
  }

  #trim(): void {
    while (this.#done.length > MOST_STEPS) this.#done.shift()
    if (this.#done.length <= LEAST_STEPS) return
    // From the latest step on: those that would take too much are forgotten.
    const seen = new Set<object>()
    let bytes = 0
    let kept = 0
    for (const { before } of this.#done.toReversed()) {
      bytes += newBytes(before, seen)
      if (bytes > BYTES && kept >= LEAST_STEPS) break
      kept++
    }
    this.#done = this.#done.slice(-kept)
  }
}

/** Bytes of the images of a document that were not seen before, and about those of its strokes. */
function newBytes({ areas, layers, strokes }: StudioDocument, seen: Set<object>): number {
  const isNew = (item: object) => !seen.has(item) && seen.add(item)
  const weights = areas.map((area) => area.weights).filter(isNew)
  const images = layers.flatMap(({ maps }) => Object.values(maps)).filter(isNew)
  const lines = strokes.filter(isNew)
  return (
    weights.reduce((sum, { data }) => sum + data.length, 0) +
    images.reduce((sum, { bytes }) => sum + bytes.length, 0) +
    lines.reduce((sum, { points }) => sum + 64 * points.length, 0)
  )
}
