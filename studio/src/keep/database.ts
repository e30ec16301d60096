import { type DBSchema, type IDBPDatabase, type IDBPTransaction, openDB, type StoreNames, unwrap } from 'idb'
import type { AvatarFile } from '../files/folder-files.ts'
import type { DocumentRecord, ImageRecord } from './document-record.ts'
import { storageError } from './storage-error.ts'

/** Schema version of the tables. Records have their own version. */
const VERSION = 1

/** Tables of projects. Keys begin with the project's id, so that the records of a project form one key range. */
export interface Tables extends DBSchema {
  projects: { key: string; value: ProjectRecord }
  /** Data that each save writes beside the document. */
  saves: { key: string; value: SaveRecord }
  documents: { key: string; value: DocumentRecord }
  images: { key: [project: string, image: number]; value: ImageRecord }
  /** The avatar's original files; the first is the face. */
  files: { key: [project: string, index: number]; value: AvatarFile }
  thumbnails: { key: string; value: Blob }
  /** Folder on disk that contains the project. */
  folders: { key: string; value: FileSystemDirectoryHandle }
}

export interface ProjectRecord {
  version: 1
  name: string
  created: Date
}

export interface SaveRecord {
  changed: Date
  /** Size of images and files, bytes. */
  bytes: number
}

type Table = StoreNames<Tables>
/** Returns a table for writing. A failed request fails its transaction, so that requests need not be awaited. */
export type WritableTable = (name: Table) => IDBObjectStore

/** Tables with one record per project, and with several. */
export const SINGLE = ['projects', 'saves', 'documents', 'thumbnails', 'folders'] as const satisfies Table[]
export const MULTIPLE = ['images', 'files'] as const satisfies Table[]

/** Returns the key range of one project. */
export function rangeOf(project: string): IDBKeyRange {
  // Arrays sort after numbers.
  return IDBKeyRange.bound([project], [project, []])
}

/** Connection to the browser's database. Reopened after the browser closes it. */
export class Database {
  readonly #name: string
  #opened: IDBPDatabase<Tables> | undefined
  #opening: Promise<IDBPDatabase<Tables>> | undefined

  constructor(name: string) {
    this.#name = name
  }

  /** Open connection, if any. */
  get opened(): IDBPDatabase<Tables> | undefined {
    return this.#opened
  }

  /** @throws FurrowError if the browser denies access. */
  async open(): Promise<IDBPDatabase<Tables>> {
    if (this.#opened) return this.#opened
    this.#opening ??= this.#open().finally(() => {
      this.#opening = undefined
    })
    return this.#opening
  }

  /** Reads from the database. Throws FurrowError if that fails. */
  async read<T>(work: (database: IDBPDatabase<Tables>) => Promise<T>): Promise<T> {
    try {
      return await work(await this.open())
    } catch (error) {
      throw this.#failed(error)
    }
  }

  /**
   * Writes in one transaction: everything or nothing. If the database is open, all requests are made before this returns, so that a
   * closing page still writes.
   *
   * @param work starts requests without awaiting them.
   * @throws FurrowError if writing fails.
   */
  async write(work: (table: WritableTable) => void): Promise<void> {
    let transaction: IDBPTransaction<Tables, Table[], 'readwrite'> | undefined
    try {
      const database = this.#opened ?? (await this.open())
      transaction = database.transaction([...SINGLE, ...MULTIPLE], 'readwrite', { durability: 'strict' })
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
      // Some browsers have no IndexedDB in private windows.
      if (globalThis.indexedDB === undefined) throw new DOMException('', 'SecurityError')
      const database = await openDB<Tables>(this.#name, VERSION, {
        upgrade: (created) => {
          for (const table of [...SINGLE, ...MULTIPLE]) created.createObjectStore(table)
        },
        blocking: () => this.close(),
        terminated: () => this.close(),
      })
      this.#opened = database
      return database
    } catch (error) {
      // Firefox throws this in private windows.
      const isPrivate = error instanceof DOMException && error.name === 'InvalidStateError'
      throw storageError(isPrivate ? new DOMException(error.message, 'SecurityError') : error)
    }
  }

  #failed(error: unknown): unknown {
    // The browser closed the connection; the next attempt opens a new one.
    if (error instanceof DOMException && error.name === 'InvalidStateError') this.close()
    return storageError(error)
  }
}

function abort(transaction: IDBPTransaction<Tables, Table[], 'readwrite'>): void {
  transaction.done.catch(() => {})
  try {
    transaction.abort()
  } catch {
    // The transaction has already ended.
  }
}
