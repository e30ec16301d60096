import type { StudioDocument } from './document.ts'

/** The last `MIN_STEPS` steps are always kept. Up to `MAX_STEPS` are kept if all of them together need at most `MAX_BYTES`. */
const MIN_STEPS = 200
const MAX_STEPS = 2000
const MAX_BYTES = 64 * 2 ** 20

interface Step {
  /** Action name, shown in the undo tooltip. */
  label: string
  before: StudioDocument
  after: StudioDocument
  /** Memory that this step needs, bytes; see `lostBytes`. */
  bytes: number
  /** Consecutive changes with the same key become one step. */
  key?: string | undefined
}

/** Current document with undo and redo. Each step contains complete documents, which share their unchanged parts. */
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

  get undoLabel(): string | undefined {
    return this.#done.at(-1)?.label
  }

  get redoLabel(): string | undefined {
    return this.#undone.at(-1)?.label
  }

  /**
   * Adds a step.
   *
   * @param key consecutive steps with the same key become one step, until `settle` is called.
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

/** Returns the size in bytes of the images, strokes and takes that are in `before` but not in `after`. Estimates the size of strokes. */
function lostBytes(before: StudioDocument, after: StudioDocument): number {
  const [old, next] = [partsOf(before), partsOf(after)]
  const isLost = (part: object) => !next.has(part)
  return [...old].reduce((sum, [part, bytes]) => sum + (isLost(part) ? bytes : 0), 0)
}

function partsOf({ areas, layers, strokes, takes = [] }: StudioDocument): Map<object, number> {
  const images = layers.flatMap(({ maps }) => Object.values(maps))
  const tiles = layers.flatMap(({ sculpted }) => [...(sculpted?.tiles.values() ?? [])])
  return new Map<object, number>([
    ...areas.map(({ weights }) => [weights, weights.data.length] as const),
    ...images.map((image) => [image, image.bytes.length] as const),
    ...takes.map(({ motion: { weights } }) => [weights, weights.byteLength] as const),
    ...tiles.map((tile) => [tile, tile.byteLength] as const),
    ...strokes.map((stroke) => [stroke, 64 * stroke.points.length] as const),
  ])
}
