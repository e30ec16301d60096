import { computed, type ReadonlySignal, signal } from '@preact/signals'
import type { StudioDocument } from '../document/document.ts'
import { History } from '../document/history.ts'

/** Current document and its history. Views read the signals; only operations change the document. */
export class Session {
  readonly #history = signal<{ history: History | null; version: number }>({ history: null, version: 0 })

  /** Null before a face is open. */
  readonly document: ReadonlySignal<StudioDocument | null> = computed(
    () => this.#history.value.history?.document ?? null,
  )
  readonly undoLabel = computed(() => this.#history.value.history?.undoLabel)
  readonly redoLabel = computed(() => this.#history.value.history?.redoLabel)

  /** Replaces the document and clears the history. */
  open(document: StudioDocument | null): void {
    this.#history.value = { history: document && new History(document), version: 0 }
  }

  /**
   * Applies an operation to the document.
   *
   * @param label action name, shown by undo.
   * @param key consecutive steps with the same key become one step, until `settle` is called.
   * @throws any error of the operation. The document then does not change.
   */
  edit(label: string, operation: (document: StudioDocument) => StudioDocument, key?: string): void {
    const { history } = this.#history.peek()
    if (!history) return
    history.push(label, operation(history.document), key)
    this.#changed()
  }

  /** Ends a series of merged operations, for example when a slider is released. */
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
