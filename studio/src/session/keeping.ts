import { computed, type ReadonlySignal, signal } from '@preact/signals'
import type { Project } from '../keep/project.ts'
import { type ProjectEntry, ProjectStore } from '../keep/project-store.ts'
import type { OpenedAvatar } from '../open/avatar.ts'
import { Keeper, type KeepState } from './keeper.ts'
import type { Session } from './session.ts'

/** Saves documents as projects in the browser. Creates a project at the first change, and saves it after every change. */
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

  /** Projects in the browser, the last saved one first. */
  get projects(): ReadonlySignal<readonly ProjectEntry[]> {
    return this.#projects
  }

  /** Current project, or null before the first change. */
  readonly kept: ReadonlySignal<Project | null> = computed(() => this.#keeper.value?.kept.value ?? null)

  /** State of saving, or null while there is nothing to save. */
  readonly state: ReadonlySignal<KeepState | null> = computed(() => this.#keeper.value?.state.value ?? null)

  /**
   * Opens a project. After setting its document in the session, call `follow`. Rejects with a FurrowError if the project cannot be opened.
   *
   * @param take whether to take the project from another tab that has it open.
   */
  async open(id: string, take = false): Promise<Project> {
    await this.leave()
    return this.#store.open(id, take)
  }

  /** Starts to save the session's document to `project`. If null, the first change creates a project. */
  follow(avatar: OpenedAvatar, project: Project | null): void {
    this.#keeper.value = new Keeper(this.#store, this.#session, avatar, project, () => void this.#list())
  }

  /** Saves pending changes and releases the project for other tabs. */
  leave(): Promise<void> {
    const keeper = this.#keeper.peek()
    this.#keeper.value = null
    // Close the keeper before any `await`. Otherwise, it could save the document that the session opens next.
    const closed = keeper?.close()
    this.#leaving = this.#leaving.then(() => closed).then(() => this.#list())
    return this.#leaving
  }

  /** Returns the project, creating it if necessary. Rejects with a FurrowError if that fails. */
  async project(): Promise<Project | undefined> {
    return this.#keeper.peek()?.project()
  }

  /** Continues in a copy of the project. Rejects with a FurrowError if that fails. */
  async copy(): Promise<void> {
    await this.#keeper.peek()?.copy()
  }

  /** Deletes a project. Rejects with a FurrowError if another tab has it open. */
  async delete(id: string): Promise<void> {
    await this.#store.delete(id)
    await this.#list()
  }

  async #list(): Promise<void> {
    // Without browser storage the list is empty; saving reports the error.
    this.#projects.value = await this.#store.list().catch(() => [])
  }
}
