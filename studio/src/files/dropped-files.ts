import { FurrowError } from 'furrow'

/** File that the user dropped, pasted or chose. */
export interface DroppedFile {
  /** Path with `/`. Begins with the name of the dropped folder, if any. For a single file, the path is its name. */
  path: string
  file: File
}

/** Maximum number of files, so that a dropped home folder does not block the page. */
export const MAX_FILES = 5000
const MAX_DEPTH = 32

/** Skipped names, in addition to all names that begin with a dot. */
const JUNK = new Set(['__MACOSX', 'Thumbs.db', 'desktop.ini', 'node_modules'])

/**
 * Lists the files of a drop or a paste, including the contents of folders.
 *
 * @param transfer data of the event. It is read synchronously, because browsers empty it after the event.
 * @throws FurrowError if there are too many files.
 */
export async function filesOfTransfer(transfer: DataTransfer): Promise<DroppedFile[]> {
  const items = [...transfer.items].filter(({ kind }) => kind === 'file')
  // A file that is not on disk, such as a pasted picture, has no entry.
  const sources = items.map((item) => item.webkitGetAsEntry?.() ?? item.getAsFile())
  const files = new Listing()
  for (const source of sources) {
    if (source instanceof File) files.add(source.name, source)
    else if (source) await addEntry(files, source, '', 0)
  }
  return files.list
}

/** Lists the files of an `<input type="file">`, also with `webkitdirectory`. Throws FurrowError if there are too many. */
export function filesOfInput(chosen: Iterable<File>): DroppedFile[] {
  const files = new Listing()
  for (const file of chosen) files.add(file.webkitRelativePath || file.name, file)
  return files.list
}

/**
 * Reads the bytes of a file, or of a part of it.
 *
 * @param name file name for errors.
 * @throws FurrowError if the file is gone or not readable.
 */
export async function bytesOf(blob: Blob, name: string): Promise<Uint8Array<ArrayBuffer>> {
  try {
    return new Uint8Array(await blob.arrayBuffer())
  } catch (error) {
    throw unreadableError(name, error as Error)
  }
}

/** List that ignores hidden files when they are added. */
class Listing {
  readonly list: DroppedFile[] = []

  add(path: string, file: File): void {
    if (path.split('/').some(isHidden)) return
    if (this.list.length === MAX_FILES) throw tooManyFilesError('one drop')
    this.list.push({ path, file })
  }
}

function isHidden(name: string): boolean {
  return name.startsWith('.') || JUNK.has(name)
}

async function addEntry(
  files: Listing,
  entry: FileSystemEntry,
  folder: string,
  depth: number,
): Promise<void> {
  if (isHidden(entry.name)) return
  const path = folder + entry.name
  if (entry.isFile) {
    files.add(path, await fileOf(entry as FileSystemFileEntry))
  } else if (depth < MAX_DEPTH) {
    const reader = (entry as FileSystemDirectoryEntry).createReader()
    // Browsers return entries in batches of a hundred, and an empty batch at the end.
    for (let batch = await nextEntries(reader); batch.length > 0; batch = await nextEntries(reader)) {
      for (const child of batch) await addEntry(files, child, `${path}/`, depth + 1)
    }
  }
}

function fileOf(entry: FileSystemFileEntry): Promise<File> {
  return new Promise((resolve, reject) =>
    entry.file(resolve, (error) => reject(unreadableError(entry.name, error))),
  )
}

function nextEntries(reader: FileSystemDirectoryReader): Promise<FileSystemEntry[]> {
  return new Promise((resolve, reject) =>
    reader.readEntries(resolve, (error) => reject(unreadableError('a folder', error))),
  )
}

function unreadableError(name: string, { message }: Error): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who: 'Studio',
    problem: `${name} cannot be read`,
    value: message,
    remedy: 'check that it is still there and that the browser may read it, then drop it again',
  })
}

export function tooManyFilesError(name: string): FurrowError {
  return new FurrowError({
    code: 'out-of-range',
    who: 'Studio',
    problem: `too many files in ${name}`,
    limit: `${MAX_FILES.toLocaleString('en')} files`,
    remedy: 'drop the folder of the avatar alone',
  })
}
