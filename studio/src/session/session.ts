import { computed, type ReadonlySignal, signal } from '@preact/signals'
import type { StudioDocument } from '../document/document.ts'
import { History } from '../document/history.ts'

/** The document that is worked on, and how it changes. Views read the signals; only operations make another document. */
export class Session {
  readonly #history = signal<{ history: History | null; version: number }>({ history: null, version: 0 })

  /** Null before a face is open. */
  readonly document: ReadonlySignal<StudioDocument | null> = computed(
    () => this.#history.value.history?.document ?? null,
  )
  /** What undo and redo would do; undefined where there is nothing. */
  readonly undoLabel = computed(() => this.#history.value.history?.undoLabel)
  readonly redoLabel = computed(() => this.#history.value.history?.redoLabel)

  /** Begins with a document, without steps to undo; null where nothing is open. */
  open(document: StudioDocument | null): void {
    this.#history.value = { history: document && new History(document), version: 0 }
  }

  /**
   * Changes the document by an operation.
   *
   * @param label what it does, for undo.
   * @param key merges it with the last operation of the same key, until `settle`.
   * @throws what the operation throws; the document then stays as it is.
   */
  edit(label: string, operation: (document: StudioDocument) => StudioDocument, key?: string): void {
    const { history } = this.#history.peek()
    if (!history) return
    history.push(label, operation(history.document), key)
    this.#changed()
  }

  /** Ends a series of operations with one key: a slider was let go. */
  settle(): void {
    this.#history.peek().history?.settle()
  }

  undo(): void {
    this.#history.peek().history?.undo()
    this.#changed()
  }

  redo(): void {
    this.#history.peek().history?.redo()
    this.#changed()
  }

  #changed(): void {
    const { history, version } = this.#history.peek()
    this.#history.value = { history, version: version + 1 }
  }
}
