import { type DBSchema, type IDBPDatabase, type IDBPTransaction, openDB, type StoreNames, unwrap } from 'idb'
import type { AvatarFile } from '../files/folder-files.ts'
import type { DocumentRecord, ImageRecord } from './document-record.ts'
import { storageError } from './storage-error.ts'

/** Of the tables below. A record has a version of its own. */
const VERSION = 1

/** The tables of projects. Keys begin with the project's id, so that one project is one range of keys. */
export interface Tables extends DBSchema {
  projects: { key: string; value: ProjectRecord }
  /** What a save writes besides the document. */
  saves: { key: string; value: SaveRecord }
  documents: { key: string; value: DocumentRecord }
  images: { key: [project: string, image: number]; value: ImageRecord }
  /** The avatar's files as they were dropped, the first of which is the face. */
  files: { key: [project: string, index: number]; value: AvatarFile }
  thumbnails: { key: string; value: Blob }
  /** The folder on disk that a project is written to. */
  folders: { key: string; value: FileSystemDirectoryHandle }
}

export interface ProjectRecord {
  version: 1
  name: string
  created: Date
}

export interface SaveRecord {
  changed: Date
  /** Of images, files and document. */
  bytes: number
}

type Table = StoreNames<Tables>
/** Gives a table for writing. Requests of a transaction fail with it as a whole, so that none is waited for. */
export type WritableTable = (name: Table) => IDBObjectStore

/** Tables with one record per project, and those with several. */
export const SINGLE = ['projects', 'saves', 'documents', 'thumbnails', 'folders'] as const satisfies Table[]
export const SEVERAL = ['images', 'files'] as const satisfies Table[]

/** The keys of one project in a table with several records of it. */
export function rangeOf(project: string): IDBKeyRange {
  // Arrays sort after numbers.
  return IDBKeyRange.bound([project], [project, []])
}

/** The connection to the browser's database, opened anew where the browser closed it. */
export class Database {
  readonly #name: string
  #opened: IDBPDatabase<Tables> | undefined
  #opening: Promise<IDBPDatabase<Tables>> | undefined

  constructor(name: string) {
    this.#name = name
  }

  /** The open connection; undefined where there is none at the moment. */
  get opened(): IDBPDatabase<Tables> | undefined {
    return this.#opened
  }

  /** @throws FurrowError where the browser does not allow it. */
  async open(): Promise<IDBPDatabase<Tables>> {
    if (this.#opened) return this.#opened
    this.#opening ??= this.#open().finally(() => {
      this.#opening = undefined
    })
    return this.#opening
  }

  /** Reads from the database. Throws FurrowError where that fails. */
  async read<T>(work: (database: IDBPDatabase<Tables>) => Promise<T>): Promise<T> {
    try {
      return await work(await this.open())
    } catch (error) {
      throw this.#failed(error)
    }
  }

  /**
   * Writes in one transaction: all of it or, where any part fails, nothing. Where the database is open, everything is handed to the browser
   * before this returns, so that a page which is being closed still writes.
   *
   * @param work starts requests, and does not wait.
   * @throws FurrowError where it fails.
   */
  async write(work: (table: WritableTable) => void): Promise<void> {
    let transaction: IDBPTransaction<Tables, Table[], 'readwrite'> | undefined
    try {
      const database = this.#opened ?? (await this.open())
      transaction = database.transaction([...SINGLE, ...SEVERAL], 'readwrite', { durability: 'strict' })
      const { done } = transaction
      const tables = unwrap(transaction)
      work((name) => tables.objectStore(name))
      transaction.commit()
      await done
    } catch (error) {
      if (transaction) abort(transaction)
      throw this.#failed(error)
    }
  }

  close(): void {
    this.#opened?.close()
    this.#opened = undefined
  }

  async #open(): Promise<IDBPDatabase<Tables>> {
    try {
      // Some browsers have none in private windows.
      if (globalThis.indexedDB === undefined) throw new DOMException('', 'SecurityError')
      const database = await openDB<Tables>(this.#name, VERSION, {
        upgrade: (created) => {
          for (const table of [...SINGLE, ...SEVERAL]) created.createObjectStore(table)
        },
        blocking: () => this.close(),
        terminated: () => this.close(),
      })
      this.#opened = database
      return database
    } catch (error) {
      // Firefox, where a private window has no storage.
      const isPrivate = error instanceof DOMException && error.name === 'InvalidStateError'
      throw storageError(isPrivate ? new DOMException(error.message, 'SecurityError') : error)
    }
  }

  #failed(error: unknown): unknown {
    // A connection that the browser closed: the next attempt opens another.
    if (error instanceof DOMException && error.name === 'InvalidStateError') this.close()
    return storageError(error)
  }
}

function abort(transaction: IDBPTransaction<Tables, Table[], 'readwrite'>): void {
  transaction.done.catch(() => {})
  try {
    transaction.abort()
  } catch {
    // It has ended already.
  }
}
