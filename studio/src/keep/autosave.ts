import { effect, type ReadonlySignal, signal } from '@preact/signals'
import type { FurrowError } from 'furrow'
import type { StudioDocument } from '../document/document.ts'
import { storageError } from './storage-error.ts'

/** Milliseconds between the starts of two saves, and after a failure. */
const INTERVAL = 1000
const RETRY_INTERVAL = 5000

export type SaveState =
  | { readonly kind: 'saved' }
  /** Something is not saved yet, and will be at once. */
  | { readonly kind: 'saving' }
  /** The work goes on in memory; saving is tried again. */
  | { readonly kind: 'failed'; readonly reason: FurrowError }

/** The page, as far as it tells that it may be closed. */
type Page = Pick<Document, 'visibilityState' | 'addEventListener' | 'removeEventListener'>

/**
 * Saves a document whenever it changes: at once, but at most once a second, and never twice at a time. It also saves when the page is hidden,
 * which is the last that many browsers tell a page.
 */
export class AutoSave {
  readonly #state = signal<SaveState>({ kind: 'saved' })
  readonly #save: (document: StudioDocument) => Promise<void>
  readonly #page: Page
  readonly #stopWatching: () => void
  /** The last one that was seen: the signal may go on to another face's before all is saved. */
  #latest: StudioDocument
  #saved: StudioDocument | null
  #running: Promise<void> | undefined
  #timer: ReturnType<typeof setTimeout> | undefined
  #nextStart = 0
  #isDisposed = false

  /**
   * @param save stores a document.
   * @param saved what is stored already; null where nothing is.
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

  /** Saves what is not saved yet, now. Resolves when it is saved or has failed, see `state`. */
  async flush(): Promise<void> {
    // What runs may have begun before the last change.
    while (this.#running) await this.#running
    if (this.#isDirty()) await this.#run()
  }

  /** Stops watching, at once, and saves what is not saved yet. */
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
    // What is being saved may be older than the last change, which is then saved right after it.
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

  /** Saves now: what `#save` does before it waits has been done when this returns. */
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
