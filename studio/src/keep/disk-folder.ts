import { FurrowError } from 'furrow'
import type { FolderFile } from '../files/folder-files.ts'
import { parseStudioFile, STUDIO_FILE } from './studio-file.ts'

/** What TypeScript's library does not have yet. */
type Directory = FileSystemDirectoryHandle & {
  queryPermission?(mode: { mode: 'readwrite' }): Promise<PermissionState>
  requestPermission?(mode: { mode: 'readwrite' }): Promise<PermissionState>
}
type Picker = (options: { id: string; mode: 'readwrite' }) => Promise<FileSystemDirectoryHandle>

/** Whether the browser can write to a folder of the disk; others download a .zip. */
export function canWriteFolders(): boolean {
  return 'showDirectoryPicker' in globalThis
}

/** Asks for a folder; undefined where the user chooses none. */
export async function pickFolder(): Promise<FileSystemDirectoryHandle | undefined> {
  const picker = (globalThis as unknown as { showDirectoryPicker: Picker }).showDirectoryPicker
  try {
    return await picker({ id: 'furrow', mode: 'readwrite' })
  } catch (error) {
    if ((error as Error).name === 'AbortError') return undefined
    throw error
  }
}

/**
 * The folder for a project in one that was chosen: that itself where it is empty or has a project, else a new one in it, so that a project
 * is not strewn over other files.
 */
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
    throw unwritable(chosen.name, (error as Error).message, 'choose another folder')
  }
}

/**
 * Asks for the permission to write to a folder of an earlier visit, which browsers allow in answer to a click only.
 *
 * @throws FurrowError where the user does not give it.
 */
export async function askToWrite(folder: FileSystemDirectoryHandle): Promise<void> {
  const { queryPermission, requestPermission } = folder as Directory
  const mode = { mode: 'readwrite' } as const
  if (((await queryPermission?.call(folder, mode)) ?? 'granted') === 'granted') return
  if ((await requestPermission?.call(folder, mode)) === 'granted') return
  throw unwritable(folder.name, 'permission denied', 'allow it, or save to another folder')
}

/**
 * Writes a project's files to a folder: those that differ from what is there, each to a temporary file that then takes its place; and deletes
 * images that the studio wrote before and no longer needs. Other files stay as they are.
 *
 * @returns the paths that were written or deleted.
 * @throws FurrowError where it cannot be written.
 */
export async function writeFolder(
  folder: FileSystemDirectoryHandle,
  files: readonly FolderFile[],
): Promise<string[]> {
  const changed: string[] = []
  try {
    const old = await filesOfStudio(folder)
    for (const { path, content } of files) if (await write(folder, path, content)) changed.push(path)
    const paths = new Set(files.map(({ path }) => path))
    for (const path of old) if (!paths.has(path) && (await remove(folder, path))) changed.push(path)
    return changed
  } catch (error) {
    throw unwritable(folder.name, (error as Error).message, 'save to another folder, or as a file')
  }
}

/** Images that the studio wrote to a folder before. */
async function filesOfStudio(folder: FileSystemDirectoryHandle): Promise<string[]> {
  try {
    const file = await (await folder.getFileHandle(STUDIO_FILE)).getFile()
    const { files = [] } = parseStudioFile(JSON.parse(await file.text())).studio
    // Only images: a file that someone wrote cannot make the studio delete others.
    return files.filter((path) => /^(layers|areas|under)\/.*\.\w+$/.test(path))
  } catch {
    return []
  }
}

/** Whether the file was another. */
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
  // An empty file may have been made just now.
  return file.size > 0 && a.every((value, i) => value === b[i])
}

async function handleOf(folder: FileSystemDirectoryHandle, path: string, create: boolean) {
  const parent = await parentOf(folder, path, create)
  return parent?.getFileHandle(path.split('/').at(-1)!, { create })
}

/** The folder that a file is in; undefined where there is none and none is made. */
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

function unwritable(name: string, reason: string, remedy: string): FurrowError {
  const problem = `cannot write to the folder ${name} (${reason})`
  return new FurrowError({ code: 'unwritable', who: 'Studio', problem, remedy })
}
