import { computed, type ReadonlySignal, signal } from '@preact/signals'
import type { Project } from '../keep/project.ts'
import { type ProjectEntry, ProjectStore } from '../keep/project-store.ts'
import type { OpenedAvatar } from '../open/avatar.ts'
import { Keeper, type KeepState } from './keeper.ts'
import type { Session } from './session.ts'

/** Keeps the work in the browser: a project begins with the first change, and is saved whenever the document changes. */
export class Keeping {
  readonly #session: Session
  readonly #store = new ProjectStore()
  readonly #projects = signal<readonly ProjectEntry[]>([])
  readonly #keeper = signal<Keeper | null>(null)
  #leaving: Promise<void> = Promise.resolve()

  constructor(session: Session) {
    this.#session = session
    void this.#list()
  }

  /** What was worked on before, the latest first. */
  get projects(): ReadonlySignal<readonly ProjectEntry[]> {
    return this.#projects
  }

  /** The project that the work is kept in; null before the first change. */
  readonly kept: ReadonlySignal<Project | null> = computed(() => this.#keeper.value?.kept.value ?? null)

  /** Null while nothing is to be saved. */
  readonly state: ReadonlySignal<KeepState | null> = computed(() => this.#keeper.value?.state.value ?? null)

  /**
   * Opens a project of the list; `follow` watches its document once that is in the session. Rejects with a FurrowError where it cannot be.
   *
   * @param take takes it from the tab that has it.
   */
  async open(id: string, take = false): Promise<Project> {
    await this.leave()
    return this.#store.open(id, take)
  }

  /** From now on the session's document is that of this avatar, and is kept in the project; in a new one where there is none. */
  follow(avatar: OpenedAvatar, project: Project | null): void {
    this.#keeper.value = new Keeper(this.#store, this.#session, avatar, project, () => void this.#list())
  }

  /** Saves what is not saved yet, and lets other tabs open the project. */
  leave(): Promise<void> {
    const keeper = this.#keeper.peek()
    this.#keeper.value = null
    // At once: the session goes on to another document.
    const closed = keeper?.close()
    this.#leaving = this.#leaving.then(() => closed).then(() => this.#list())
    return this.#leaving
  }

  /** The project that the work is kept in, begun where there is none yet. Rejects with a FurrowError where it cannot be. */
  async project(): Promise<Project | undefined> {
    return this.#keeper.peek()?.project()
  }

  /** Goes on in a new project. Rejects with a FurrowError where it cannot be. */
  async copy(): Promise<void> {
    await this.#keeper.peek()?.copy()
  }

  /** Deletes a project of the list. Rejects with a FurrowError where another tab has it. */
  async delete(id: string): Promise<void> {
    await this.#store.delete(id)
    await this.#list()
  }

  async #list(): Promise<void> {
    // Browsers without storage keep nothing, which is told when something is to be saved.
    this.#projects.value = await this.#store.list().catch(() => [])
  }
}
