import { describe, expect, it } from 'vitest'
import { type DroppedFile, filesOfInput, filesOfTransfer } from '../../../studio/src/files/dropped-files.ts'
import { zipFolder } from '../../../studio/src/files/zip.ts'
import { sortFiles } from '../../../studio/src/open/sort-files.ts'

const GLB = 'glTF\x02\0\0\0'

const dropped = (contents: Record<string, string>): DroppedFile[] =>
  Object.entries(contents).map(([path, text]) => ({ path, file: new File([text], path.split('/').at(-1)!) }))

const faceOf = async (contents: Record<string, string>) => {
  const sorted = await sortFiles(dropped(contents))
  if (sorted.kind !== 'avatar') throw new Error(`it is ${sorted.kind}`)
  return { face: sorted.face.path, wrinkles: sorted.wrinkles?.name, notes: sorted.notes }
}

describe('a drop of files', () => {
  it.each(['a.glb', 'a.vrm', 'a.gltf', 'A.GLB'])('is a face: %s', async (name) => {
    expect(await faceOf({ [name]: '' })).toEqual({ face: name, wrinkles: undefined, notes: [] })
  })

  it('opens a face of any name, recognised by its content', async () => {
    expect((await faceOf({ 'notes.txt': 'text', 'avatar.bin': GLB })).face).toBe('avatar.bin')
  })

  it('opens the topmost of several faces, with a note', async () => {
    const { face, notes } = await faceOf({ 'a/deep/a.glb': GLB, 'a/z.vrm': GLB, 'a/b.glb': GLB })
    expect(face).toBe('a/b.glb')
    expect(notes).toEqual(['Opened a/b.glb, one of 3 faces'])
  })

  it('opens a folder of wrinkles with its face, whatever other faces there are', async () => {
    const files = { 'a.glb': GLB, 'my-face/face.glb': GLB, 'my-face/wrinkles.json': '{}' }
    expect(await faceOf(files)).toMatchObject({ face: 'my-face/face.glb', wrinkles: 'my-face' })
  })

  it('opens a folder of wrinkles without wrinkles.json, with a face from elsewhere', async () => {
    const files = { 'avatar.vrm': GLB, 'w/layers/up/normal.png': '', 'w/areas/brow.png': '' }
    const sorted = await sortFiles(dropped(files))
    expect(sorted).toMatchObject({ kind: 'avatar', face: { path: 'avatar.vrm' }, wrinkles: { name: 'w' } })
    const { wrinkles } = sorted as { wrinkles: { files: DroppedFile[] } }
    expect(wrinkles.files.map(({ path }) => path)).toEqual(['layers/up/normal.png', 'areas/brow.png'])
  })

  it('opens the files of a folder of wrinkles without the folder', async () => {
    const sorted = await sortFiles(dropped({ 'wrinkles.json': '{}', 'areas/brow.png': '' }))
    expect(sorted).toMatchObject({ kind: 'wrinkles', wrinkles: { name: 'wrinkles' } })
  })

  it('opens images as areas, whatever other files there are', async () => {
    const sorted = await sortFiles(
      dropped({ 'areas/a.png': '', 'areas/b.JPG': '', 'areas/notes.txt': 'text' }),
    )
    expect(sorted.kind).toBe('areas')
    expect((sorted as { images: readonly DroppedFile[] }).images.map(({ path }) => path)).toEqual([
      'areas/a.png',
      'areas/b.JPG',
    ])
  })

  it('opens the tables of a Live Link Face take, whatever pictures are in its folder', async () => {
    const take = dropped({ 'take/take.csv': 'Timecode', 'take/frame_log.csv': '', 'take/thumbnail.jpg': '' })
    const sorted = await sortFiles(take)
    expect(sorted).toMatchObject({ kind: 'captures', tables: [take[0], take[1]] })
  })

  it('opens a JSON file without wrinkles as a preset', async () => {
    const [preset] = dropped({ 'looks/old.json': '{}' })
    expect(await sortFiles([preset])).toEqual({ kind: 'preset', preset })
    expect((await faceOf({ 'a.glb': GLB, 'old.json': '{}' })).face).toBe('a.glb')
  })

  it('opens a face, whatever tables are in its folder', async () => {
    expect((await faceOf({ 'a/a.glb': GLB, 'a/a.csv': 'Timecode' })).face).toBe('a/a.glb')
  })

  it.each([
    ['model.fbx', 'Kaydara FBX Binary', 'it is an FBX file', 'convert it with FBX2glTF'],
    ['model.obj', 'v 0 0 0', 'it is an OBJ file, a format without blendshapes', 'open it in Blender'],
    ['avatar.rar', 'Rar!', 'it is an archive', 'unpack it first'],
    [
      'notes.txt',
      'hello',
      'it is text, not glTF',
      'drop a .glb, .vrm or .gltf, a folder of wrinkles, gray images, a preset, or a CSV of Live Link Face',
    ],
    ['unknown', '\x00\x01', 'its contents are unknown', 'drop a .glb'],
  ])('is refused if it is %s', async (name, text, problem, remedy) => {
    const error = await sortFiles(dropped({ [name]: text })).catch((thrown: Error) => thrown.message)
    expect(error).toContain(`Studio: ${name} is not usable: ${problem}`)
    expect(error).toContain(`; ${remedy}`)
  })

  it('opens the content of a .zip, and refuses a damaged one', async () => {
    const content = new Uint8Array([1])
    const zip = await zipFolder(
      ['face.glb', 'wrinkles.json'].map((path) => ({ path, content })),
      'inside',
    )
    const sorted = await sortFiles([{ path: 'My face.zip', file: new File([zip], 'My face.zip') }])
    expect(sorted).toMatchObject({
      kind: 'avatar',
      face: { path: 'My face/face.glb' },
      wrinkles: { name: 'My face' },
    })
    await expect(sortFiles(dropped({ 'avatar.zip': 'PK\x03\x04' }))).rejects.toThrow(
      'Studio: cannot read avatar.zip',
    )
  })

  it('is refused if it is empty', async () => {
    await expect(sortFiles([])).rejects.toThrow('Studio: no file was dropped; drop a .glb')
  })
})

describe('the files of a drop', () => {
  it('include those of folders, without hidden ones', async () => {
    const transfer = transferOf([
      file('a.glb'),
      folder('tex', [
        file('.DS_Store'),
        folder('deep', [file('b.png')]),
        folder('__MACOSX', [file('c.png')]),
      ]),
    ])
    const paths = (await filesOfTransfer(transfer)).map(({ path }) => path)
    expect(paths).toEqual(['a.glb', 'tex/deep/b.png'])
  })

  it('include all files of a folder that a browser lists in several parts', async () => {
    const many = Array.from({ length: 250 }, (_, i) => file(`${i}.png`))
    expect(await filesOfTransfer(transferOf([folder('many', many)]))).toHaveLength(250)
  })

  it('include pasted pictures, which are not entries of a file system', async () => {
    const pasted = new File([''], 'image.png')
    const item = { kind: 'file', webkitGetAsEntry: () => null, getAsFile: () => pasted }
    const text = { kind: 'string', webkitGetAsEntry: () => null, getAsFile: () => null }
    const transfer = { items: [text, item] } as unknown as DataTransfer
    expect(await filesOfTransfer(transfer)).toEqual([{ path: 'image.png', file: pasted }])
  })

  it('are at most 5,000, and endless folders are not followed', async () => {
    const many = Array.from({ length: 5001 }, (_, i) => file(`${i}.png`))
    const expected =
      'Studio: too many files in one drop, allowed: 5,000 files; drop the folder of the avatar alone'
    await expect(filesOfTransfer(transferOf([folder('home', many)]))).rejects.toThrow(expected)
    const endless = folder('endless', []) as FileSystemDirectoryEntry & { children: unknown[] }
    endless.children.push(endless, file('a.png'))
    expect((await filesOfTransfer(transferOf([endless]))).length).toBeLessThan(100)
  })

  it('are refused if one cannot be read, with its name', async () => {
    const gone = {
      ...file('gone.glb'),
      file: (_: unknown, fail: (error: Error) => void) => fail(new Error('no')),
    }
    const expected = 'Studio: gone.glb cannot be read, got "no"; check that it is still there'
    await expect(filesOfTransfer(transferOf([gone as never]))).rejects.toThrow(expected)
  })

  it('have paths in their folder if an input chose the folder', () => {
    const chosen = new File([''], 'a.png')
    Object.defineProperty(chosen, 'webkitRelativePath', { value: 'folder/a.png' })
    expect(filesOfInput([chosen, new File([''], 'b.png')]).map(({ path }) => path)).toEqual([
      'folder/a.png',
      'b.png',
    ])
  })
})

function file(name: string): FileSystemEntry {
  const entry = { name, isFile: true, file: (found: (file: File) => void) => found(new File([''], name)) }
  return entry as unknown as FileSystemEntry
}

/** Returns a fake folder. It lists a hundred entries at a time, like those of Chrome. */
function folder(name: string, children: FileSystemEntry[]): FileSystemEntry {
  const createReader = () => {
    let from = 0
    return {
      readEntries(found: (entries: FileSystemEntry[]) => void) {
        found(children.slice(from, from + 100))
        from += 100
      },
    }
  }
  return { name, isFile: false, children, createReader } as unknown as FileSystemEntry
}

function transferOf(entries: FileSystemEntry[]): DataTransfer {
  const items = entries.map((entry) => ({ kind: 'file', webkitGetAsEntry: () => entry }))
  return { items } as unknown as DataTransfer
}
