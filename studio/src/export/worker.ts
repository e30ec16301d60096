import { expose, transfer } from 'comlink'
import { folderFiles } from '../keep/folder-files.ts'
import { holdLifeLock } from '../workers/life.ts'
import { bakeSculpt } from './bake-sculpt.ts'
import { exportDocument } from './export-document.ts'
import { readDocument, readProject } from './read-document.ts'

/** Tasks that the page can run in this worker. Large results are transferred, not copied. */
const tasks = {
  async exportDocument(...args: Parameters<typeof exportDocument>) {
    const exported = await exportDocument(...args)
    return transfer(exported, buffersOf([exported.bytes]))
  },
  folderFiles(...args: Parameters<typeof folderFiles>) {
    const files = folderFiles(...args)
    const made = files.flatMap(({ content }) => (content instanceof Blob ? [] : content))
    return transfer(files, buffersOf(made))
  },
  async bakeSculpt(...args: Parameters<typeof bakeSculpt>) {
    const bytes = await bakeSculpt(...args)
    return transfer(bytes, buffersOf([bytes]))
  },
  readDocument,
  readProject,
}

export type Tasks = typeof tasks

expose(tasks)
holdLifeLock()

/** Collects the buffers to transfer. Skips views of larger buffers, because a transfer would detach all views of the buffer. */
function buffersOf(arrays: readonly Uint8Array[]): ArrayBuffer[] {
  const unshared = arrays.filter(({ byteLength, buffer }) => byteLength === buffer.byteLength)
  return [...new Set(unshared.map(({ buffer }) => buffer as ArrayBuffer))]
}
