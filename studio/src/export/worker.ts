import { expose, transfer } from 'comlink'
import { folderFiles } from '../keep/folder-files.ts'
import { holdLife } from '../workers/life.ts'
import { bakeSculpt } from './bake-sculpt.ts'
import { exportDocument } from './export-document.ts'
import { readDocument, readProject } from './read-document.ts'

/** What the worker does; bytes that it made are handed over and not copied. */
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
holdLife()

/** The buffers of arrays, each once. Maps that were copied from a face are parts of its buffer, which stays. */
function buffersOf(arrays: readonly Uint8Array[]): ArrayBuffer[] {
  const whole = arrays.filter(({ byteLength, buffer }) => byteLength === buffer.byteLength)
  return [...new Set(whole.map(({ buffer }) => buffer as ArrayBuffer))]
}
