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
import { lockProject, type ProjectLock, whenFree } from './project-lock.ts'

/** Integer key of each image in the database. */
type Numbers = ReadonlyMap<ImageRecord, number>

/** Images of a project in the database. */
interface Stored {
  readonly images: Numbers
  /** Database connection that wrote or read the images. With another connection, `save` writes all images again. */
  readonly by: unknown
}

/** Project that is open in this tab. */
export class Project {
  readonly id: string
  /** Files of the avatar: the glTF or VRM file, followed by the files that it references. */
  readonly files: readonly AvatarFile[]
  /** Document as it was when the project was opened. */
  readonly opened: StudioDocument
  readonly #name: string
  readonly #database: Database
  #lock: ProjectLock | undefined
  #stored: Stored | undefined
  /** Time of the last save that this tab knows, milliseconds. Undefined before the first save. */
  #saved: number | undefined

  /**
   * @param opened.stored images in the database, absent for a new project.
   * @param opened.saved time of the last save, absent for a new project.
   * @param lock lock of the project, or undefined if another tab holds it.
   */
  constructor(
    database: Database,
    { id, name, files }: { id: string; name: string; files: readonly AvatarFile[] },
    { document, stored, saved }: { document: StudioDocument; stored?: Stored; saved?: Date | undefined },
    lock: ProjectLock | undefined,
  ) {
    this.id = id
    this.files = files
    this.opened = document
    this.#name = name
    this.#database = database
    this.#lock = lock
    this.#stored = stored
    this.#saved = saved?.getTime()
  }

  /**
   * Whether another tab holds the project's lock. This tab can then edit and export but not save, so that the tabs do not overwrite each
   * other's work.
   */
  get isReadOnly(): boolean {
    return !this.#lock?.isHeld
  }

  /** Sets a callback that runs when another tab wants the project. The callback should close the project. */
  onRequested(call: () => void): void {
    if (this.#lock) this.#lock.onRequested = call
  }

  /**
   * Stores the document in one transaction: writes new images and deletes unused ones. Calls must not overlap.
   *
   * @throws FurrowError if another tab holds the project's lock, or if the browser cannot store the document.
   */
  async save(document: StudioDocument): Promise<void> {
    if (this.isReadOnly) throw openElsewhereError(this.#name, 'save a copy, or close this tab')
    // Clearing the site's data deletes the database and closes the connection. So after opening a new connection, write everything again.
    const connection = this.#database.opened ?? (await this.#database.open())
    const stored = this.#stored?.by === connection ? this.#stored.images : undefined
    const images = numbered(imagesOf(document), stored ?? new Map())
    const record = stored ? undefined : await this.#record()
    const changed = new Date()
    await this.#database.write((table) => {
      if (record) this.#writeFiles(table, record)
      writeImages(table('images'), this.id, stored ?? new Map(), images)
      table('documents').put(
        recordOf(document, (image) => images.get(image)!),
        this.id,
      )
      const save: SaveRecord = { changed, bytes: this.#bytesOf(document) }
      table('saves').put(save, this.id)
    })
    this.#stored = { images, by: connection }
    this.#saved = changed.getTime()
  }

  /**
   * Waits until no other tab holds the project's lock, and takes the lock if no other tab has saved the project meanwhile. Then `isReadOnly` is
   * false. Returns whether another tab has saved the project.
   *
   * @param signal ends the wait.
   */
  async reclaim(signal: AbortSignal): Promise<boolean> {
    while (!signal.aborted) {
      await whenFree(this.id, signal)
      const lock = signal.aborted ? undefined : await lockProject(this.id)
      // A third tab may have been faster.
      if (!lock) continue
      const save = await this.#database
        .read((database) => database.get('saves', this.id))
        .catch(() => undefined)
      if (save?.changed.getTime() === this.#saved && !signal.aborted) {
        this.#lock = lock
        return false
      }
      await lock.release()
      return true
    }
    return false
  }

  async setThumbnail(thumbnail: Blob): Promise<void> {
    if (this.isReadOnly) return
    await this.#database.write((table) => table('thumbnails').put(thumbnail, this.id))
  }

  /** Returns the folder on disk to which the user saved the project, if there is one. */
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

  /** Returns the stored record, whose name may be newer than `#name`. Returns a new record if none is stored. */
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

export function openElsewhereError(name: string, remedy: string): FurrowError {
  const problem = `${name} is open in another tab`
  return new FurrowError({ code: 'unwritable', who: 'Studio', problem, remedy })
}

/** Assigns a number to each image. Images that are already stored keep their numbers. */
function numbered(images: ReadonlySet<ImageRecord>, stored: Numbers): Map<ImageRecord, number> {
  let next = 1 + Math.max(-1, ...stored.values())
  return new Map([...images].map((image) => [image, stored.get(image) ?? next++]))
}

function writeImages(table: IDBObjectStore, id: string, stored: Numbers, images: Numbers): void {
  for (const [image, number] of images) if (!stored.has(image)) table.put(unshareBuffer(image), [id, number])
  for (const [image, number] of stored) if (!images.has(image)) table.delete([id, number])
}

/** Copies an image that is a part of a larger buffer, because IndexedDB would store the complete buffer. */
function unshareBuffer(image: ImageRecord): ImageRecord {
  const bytes = bytesOf(image)
  if (bytes.length === bytes.buffer.byteLength) return image
  if (ArrayBuffer.isView(image)) return image.slice()
  return 'bytes' in image ? { ...image, bytes: bytes.slice() } : { ...image, data: bytes.slice() }
}

function bytesOf(image: ImageRecord): Uint8Array {
  if (ArrayBuffer.isView(image)) return new Uint8Array(image.buffer, image.byteOffset, image.byteLength)
  return 'bytes' in image ? image.bytes : image.data
}
