import { computed, effect, type ReadonlySignal, signal } from '@preact/signals'
import type { StudioDocument } from '../document/document.ts'
import { AutoSave, type SaveState } from '../keep/autosave.ts'
import type { Project } from '../keep/project.ts'
import { type ProjectEntry, ProjectStore } from '../keep/project-store.ts'
import type { OpenedAvatar } from '../open/avatar.ts'
import type { Session } from './session.ts'

/** Keeps the work in the browser: a project begins with the first change, and is saved whenever the document changes. */
export class Keeping {
  readonly #session: Session
  readonly #store = new ProjectStore()
  readonly #projects = signal<readonly ProjectEntry[]>([])
  readonly #autosave = signal<AutoSave | null>(null)
  readonly #onError: (error: unknown) => void
  #project: Project | null = null
  #avatar: OpenedAvatar | null = null
  #isBeginning = false

  /** @param onError is told of what goes wrong while the page goes on. */
  constructor(session: Session, onError: (error: unknown) => void) {
    this.#session = session
    this.#onError = onError
    effect(() => {
      if (session.undoLabel.value !== undefined) void this.#begin()
    })
    void this.#list()
  }

  /** What was worked on before, the latest first. */
  get projects(): ReadonlySignal<readonly ProjectEntry[]> {
    return this.#projects
  }

  /** Null while nothing is to be saved. */
  readonly state: ReadonlySignal<SaveState | null> = computed(() => this.#autosave.value?.state.value ?? null)

  /** Opens a project of the list; `follow` watches its document once that is in the session. Rejects with a FurrowError where it cannot be. */
  async open(id: string): Promise<Project> {
    await this.leave()
    return this.#store.open(id)
  }

  /** From now on the session's document is that of this avatar, and is kept in the project; in a new one where there is none. */
  follow(avatar: OpenedAvatar, project: Project | null): void {
    this.#avatar = avatar
    this.#project = project
    if (project && !project.isReadOnly) this.#save(project)
  }

  /** Saves what is not saved yet, and lets other tabs open the project. */
  async leave(): Promise<void> {
    const [autosave, project] = [this.#autosave.peek(), this.#project]
    this.#autosave.value = null
    this.#project = null
    this.#avatar = null
    await autosave?.dispose()
    await project?.close()
    await this.#list()
  }

  /** Deletes a project of the list. Rejects with a FurrowError where another tab has it. */
  async delete(id: string): Promise<void> {
    await this.#store.delete(id)
    await this.#list()
  }

  async #begin(): Promise<void> {
    const document = this.#session.document.peek()
    const avatar = this.#avatar
    if (!document || !avatar || this.#project || this.#isBeginning) return
    this.#isBeginning = true
    try {
      const project = await this.#store.create(avatar.name, avatar.files, document)
      if (avatar !== this.#avatar) return void (await project.close())
      this.#project = project
      this.#save(project)
      await this.#list()
    } catch (error) {
      this.#onError(error)
    } finally {
      this.#isBeginning = false
    }
  }

  #save(project: Project): void {
    const document = this.#session.document as ReadonlySignal<StudioDocument>
    this.#autosave.value = new AutoSave(document, (next) => project.save(next))
  }

  async #list(): Promise<void> {
    // Browsers without storage keep nothing, which is told when something is to be saved.
    this.#projects.value = await this.#store.list().catch(() => [])
  }
}
