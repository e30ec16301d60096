import { FurrowError } from 'furrow'

/** A file that a user gave the page. */
export interface DroppedFile {
  /** Its path below what was dropped, with `/`; of a single file its name. */
  path: string
  file: File
}

/** Most files that are listed, so that the page does not hang on a dropped home folder. */
export const MOST_FILES = 5000
/** Folders inside each other beyond which nothing is listed. */
const MOST_DEPTH = 32

/** What systems and programs leave in folders. Names that begin with a dot are hidden as well. */
const LEFT_BEHIND = new Set(['__MACOSX', 'Thumbs.db', 'desktop.ini', 'node_modules'])

/**
 * The files of a drop or a paste. Folders are listed with all that is below them.
 *
 * @param transfer is read before this returns: after its event it is empty.
 * @throws FurrowError when there are too many.
 */
export async function filesOfTransfer(transfer: DataTransfer): Promise<DroppedFile[]> {
  const items = [...transfer.items].filter(({ kind }) => kind === 'file')
  // What does not come from a disk, such as a pasted picture, has no entry.
  const sources = items.map((item) => item.webkitGetAsEntry?.() ?? item.getAsFile())
  const files = new Listing()
  for (const source of sources) {
    if (source instanceof File) files.add(source.name, source)
    else if (source) await addEntry(files, source, '', 0)
  }
  return files.list
}

/** The files of an `<input type="file">`, with `multiple` or `webkitdirectory` too. Throws FurrowError when there are too many. */
export function filesOfInput(chosen: Iterable<File>): DroppedFile[] {
  const files = new Listing()
  for (const file of chosen) files.add(file.webkitRelativePath || file.name, file)
  return files.list
}

/**
 * The bytes of a file, or of a part of it.
 *
 * @param name of the file, as the user knows it.
 * @throws FurrowError when it is no longer there, or may not be read.
 */
export async function bytesOf(blob: Blob, name: string): Promise<Uint8Array<ArrayBuffer>> {
  try {
    return new Uint8Array(await blob.arrayBuffer())
  } catch (error) {
    throw notReadable(name, error as Error)
  }
}

/** Files as they are found, without hidden ones. */
class Listing {
  readonly list: DroppedFile[] = []

  add(path: string, file: File): void {
    if (path.split('/').some(isHidden)) return
    if (this.list.length === MOST_FILES) throw tooManyFiles('what is dropped at once')
    this.list.push({ path, file })
  }
}

function isHidden(name: string): boolean {
  return name.startsWith('.') || LEFT_BEHIND.has(name)
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
  } else if (depth < MOST_DEPTH) {
    const reader = (entry as FileSystemDirectoryEntry).createReader()
    // Browsers list a hundred at a time, and then none.
    for (let some = await nextEntries(reader); some.length > 0; some = await nextEntries(reader)) {
      for (const child of some) await addEntry(files, child, `${path}/`, depth + 1)
    }
  }
}

function fileOf(entry: FileSystemFileEntry): Promise<File> {
  return new Promise((resolve, reject) =>
    entry.file(resolve, (error) => reject(notReadable(entry.name, error))),
  )
}

function nextEntries(reader: FileSystemDirectoryReader): Promise<FileSystemEntry[]> {
  return new Promise((resolve, reject) =>
    reader.readEntries(resolve, (error) => reject(notReadable('a folder', error))),
  )
}

function notReadable(name: string, { message }: Error): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who: 'Studio',
    problem: `${name} cannot be read`,
    value: message,
    remedy: 'check that it is still there and that the browser may read it, then drop it again',
  })
}

/** The error for a folder or an archive with too many files. */
export function tooManyFiles(name: string): FurrowError {
  return new FurrowError({
    code: 'out-of-range',
    who: 'Studio',
    problem: `too many files in ${name}`,
    limit: `${MOST_FILES.toLocaleString('en')} files`,
    remedy: 'drop the folder of the avatar alone',
  })
}
