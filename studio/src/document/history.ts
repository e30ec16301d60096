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
  /** What this step keeps from being forgotten; see `lostBytes`. */
  bytes: number
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
    const isMerged = key !== undefined && last?.key === key
    if (isMerged) this.#done.pop()
    const before = isMerged ? last.before : this.#document
    const step = { label, before, after, key, bytes: lostBytes(before, after) }
    this.#done.push(isMerged ? { ...step, label: last.label } : step)
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
    while (this.#done.length > MOST_STEPS || (this.#done.length > LEAST_STEPS && bytes > BYTES)) {
      bytes -= this.#done.shift()!.bytes
    }
  }
}

/** Bytes of the images of a document that another does not have, and about those of its strokes. */
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
