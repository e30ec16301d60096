import { FurrowError } from 'furrow'
import type { StudioDocument } from '../document/document.ts'
import type { AvatarFile } from '../files/folder-files.ts'
import {
  type Database,
  type ProjectRecord,
  rangeOf,
  type SaveRecord,
  type WritableTable,
} from './database.ts'
import { type ImageRecord, imagesOf, recordOf } from './document-record.ts'
import type { ProjectLock } from './project-lock.ts'

/** Images with the numbers that they are stored under. */
type Numbers = ReadonlyMap<ImageRecord, number>

/** What the database has of a project. */
interface Stored {
  readonly images: Numbers
  /** The connection that wrote or read them: when there is another one, nothing is certain to be there. */
  readonly by: unknown
}

/** A project that is open in this tab. */
export class Project {
  readonly id: string
  /** The avatar's files; the first is the face. */
  readonly files: readonly AvatarFile[]
  /** The document as it was opened. */
  readonly opened: StudioDocument
  readonly #name: string
  readonly #database: Database
  readonly #lock: ProjectLock | undefined
  #stored: Stored | undefined

  /**
   * @param opened.stored absent where nothing is.
   * @param lock undefined where another tab has it.
   */
  constructor(
    database: Database,
    { id, name, files }: { id: string; name: string; files: readonly AvatarFile[] },
    { document, stored }: { document: StudioDocument; stored?: Stored },
    lock: ProjectLock | undefined,
  ) {
    this.id = id
    this.files = files
    this.opened = document
    this.#name = name
    this.#database = database
    this.#lock = lock
    this.#stored = stored
  }

  /**
   * Whether another tab has the project: it can be looked at, changed and exported here, but is saved by the other tab alone. Two tabs that
   * save in turn would each undo the other's work.
   */
  get isReadOnly(): boolean {
    return !this.#lock?.isHeld
  }

  /** Calls a function when another tab wants the project, which is to be closed then. */
  whenWanted(call: () => void): void {
    if (this.#lock) this.#lock.onWanted = call
  }

  /**
   * Stores the document: its images that are not stored yet, and what else there is; images that it no longer has are deleted. All of it or
   * nothing. One call must end before the next begins.
   *
   * @throws FurrowError where another tab has the project, or the browser cannot store it.
   */
  async save(document: StudioDocument): Promise<void> {
    if (this.isReadOnly) throw openElsewhere(this.#name, 'save a copy, or close this tab')
    // Where a connection was closed, the browser's data may have been cleared: everything is written again.
    const connection = this.#database.opened ?? (await this.#database.open())
    const stored = this.#stored?.by === connection ? this.#stored.images : undefined
    const images = numbered(imagesOf(document), stored ?? new Map())
    const record = stored ? undefined : await this.#record()
    await this.#database.write((table) => {
      if (record) this.#writeFiles(table, record)
      writeImages(table('images'), this.id, stored ?? new Map(), images)
      table('documents').put(
        recordOf(document, (image) => images.get(image)!),
        this.id,
      )
      const save: SaveRecord = { changed: new Date(), bytes: this.#bytesOf(document) }
      table('saves').put(save, this.id)
    })
    this.#stored = { images, by: connection }
  }

  /** Stores a small picture of the project for lists of projects. */
  async setThumbnail(thumbnail: Blob): Promise<void> {
    if (this.isReadOnly) return
    await this.#database.write((table) => table('thumbnails').put(thumbnail, this.id))
  }

  /** The folder on disk that the project was last written to. */
  async folder(): Promise<FileSystemDirectoryHandle | undefined> {
    return this.#database.read((database) => database.get('folders', this.id))
  }

  async setFolder(folder: FileSystemDirectoryHandle): Promise<void> {
    await this.#database.write((table) => table('folders').put(folder, this.id))
  }

  /** Lets other tabs open it. */
  async close(): Promise<void> {
    await this.#lock?.release()
  }

  /** As stored, where it is: it may have another name by now. */
  async #record(): Promise<ProjectRecord> {
    const stored = await this.#database.read((database) => database.get('projects', this.id))
    return stored ?? { version: 1, name: this.#name, created: new Date() }
  }

  #writeFiles(table: WritableTable, record: ProjectRecord): void {
    table('projects').put(record, this.id)
    table('images').delete(rangeOf(this.id))
    for (const [i, file] of this.files.entries()) table('files').put(file, [this.id, i])
  }

  #bytesOf(document: StudioDocument): number {
    const images = [...imagesOf(document)].map((image) => bytesOf(image).length)
    const files = this.files.map(({ file }) => file.size)
    return [...images, ...files].reduce((sum, bytes) => sum + bytes, 0)
  }
}

/** The error for a project that another tab has open. */
export function openElsewhere(name: string, remedy: string): FurrowError {
  const problem = `${name} is open in another tab`
  return new FurrowError({ code: 'unwritable', who: 'Studio', problem, remedy })
}

/** Images with the numbers that they are stored under, and with new numbers where they are not. */
function numbered(images: ReadonlySet<ImageRecord>, stored: Numbers): Map<ImageRecord, number> {
  let next = 1 + Math.max(-1, ...stored.values())
  return new Map([...images].map((image) => [image, stored.get(image) ?? next++]))
}

function writeImages(table: IDBObjectStore, id: string, stored: Numbers, images: Numbers): void {
  for (const [image, number] of images) if (!stored.has(image)) table.put(withOwnBuffer(image), [id, number])
  for (const [image, number] of stored) if (!images.has(image)) table.delete([id, number])
}

/** An image whose bytes are not part of a larger buffer, such as a whole file's, which would be stored with them. */
function withOwnBuffer(image: ImageRecord): ImageRecord {
  const bytes = bytesOf(image)
  if (bytes.length === bytes.buffer.byteLength) return image
  return 'bytes' in image ? { ...image, bytes: bytes.slice() } : { ...image, data: bytes.slice() }
}

function bytesOf(image: ImageRecord): Uint8Array {
  return 'bytes' in image ? image.bytes : image.data
}
