import { effect, type ReadonlySignal, signal } from '@preact/signals'
import type { FolderFile } from '../files/folder-files.ts'
import { pickFolder, projectFolder, requestWriteAccess, writeFolder } from '../keep/disk-folder.ts'
import type { OpenedAvatar } from '../open/avatar.ts'
import { documentToPack } from './exporting.ts'
import type { Workspace } from './workspace.ts'

/** Saves the project as a folder for `furrow pack`, or as a .zip of this folder. */
export class Saving {
  readonly #workspace: Workspace
  readonly #folder = signal<FileSystemDirectoryHandle | null>(null)

  constructor(workspace: Workspace) {
    this.#workspace = workspace
    effect(() => {
      const project = workspace.keeping.kept.value
      this.#folder.value = null
      void project?.folder().then(
        (folder) => {
          if (folder && project === workspace.keeping.kept.peek()) this.#folder.value = folder
        },
        () => {},
      )
    })
  }

  /** Folder of the project on disk, or null. */
  get folder(): ReadonlySignal<FileSystemDirectoryHandle | null> {
    return this.#folder
  }

  /** Returns a .zip of the project with its avatar, or null if no document is open. Rejects with a FurrowError if packing fails. */
  async zip(): Promise<{ file: Blob; name: string } | null> {
    const project = await this.#files()
    const { zipFolder } = await import('../files/zip.ts')
    return project && { file: await zipFolder(project.files, project.name), name: `${project.name}.zip` }
  }

  /**
   * Writes the project to its folder on disk. Asks the user for a folder if the project has none. Call while handling a click or
   * a key, because browsers open the folder dialog only then.
   *
   * @param isOtherFolder whether to ask for another folder.
   * @returns the folder name. Null if the user chose no folder or no document is open. Rejects with a FurrowError if writing fails.
   */
  async toFolder(isOtherFolder: boolean): Promise<string | null> {
    const known = isOtherFolder ? null : this.#folder.peek()
    const chosen = known ?? (await pickFolder())
    if (!chosen) return null
    if (known) await requestWriteAccess(known)
    const project = await this.#files()
    if (!project) return null
    const folder = known ?? (await projectFolder(chosen, project.name))
    await writeFolder(folder, project.files)
    await this.#remember(folder)
    return folder.name
  }

  async #files(): Promise<{ name: string; files: FolderFile[] } | null> {
    const work = await this.#workspace.drawnWork()
    if (!work) return null
    const { avatar } = work
    const { folderFilesInWorker } = await import('../export/in-worker.ts')
    const files = await folderFilesInWorker(documentToPack(work), avatar.files)
    return { name: nameOf(avatar), files }
  }

  /** Stores the folder of the project. If the browser blocks storage, remembers the folder until the page closes. */
  async #remember(folder: FileSystemDirectoryHandle): Promise<void> {
    const project = await this.#workspace.keeping.project().catch(() => undefined)
    await project?.setFolder(folder).catch(() => {})
    this.#folder.value = folder
  }
}

/** Returns the avatar's name as a valid file name. */
function nameOf({ name }: OpenedAvatar): string {
  return name.replace(/[\\/:*?"<>|\p{Cc}]/gu, '_').replace(/^\.+/, '_') || 'avatar'
}
