import { FurrowError } from 'furrow'
import type { StudioDocument } from '../document/document.ts'
import type { AvatarFile } from '../files/folder-files.ts'
import { Database, MULTIPLE, type ProjectRecord, rangeOf, SINGLE } from './database.ts'
import { checkVersion, documentOf } from './document-record.ts'
import { openElsewhereError, Project } from './project.ts'
import { lockProject, takeLock } from './project-lock.ts'

export interface ProjectEntry {
  readonly id: string
  readonly name: string
  /** Time of the last save. Absent if the record is damaged. */
  readonly changed?: Date
  /** Total size of images and files, bytes. */
  readonly bytes: number
  readonly thumbnail?: Blob
  /** Reason why the project cannot be opened. */
  readonly problem?: string
}

export class ProjectStore {
  readonly #database: Database
  #askedToPersist = false

  constructor(name = 'furrow-studio') {
    this.#database = new Database(name)
  }

  /** Lists all projects, the last saved one first. Damaged projects have a `problem`. */
  async list(): Promise<ProjectEntry[]> {
    return this.#database.read(async (database) => {
      const transaction = database.transaction(['projects', 'saves', 'thumbnails'])
      const [projects, saves, thumbnails] = [
        transaction.objectStore('projects'),
        transaction.objectStore('saves'),
        transaction.objectStore('thumbnails'),
      ]
      const ids = await projects.getAllKeys()
      const entries = ids.map(async (id): Promise<ProjectEntry> => {
        const [record, save, thumbnail] = await Promise.all([
          projects.get(id),
          saves.get(id),
          thumbnails.get(id),
        ])
        const name = typeof record?.name === 'string' ? record.name : 'a damaged project'
        const problem = problemOf(record, name)
        return {
          id,
          name,
          bytes: save?.bytes ?? 0,
          ...(save?.changed instanceof Date && { changed: save.changed }),
          ...(thumbnail && { thumbnail }),
          ...(problem !== undefined && { problem }),
        }
      })
      const time = ({ changed }: ProjectEntry) => changed?.getTime() ?? 0
      return (await Promise.all(entries)).sort((a, b) => time(b) - time(a))
    })
  }

  /**
   * Creates and stores a project.
   *
   * @param files files of the avatar: the glTF or VRM file, followed by the files that it references.
   * @throws FurrowError if the browser cannot store it.
   */
  async create(name: string, files: readonly AvatarFile[], document: StudioDocument): Promise<Project> {
    this.#askToPersist()
    const id = crypto.randomUUID()
    const lock = await lockProject(id)
    const project = new Project(this.#database, { id, name, files }, { document }, lock)
    try {
      await project.save(document)
    } catch (error) {
      await project.close()
      throw error
    }
    return project
  }

  /**
   * Opens a project. It is read-only if another tab has it open.
   *
   * @param take whether to take the project from the other tab. That tab saves it first, unless it does not answer in time.
   * @throws FurrowError if the project is missing or damaged, or if a later version of the studio stored it.
   */
  async open(id: string, take = false): Promise<Project> {
    const lock = await (take ? takeLock(id) : lockProject(id))
    try {
      return await this.#database.read(async (database) => {
        const transaction = database.transaction(['projects', 'documents', 'images', 'files', 'saves'])
        const [project, record, numbers, images, files, save] = await Promise.all([
          transaction.objectStore('projects').get(id),
          transaction.objectStore('documents').get(id),
          transaction.objectStore('images').getAllKeys(rangeOf(id)),
          transaction.objectStore('images').getAll(rangeOf(id)),
          transaction.objectStore('files').getAll(rangeOf(id)),
          transaction.objectStore('saves').get(id),
        ])
        const name = nameOf(project)
        const byNumber = new Map(numbers.map(([, number], i) => [number, images[i]]))
        const document = documentOf(record, byNumber, name)
        const stored = { images: new Map(numbers.map(([, number], i) => [images[i], number])), by: database }
        return new Project(
          this.#database,
          { id, name, files },
          { document, stored, saved: save?.changed },
          lock,
        )
      })
    } catch (error) {
      await lock?.release()
      throw error
    }
  }

  /** @throws FurrowError if the project is missing. */
  async rename(id: string, name: string): Promise<void> {
    const record = await this.#database.read((database) => database.get('projects', id))
    nameOf(record)
    await this.#database.write((table) => table('projects').put({ ...record!, name }, id))
  }

  /**
   * Copies a stored project.
   *
   * @returns id of the copy.
   * @throws FurrowError if the project is missing, or if there is not enough space.
   */
  async duplicate(id: string, name: string): Promise<string> {
    const project = await this.open(id)
    try {
      const copy = await this.create(name, project.files, project.opened)
      const thumbnail = await this.#database.read((database) => database.get('thumbnails', id))
      if (thumbnail) await copy.setThumbnail(thumbnail)
      await copy.close()
      return copy.id
    } finally {
      await project.close()
    }
  }

  /** @throws FurrowError if a tab has the project open. */
  async delete(id: string): Promise<void> {
    const lock = await lockProject(id)
    if (!lock) throw openElsewhereError('the project', 'close it there first')
    try {
      await this.#database.write((table) => {
        for (const name of SINGLE) table(name).delete(id)
        for (const name of MULTIPLE) table(name).delete(rangeOf(id))
      })
    } finally {
      await lock.release()
    }
  }

  /** Closes the connection. The next call reopens it. */
  close(): void {
    this.#database.close()
  }

  /** Asks the browser to keep the projects when the disk is full. Some browsers ask the user. */
  #askToPersist(): void {
    if (this.#askedToPersist) return
    this.#askedToPersist = true
    // Ignore errors and missing support, because the projects are stored anyway.
    navigator.storage?.persist?.().catch(() => {})
  }
}

function nameOf(record: ProjectRecord | undefined): string {
  if (!record) {
    const remedy = 'choose a project from the list'
    throw new FurrowError({ code: 'unknown-name', who: 'Studio', problem: 'the project is gone', remedy })
  }
  checkVersion(record.version, record.name)
  return record.name
}

function problemOf(record: ProjectRecord | undefined, name: string): string | undefined {
  if (typeof record?.name !== 'string') return 'its record is damaged'
  try {
    checkVersion(record.version, name)
    return undefined
  } catch (error) {
    return (error as FurrowError).message
  }
}
