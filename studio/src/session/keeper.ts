import { computed, effect, type ReadonlySignal, signal } from '@preact/signals'
import type { StudioDocument } from '../document/document.ts'
import { AutoSave, type SaveState } from '../keep/autosave.ts'
import type { Project } from '../keep/project.ts'
import type { ProjectStore } from '../keep/project-store.ts'
import type { OpenedAvatar } from '../open/avatar.ts'
import type { Session } from './session.ts'

/**
 * State of saving. `elsewhere` means that another tab has the project open and saves it, `newer` that another tab has saved it and then closed it.
 * This tab does not save in these states.
 */
export type KeepState = SaveState | { readonly kind: 'elsewhere' | 'newer' }

/** Saves the document of one avatar to its project. Creates a project at the first change if there is none. */
export class Keeper {
  readonly #store: ProjectStore
  readonly #avatar: OpenedAvatar
  readonly #document: ReadonlySignal<StudioDocument | null>
  readonly #autosave = signal<AutoSave | null>(null)
  readonly #blocked = signal<'elsewhere' | 'newer' | null>(null)
  /** Ends the wait for the other tab. */
  #waiting = new AbortController()
  readonly #onCreate: () => void
  readonly #stopWatching: () => void
  readonly #kept = signal<Project | null>(null)

  /**
   * @param project existing project, or null.
   * @param onCreate called when a project is created.
   */
  constructor(
    store: ProjectStore,
    session: Session,
    avatar: OpenedAvatar,
    project: Project | null,
    onCreate: () => void,
  ) {
    this.#store = store
    this.#avatar = avatar
    this.#document = session.document
    this.#onCreate = onCreate
    if (project) this.#follow(project)
    this.#stopWatching = effect(() => {
      // A dropped file is lost with the page, so it is kept before the first change.
      const isWorth = session.undoLabel.value !== undefined || avatar.address === undefined
      if (isWorth && session.document.value && !this.#kept.peek()) this.#save(null)
    })
  }

  /** State of saving, or null while there is nothing to save. */
  readonly state: ReadonlySignal<KeepState | null> = computed(() =>
    this.#blocked.value ? { kind: this.#blocked.value } : (this.#autosave.value?.state.value ?? null),
  )

  /** Project, or null before the first change. */
  get kept(): ReadonlySignal<Project | null> {
    return this.#kept
  }

  /** Returns the project, creating it if necessary. Rejects with a FurrowError if that fails. */
  async project(): Promise<Project> {
    if (!this.#kept.peek()) {
      this.#save(null)
      await this.#autosave.peek()?.flush()
    }
    const project = this.#kept.peek()
    if (project) return project
    const state = this.#autosave.peek()?.state.peek()
    throw state?.kind === 'failed' ? state.reason : new Error('there is nothing to save')
  }

  /** Continues in a copy of the project. Rejects with a FurrowError if that fails. */
  async copy(): Promise<void> {
    const document = this.#document.peek()
    if (!document) return
    const copy = await this.#create(document)
    this.#waiting.abort()
    await this.#kept.peek()?.close()
    this.#blocked.value = null
    this.#follow(copy)
    this.#onCreate()
  }

  /** Saves pending changes and releases the project for other tabs. */
  async close(): Promise<void> {
    this.#stopWatching()
    this.#waiting.abort()
    await this.#autosave.peek()?.dispose()
    this.#autosave.value = null
    await this.#kept.peek()?.close()
  }

  #follow(project: Project): void {
    this.#kept.value = project
    if (project.isReadOnly) {
      void this.#wait(project)
      return
    }
    this.#own(project, project.opened)
  }

  /** Saves a project from now on, until another tab requests it. @param saved document that it already contains, or null. */
  #own(project: Project, saved: StudioDocument | null): void {
    this.#save(saved)
    project.onRequested(() => void this.#handOver(project))
  }

  /** Waits until the other tab closes the project, and then saves it again, unless the other tab has changed it. */
  async #wait(project: Project): Promise<void> {
    this.#blocked.value = 'elsewhere'
    this.#waiting.abort()
    this.#waiting = new AbortController()
    const { signal } = this.#waiting
    const isNewer = await project.reclaim(signal)
    if (signal.aborted) {
      if (!project.isReadOnly) await project.close()
      return
    }
    this.#blocked.value = isNewer ? 'newer' : null
    if (!isNewer) this.#own(project, null)
  }

  /** Saves the project and hands it over to another tab. */
  async #handOver(project: Project): Promise<void> {
    this.#blocked.value = 'elsewhere'
    const autosave = this.#autosave.peek()
    this.#autosave.value = null
    await autosave?.dispose()
    await project.close()
    await this.#wait(project)
  }

  /** Saves each change from now on. @param saved document that the project already contains, or null. */
  #save(saved: StudioDocument | null): void {
    if (this.#autosave.peek() || !this.#document.peek()) return
    const document = this.#document as ReadonlySignal<StudioDocument>
    this.#autosave.value = new AutoSave(document, (next) => this.#write(next), undefined, saved)
  }

  async #write(document: StudioDocument): Promise<void> {
    const known = this.#kept.peek()
    if (known) return known.save(document)
    const project = await this.#create(document)
    this.#kept.value = project
    project.onRequested(() => void this.#handOver(project))
    this.#onCreate()
  }

  #create(document: StudioDocument): Promise<Project> {
    const { name, files } = this.#avatar
    return this.#store.create(name, files, document)
  }
}
