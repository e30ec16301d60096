import { computed, type ReadonlySignal, signal } from '@preact/signals'
import type { Project } from '../keep/project.ts'
import { type ProjectEntry, ProjectStore } from '../keep/project-store.ts'
import type { OpenedAvatar } from '../open/avatar.ts'
import { Keeper, type KeepState } from './keeper.ts'
import type { Session } from './session.ts'

/** Saves the work in the browser. A project is created at the first change, and saved after every change. */
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

  /** Recent projects, latest first. */
  get projects(): ReadonlySignal<readonly ProjectEntry[]> {
    return this.#projects
  }

  /** Current project, or null before the first change. */
  readonly kept: ReadonlySignal<Project | null> = computed(() => this.#keeper.value?.kept.value ?? null)

  /** Null while there is nothing to save. */
  readonly state: ReadonlySignal<KeepState | null> = computed(() => this.#keeper.value?.state.value ?? null)

  /**
   * Opens a listed project; call `follow` once its document is in the session. Rejects with a FurrowError if that fails.
   *
   * @param take takes the project over from another tab.
   */
  async open(id: string, take = false): Promise<Project> {
    await this.leave()
    return this.#store.open(id, take)
  }

  /** Saves the session's document from now on: to `project`, or to a new one if null. */
  follow(avatar: OpenedAvatar, project: Project | null): void {
    this.#keeper.value = new Keeper(this.#store, this.#session, avatar, project, () => void this.#list())
  }

  /** Saves pending changes and releases the project for other tabs. */
  leave(): Promise<void> {
    const keeper = this.#keeper.peek()
    this.#keeper.value = null
    // Close before awaiting: the session moves on to another document.
    const closed = keeper?.close()
    this.#leaving = this.#leaving.then(() => closed).then(() => this.#list())
    return this.#leaving
  }

  /** Returns the project, creating it if necessary. Rejects with a FurrowError if that fails. */
  async project(): Promise<Project | undefined> {
    return this.#keeper.peek()?.project()
  }

  /** Continues in a new project. Rejects with a FurrowError if that fails. */
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
