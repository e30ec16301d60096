// A folder of the browser's private file system replaces a folder picked by the user. Both have the same interface.

import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import type { FolderFile } from '../../../studio/src/files/folder-files.ts'
import {
  canWriteFolders,
  pickFolder,
  requestWriteAccess,
  writeFolder,
} from '../../../studio/src/keep/disk-folder.ts'

const text = (content: string) => new TextEncoder().encode(content)

/** Returns the files of a project: images, and `studio.json`, which lists images. */
function filesOf(images: Record<string, string>, listed = Object.keys(images)): FolderFile[] {
  return [
    { path: 'face.glb', content: new Blob(['the face']) },
    ...Object.entries(images).map(([path, content]) => ({ path, content: text(content) })),
    { path: 'wrinkles.json', content: text('{}') },
    { path: 'studio.json', content: text(JSON.stringify({ version: 1, files: listed })) },
  ]
}

const IMAGES = { 'layers/up/normal.png': 'normals', 'areas/frown.png': 'frown' }

let root: FileSystemDirectoryHandle
let folder: FileSystemDirectoryHandle

async function contents(): Promise<Record<string, string>> {
  const texts: Record<string, string> = {}
  const list = async (directory: FileSystemDirectoryHandle, path: string) => {
    for await (const [name, handle] of directory.entries()) {
      if (handle.kind === 'file') texts[path + name] = await (await handle.getFile()).text()
      else await list(handle, `${path}${name}/`)
    }
  }
  await list(folder, '')
  return texts
}

beforeEach(async () => {
  root = await navigator.storage.getDirectory()
  folder = await root.getDirectoryHandle(crypto.randomUUID(), { create: true })
})

afterEach(async () => {
  vi.restoreAllMocks()
  vi.unstubAllGlobals()
  await root.removeEntry(folder.name, { recursive: true })
})

describe('a folder on disk', () => {
  it('receives all files in the first save, and later only changed ones', async () => {
    const files = filesOf(IMAGES)
    expect((await writeFolder(folder, files)).length).toBe(5)
    expect(await contents()).toMatchObject({ ...IMAGES, 'face.glb': 'the face', 'wrinkles.json': '{}' })
    const opened = vi.spyOn(FileSystemFileHandle.prototype, 'createWritable')
    expect(await writeFolder(folder, files)).toEqual([])
    const painted = filesOf({ ...IMAGES, 'areas/frown.png': 'other' })
    expect(await writeFolder(folder, painted)).toEqual(['areas/frown.png'])
    expect(opened).toHaveBeenCalledTimes(1)
    expect((await contents())['areas/frown.png']).toBe('other')
  })

  it('loses only images that the studio wrote earlier', async () => {
    await writeFolder(folder, filesOf({ ...IMAGES, 'layers/up/normal.psd': 'source' }, Object.keys(IMAGES)))
    const next = filesOf({ 'layers/up/normal.png': 'normals' })
    expect(await writeFolder(folder, next)).toEqual(['studio.json', 'areas/frown.png'])
    const paths = Object.keys(await contents()).sort()
    expect(paths).toEqual([
      'face.glb',
      'layers/up/normal.png',
      'layers/up/normal.psd',
      'studio.json',
      'wrinkles.json',
    ])
  })

  it('keeps other files even if its studio.json lists them', async () => {
    await writeFolder(folder, [
      ...filesOf(IMAGES, ['notes.txt', '../x', 3 as never]),
      { path: 'notes.txt', content: text('mine') },
    ])
    await writeFolder(folder, filesOf(IMAGES))
    expect((await contents())['notes.txt']).toBe('mine')
  })

  it('keeps the previous version of a file if writing fails', async () => {
    await writeFolder(folder, filesOf(IMAGES))
    vi.spyOn(FileSystemWritableFileStream.prototype, 'write').mockRejectedValue(new Error('disk full'))
    const painted = filesOf({ ...IMAGES, 'areas/frown.png': 'other' })
    await expect(writeFolder(folder, painted)).rejects.toThrow(
      /Studio: cannot write to the folder .* \(disk full\)/,
    )
    expect((await contents())['areas/frown.png']).toBe('frown')
  })

  it('is written to again after the user grants permission', async () => {
    const asked = vi.fn().mockResolvedValue('granted')
    const kept = { name: 'kept', queryPermission: async () => 'prompt', requestPermission: asked }
    await requestWriteAccess(kept as unknown as FileSystemDirectoryHandle)
    expect(asked).toHaveBeenCalledTimes(1)
    asked.mockResolvedValue('denied')
    await expect(requestWriteAccess(kept as unknown as FileSystemDirectoryHandle)).rejects.toThrow(
      'Studio: cannot write to the folder kept (permission denied)',
    )
  })

  it('is the picked one, or undefined if the user cancels the dialog', async () => {
    vi.stubGlobal('showDirectoryPicker', async () => folder)
    expect(canWriteFolders()).toBe(true)
    expect(await pickFolder()).toBe(folder)
    vi.stubGlobal('showDirectoryPicker', () => Promise.reject(new DOMException('', 'AbortError')))
    expect(await pickFolder()).toBeUndefined()
  })
})
