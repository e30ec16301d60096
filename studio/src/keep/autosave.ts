import { effect, type ReadonlySignal, signal } from '@preact/signals'
import type { FurrowError } from 'furrow'
import type { StudioDocument } from '../document/document.ts'
import { storageError } from './storage-error.ts'

/** Minimum time between the starts of two saves, and time before a retry, milliseconds. */
const INTERVAL = 1000
const RETRY_INTERVAL = 5000

export type SaveState =
  | { readonly kind: 'saved' }
  /** A save is pending or running. */
  | { readonly kind: 'saving' }
  /** The last save failed. The document stays in memory, and saving is retried. */
  | { readonly kind: 'failed'; readonly reason: FurrowError }

/** Part of `Document` that tells when the page becomes hidden. */
type Page = Pick<Document, 'visibilityState' | 'addEventListener' | 'removeEventListener'>

/**
 * Saves a document after each change, at most once a second and one save at a time. Also saves when the page becomes hidden, because many
 * browsers send no later event before they close it.
 */
export class AutoSave {
  readonly #state = signal<SaveState>({ kind: 'saved' })
  readonly #save: (document: StudioDocument) => Promise<void>
  readonly #page: Page
  readonly #stopWatching: () => void
  /** Newest version of the document. When `dispose` saves, the constructor's signal may already contain another document. */
  #latest: StudioDocument
  #saved: StudioDocument | null
  #running: Promise<void> | undefined
  #timer: ReturnType<typeof setTimeout> | undefined
  #nextStart = 0
  #isDisposed = false

  /**
   * @param save stores a document.
   * @param saved document that is already stored, or null.
   */
  constructor(
    document: ReadonlySignal<StudioDocument>,
    save: (document: StudioDocument) => Promise<void>,
    page: Page = globalThis.document,
    saved: StudioDocument | null = document.peek(),
  ) {
    this.#save = save
    this.#page = page
    this.#latest = document.peek()
    this.#saved = saved
    this.#stopWatching = effect(() => this.#follow(document.value))
    page.addEventListener('visibilitychange', this.#onVisibility)
    globalThis.addEventListener?.('pagehide', this.#onPageHide)
  }

  get state(): ReadonlySignal<SaveState> {
    return this.#state
  }

  /** Saves pending changes now. Resolves when saving has succeeded or failed; see `state`. */
  async flush(): Promise<void> {
    // A running save may lack the last change.
    while (this.#running) await this.#running
    if (this.#isDirty()) await this.#run()
  }

  /** Stops watching immediately, and saves pending changes. */
  async dispose(): Promise<void> {
    this.#stopWatching()
    this.#page.removeEventListener('visibilitychange', this.#onVisibility)
    globalThis.removeEventListener?.('pagehide', this.#onPageHide)
    await this.flush()
    this.#isDisposed = true
    clearTimeout(this.#timer)
  }

  readonly #onVisibility = () => {
    if (this.#page.visibilityState === 'hidden') this.#onPageHide()
  }

  readonly #onPageHide = () => {
    // If a save is running, the next one starts right after it, without waiting for `INTERVAL`.
    this.#nextStart = 0
    if (!this.#running && this.#isDirty()) void this.#run()
  }

  #isDirty(): boolean {
    return this.#latest !== this.#saved
  }

  #follow(document: StudioDocument): void {
    this.#latest = document
    if (this.#running) return
    clearTimeout(this.#timer)
    if (document === this.#saved) this.#state.value = { kind: 'saved' }
    else {
      if (this.#state.peek().kind === 'saved') this.#state.value = { kind: 'saving' }
      this.#schedule()
    }
  }

  #schedule(): void {
    this.#timer = setTimeout(() => void this.#run(), Math.max(0, this.#nextStart - Date.now()))
  }

  /** Starts a save. The synchronous part of the callback `save` runs before `#run` returns. */
  #run(): Promise<void> {
    clearTimeout(this.#timer)
    const document = this.#latest
    this.#nextStart = Date.now() + INTERVAL
    this.#running = this.#save(document)
      .then(
        () => {
          this.#saved = document
          this.#state.value = { kind: this.#isDirty() ? 'saving' : 'saved' }
        },
        (error) => {
          this.#nextStart = Date.now() + RETRY_INTERVAL
          this.#state.value = { kind: 'failed', reason: storageError(error) }
        },
      )
      .then(() => {
        this.#running = undefined
        if (this.#isDirty() && !this.#isDisposed) this.#schedule()
      })
    return this.#running
  }
}
