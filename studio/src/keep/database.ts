import { type DBSchema, type IDBPDatabase, type IDBPTransaction, openDB, type StoreNames, unwrap } from 'idb'
import type { AvatarFile } from '../files/folder-files.ts'
import type { DocumentRecord, ImageRecord } from './document-record.ts'
import { storageError } from './storage-error.ts'

/** Version of the set of tables. */
const VERSION = 1

/** Tables of the database. Keys are, or begin with, the id of a project. */
export interface Tables extends DBSchema {
  projects: { key: string; value: ProjectRecord }
  /** Time and size of the last save. */
  saves: { key: string; value: SaveRecord }
  documents: { key: string; value: DocumentRecord }
  images: { key: [project: string, image: number]; value: ImageRecord }
  /** Original files of the avatar: the glTF or VRM file, followed by the files that it references. */
  files: { key: [project: string, index: number]; value: AvatarFile }
  thumbnails: { key: string; value: Blob }
  /** Folder on disk to which the user saved the project. */
  folders: { key: string; value: FileSystemDirectoryHandle }
}

export interface ProjectRecord {
  version: 1
  name: string
  created: Date
}

export interface SaveRecord {
  changed: Date
  /** Total size of images and files, bytes. */
  bytes: number
}

type Table = StoreNames<Tables>
/** Function that returns a table for writing. A failed request aborts the transaction, so requests need not be awaited. */
export type WritableTable = (name: Table) => IDBObjectStore

/** Tables with one record per project (`SINGLE`), and with any number of records (`MULTIPLE`). */
export const SINGLE = ['projects', 'saves', 'documents', 'thumbnails', 'folders'] as const satisfies Table[]
export const MULTIPLE = ['images', 'files'] as const satisfies Table[]

export function rangeOf(project: string): IDBKeyRange {
  // IndexedDB sorts arrays after numbers, so `[]` is above all numbers.
  return IDBKeyRange.bound([project], [project, []])
}

/** Connection to a database in the browser. If the browser closes the connection, the next call opens a new one. */
export class Database {
  readonly #name: string
  #opened: IDBPDatabase<Tables> | undefined
  #opening: Promise<IDBPDatabase<Tables>> | undefined

  constructor(name: string) {
    this.#name = name
  }

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
   * Writes everything or nothing, in one transaction. If the database is open, makes all requests synchronously, so that a page can still
   * write while it closes.
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
      // Firefox throws an InvalidStateError in private windows.
      const isPrivate = error instanceof DOMException && error.name === 'InvalidStateError'
      throw storageError(isPrivate ? new DOMException(error.message, 'SecurityError') : error)
    }
  }

  #failed(error: unknown): unknown {
    // The browser has closed the connection. Forget it, so that the next call opens another one.
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
