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

/** Numbers of stored images. */
type Numbers = ReadonlyMap<ImageRecord, number>

/** State of a project in the database. */
interface Stored {
  readonly images: Numbers
  /** Database connection that wrote or read the images. After a reconnection, all images are written again. */
  readonly by: unknown
}

/** Project that is open in this tab. */
export class Project {
  readonly id: string
  /** The avatar's files; the first is the face. */
  readonly files: readonly AvatarFile[]
  /** Document at opening. */
  readonly opened: StudioDocument
  readonly #name: string
  readonly #database: Database
  readonly #lock: ProjectLock | undefined
  #stored: Stored | undefined

  /**
   * @param opened.stored state in the database, absent for a new project.
   * @param lock undefined if another tab has the project.
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
   * Whether another tab has the project. This tab can then edit and export but not save, so that the tabs do not overwrite each
   * other's work.
   */
  get isReadOnly(): boolean {
    return !this.#lock?.isHeld
  }

  /** Sets the callback for a request of another tab. The callback should close the project. */
  onRequested(call: () => void): void {
    if (this.#lock) this.#lock.onRequested = call
  }

  /**
   * Stores the document in one transaction: writes new images and deletes unused ones. Calls must not overlap.
   *
   * @throws FurrowError if another tab has the project, or if the browser cannot store it.
   */
  async save(document: StudioDocument): Promise<void> {
    if (this.isReadOnly) throw openElsewhereError(this.#name, 'save a copy, or close this tab')
    // A closed connection can mean cleared data, so everything is written again.
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

  /** Stores a thumbnail for the list of projects. */
  async setThumbnail(thumbnail: Blob): Promise<void> {
    if (this.isReadOnly) return
    await this.#database.write((table) => table('thumbnails').put(thumbnail, this.id))
  }

  /** Folder on disk of the last write. */
  async folder(): Promise<FileSystemDirectoryHandle | undefined> {
    return this.#database.read((database) => database.get('folders', this.id))
  }

  async setFolder(folder: FileSystemDirectoryHandle): Promise<void> {
    await this.#database.write((table) => table('folders').put(folder, this.id))
  }

  /** Releases the project for other tabs. */
  async close(): Promise<void> {
    await this.#lock?.release()
  }

  /** Returns the stored record, which may have been renamed, or a new one. */
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

/** Returns the error for a project that is open in another tab. */
export function openElsewhereError(name: string, remedy: string): FurrowError {
  const problem = `${name} is open in another tab`
  return new FurrowError({ code: 'unwritable', who: 'Studio', problem, remedy })
}

/** Assigns numbers to images. Stored images keep theirs. */
function numbered(images: ReadonlySet<ImageRecord>, stored: Numbers): Map<ImageRecord, number> {
  let next = 1 + Math.max(-1, ...stored.values())
  return new Map([...images].map((image) => [image, stored.get(image) ?? next++]))
}

function writeImages(table: IDBObjectStore, id: string, stored: Numbers, images: Numbers): void {
  for (const [image, number] of images) if (!stored.has(image)) table.put(unshareBuffer(image), [id, number])
  for (const [image, number] of stored) if (!images.has(image)) table.delete([id, number])
}

/** Copies the bytes out of a larger buffer, because IndexedDB would store the entire buffer. */
function unshareBuffer(image: ImageRecord): ImageRecord {
  const bytes = bytesOf(image)
  if (bytes.length === bytes.buffer.byteLength) return image
  return 'bytes' in image ? { ...image, bytes: bytes.slice() } : { ...image, data: bytes.slice() }
}

function bytesOf(image: ImageRecord): Uint8Array {
  return 'bytes' in image ? image.bytes : image.data
}
