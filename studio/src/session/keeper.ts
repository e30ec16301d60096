import { computed, effect, type ReadonlySignal, signal } from '@preact/signals'
import type { StudioDocument } from '../document/document.ts'
import { AutoSave, type SaveState } from '../keep/autosave.ts'
import type { Project } from '../keep/project.ts'
import type { ProjectStore } from '../keep/project-store.ts'
import type { OpenedAvatar } from '../open/avatar.ts'
import type { Session } from './session.ts'

/** Whether the work is saved; `elsewhere` where another tab has the project, and alone saves it. */
export type KeepState = SaveState | { readonly kind: 'elsewhere' }

/** Keeps the document of one avatar in a project: in one that was opened, or in a new one from the first change on. */
export class Keeper {
  readonly #store: ProjectStore
  readonly #avatar: OpenedAvatar
  readonly #document: ReadonlySignal<StudioDocument | null>
  readonly #autosave = signal<AutoSave | null>(null)
  readonly #isElsewhere = signal(false)
  readonly #onCreate: () => void
  readonly #stopWatching: () => void
  readonly #kept = signal<Project | null>(null)

  /**
   * @param project null where nothing is kept yet.
   * @param onCreate called when a project is begun.
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
      if (session.undoLabel.value !== undefined && !this.#kept.peek()) this.#save(null)
    })
  }

  /** Null while nothing is to be saved. */
  readonly state: ReadonlySignal<KeepState | null> = computed(() =>
    this.#isElsewhere.value ? { kind: 'elsewhere' } : (this.#autosave.value?.state.value ?? null),
  )

  /** The project; null before the first change. */
  get kept(): ReadonlySignal<Project | null> {
    return this.#kept
  }

  /** The project, which is begun where there is none yet. Rejects with a FurrowError where it cannot be. */
  async project(): Promise<Project> {
    if (!this.#kept.peek()) {
      this.#save(null)
      await this.#autosave.peek()?.flush()
    }
    const project = this.#kept.peek()
    if (project) return project
    const state = this.#autosave.peek()?.state.peek()
    throw state?.kind === 'failed' ? state.reason : new Error('there is nothing to keep')
  }

  /** From now on the work is kept in a new project. Rejects with a FurrowError where it cannot be. */
  async copy(): Promise<void> {
    const document = this.#document.peek()
    if (!document) return
    const copy = await this.#create(document)
    await this.#kept.peek()?.close()
    this.#isElsewhere.value = false
    this.#follow(copy)
    this.#onCreate()
  }

  /** Saves what is not saved yet, and lets other tabs open the project. */
  async close(): Promise<void> {
    this.#stopWatching()
    await this.#autosave.peek()?.dispose()
    this.#autosave.value = null
    await this.#kept.peek()?.close()
  }

  #follow(project: Project): void {
    this.#kept.value = project
    if (project.isReadOnly) {
      this.#isElsewhere.value = true
      return
    }
    this.#save(project.opened)
    project.whenWanted(() => void this.#handOver(project))
  }

  /** Another tab goes on with the project. */
  async #handOver(project: Project): Promise<void> {
    this.#isElsewhere.value = true
    const autosave = this.#autosave.peek()
    this.#autosave.value = null
    await autosave?.dispose()
    await project.close()
  }

  /** @param saved what the project has already. */
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
    project.whenWanted(() => void this.#handOver(project))
    this.#onCreate()
  }

  #create(document: StudioDocument): Promise<Project> {
    const { name, files } = this.#avatar
    return this.#store.create(name, files, document)
  }
}
