import { FurrowError } from 'furrow'
import type { FolderFile } from '../files/folder-files.ts'
import { parseStudioFile, STUDIO_FILE } from './studio-file.ts'

/** Methods that TypeScript's DOM library lacks. */
type Directory = FileSystemDirectoryHandle & {
  queryPermission?(mode: { mode: 'readwrite' }): Promise<PermissionState>
  requestPermission?(mode: { mode: 'readwrite' }): Promise<PermissionState>
}
type Picker = (options: { id: string; mode: 'readwrite' }) => Promise<FileSystemDirectoryHandle>

/** Whether the browser can write to folders on disk. If not, a project can only be saved as a .zip file. */
export function canWriteFolders(): boolean {
  return 'showDirectoryPicker' in globalThis
}

/** Asks for a folder. Returns undefined if the user cancels. */
export async function pickFolder(): Promise<FileSystemDirectoryHandle | undefined> {
  const picker = (globalThis as unknown as { showDirectoryPicker: Picker }).showDirectoryPicker
  try {
    return await picker({ id: 'furrow', mode: 'readwrite' })
  } catch (error) {
    if ((error as Error).name === 'AbortError') return undefined
    throw error
  }
}

/** Returns the folder for a project: `chosen` if it is empty or contains a project. Otherwise creates a folder in `chosen` and returns it. */
export async function projectFolder(
  chosen: FileSystemDirectoryHandle,
  name: string,
): Promise<FileSystemDirectoryHandle> {
  const names: string[] = []
  for await (const entry of chosen.keys()) names.push(entry)
  const isProject = names.length === 0 || names.includes('wrinkles.json') || names.includes(STUDIO_FILE)
  if (isProject) return chosen
  try {
    return await chosen.getDirectoryHandle(name, { create: true })
  } catch (error) {
    throw unwritableError(chosen.name, (error as Error).message, 'choose another folder')
  }
}

/**
 * Asks for permission to write to a folder that the user chose on an earlier visit. Call while handling a click or a key.
 *
 * @throws FurrowError if the user denies it.
 */
export async function requestWriteAccess(folder: FileSystemDirectoryHandle): Promise<void> {
  const { queryPermission, requestPermission } = folder as Directory
  const mode = { mode: 'readwrite' } as const
  if (((await queryPermission?.call(folder, mode)) ?? 'granted') === 'granted') return
  if ((await requestPermission?.call(folder, mode)) === 'granted') return
  throw unwritableError(folder.name, 'permission denied', 'allow it, or save to another folder')
}

/**
 * Writes a project's changed files to a folder, each one atomically. Deletes images and takes that the studio wrote earlier and that the project no longer
 * uses. Does not change other files.
 *
 * @returns written and deleted paths.
 * @throws FurrowError if writing fails.
 */
export async function writeFolder(
  folder: FileSystemDirectoryHandle,
  files: readonly FolderFile[],
): Promise<string[]> {
  const changed: string[] = []
  try {
    const old = await studioImages(folder)
    for (const { path, content } of files) if (await write(folder, path, content)) changed.push(path)
    const paths = new Set(files.map(({ path }) => path))
    for (const path of old) if (!paths.has(path) && (await remove(folder, path))) changed.push(path)
    return changed
  } catch (error) {
    throw unwritableError(folder.name, (error as Error).message, 'save to another folder, or as a file')
  }
}

/** Lists images and takes that the studio wrote earlier. */
async function studioImages(folder: FileSystemDirectoryHandle): Promise<string[]> {
  try {
    const file = await (await folder.getFileHandle(STUDIO_FILE)).getFile()
    const { files = [] } = parseStudioFile(JSON.parse(await file.text())).studio
    // Accept only images and takes, so that an edited `studio.json` cannot make the studio delete other files.
    return files.filter((path) => /^(layers|areas|under|takes)\/.*\.\w+$/.test(path))
  } catch {
    return []
  }
}

/** Writes a file. Returns false if it already has this content. */
async function write(
  folder: FileSystemDirectoryHandle,
  path: string,
  content: Uint8Array | Blob,
): Promise<boolean> {
  const handle = await handleOf(folder, path, true)
  if (await isSame(await handle!.getFile(), content)) return false
  const writable = await handle!.createWritable()
  try {
    await writable.write(content as Blob | Uint8Array<ArrayBuffer>)
  } catch (error) {
    await writable.abort()
    throw error
  }
  await writable.close()
  return true
}

async function remove(folder: FileSystemDirectoryHandle, path: string): Promise<boolean> {
  const parent = await parentOf(folder, path, false)
  const name = path.split('/').at(-1)!
  return parent === undefined
    ? false
    : parent.removeEntry(name).then(
        () => true,
        () => false,
      )
}

async function isSame(file: File, content: Uint8Array | Blob): Promise<boolean> {
  const bytes = content instanceof Blob ? undefined : content
  if (file.size !== (bytes?.length ?? (content as Blob).size)) return false
  const [a, b] = [
    new Uint8Array(await file.arrayBuffer()),
    bytes ?? new Uint8Array(await (content as Blob).arrayBuffer()),
  ]
  // `write` may just have created an empty file. It counts as different, so that `writeFolder` lists its path.
  return file.size > 0 && a.every((value, i) => value === b[i])
}

async function handleOf(folder: FileSystemDirectoryHandle, path: string, create: boolean) {
  const parent = await parentOf(folder, path, create)
  return parent?.getFileHandle(path.split('/').at(-1)!, { create })
}

/** Returns the parent folder of a file, or undefined if it is missing and `create` is false. */
async function parentOf(folder: FileSystemDirectoryHandle, path: string, create: boolean) {
  let parent = folder
  for (const name of path.split('/').slice(0, -1)) {
    const next = await parent.getDirectoryHandle(name, { create }).catch((error) => {
      if (create) throw error
      return undefined
    })
    if (!next) return undefined
    parent = next
  }
  return parent
}

function unwritableError(name: string, reason: string, remedy: string): FurrowError {
  const problem = `cannot write to the folder ${name} (${reason})`
  return new FurrowError({ code: 'unwritable', who: 'Studio', problem, remedy })
}
