import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { expect, it } from 'vitest'
import { unzipFolder } from '../../studio/src/files/zip.ts'
import { documentOf } from '../../studio/src/keep/document-record.ts'
import {
  differencesOfDrawing,
  observeFace,
  observePacked,
  observeProject,
  withHashes,
} from '../fixtures/observe.ts'

/** Files that an earlier version wrote, see the README.md there. */
const FILES = fileURLToPath(new URL('../fixtures/files-2026-11/', import.meta.url))

const faces = readdirSync(FILES, { recursive: true, encoding: 'utf8' }).filter((path) => {
  return /\.(glb|vrm)$/.test(path) && !path.endsWith('face.glb')
})
/** Folders of wrinkles, each with the face that it is packed to. */
const folders = [
  ['drawn', 'drawn.glb'],
  ['unpacked/painted', 'painted.glb'],
  ['unpacked/studio', 'studio/exported.glb'],
]

it.each(faces)('%s has the same meaning as when it was written', async (path) => {
  await expectRecorded(path, await observeFace(join(FILES, path)))
})

it.each(folders)('the folder %s is packed to %s with the recorded content', async (folder, face) => {
  await expectRecorded(face, await observePacked(join(FILES, folder)))
})

it.each(folders)('the folder %s opens in the studio with the recorded content', async (folder) => {
  await expectRecorded(`${folder}-project`, await observeProject(filesOf(join(FILES, folder))))
})

it('strokes.json is drawn as recorded, within one of 255 levels', async () => {
  const differences = Object.entries(await differencesOfDrawing(join(FILES, 'drawn')))
  expect(differences.length).toBe(11)
  expect(differences.filter(([, most]) => most > 1)).toEqual([])
})

it('a downloaded project opens with the recorded content', async () => {
  const zip = new Blob([readFileSync(join(FILES, 'studio/project.zip'))])
  await expectRecorded('studio/project', await observeProject(await unzipFolder(zip, 'project.zip')))
})

it('a project in the browser opens with the recorded content', async () => {
  const { documents, images, projects } = JSON.parse(readFileSync(join(FILES, 'studio/records.json'), 'utf8'))
  const bytes = (text: string) => new Uint8Array(Buffer.from(text, 'base64'))
  const records = images.map((image: { bytes?: string; data: string }, i: number) => [
    i,
    image.bytes === undefined
      ? { ...image, data: bytes(image.data) }
      : { ...image, bytes: bytes(image.bytes) },
  ])
  await expectRecorded(
    'studio/records',
    await withHashes(documentOf(documents, new Map(records), projects.name)),
  )
})

/** Returns all files of a folder as a page receives them. */
function filesOf(folder: string) {
  const items = readdirSync(folder, { recursive: true, withFileTypes: true })
  const paths = items.filter((item) => item.isFile()).map((item) => join(item.parentPath, item.name))
  return paths.map((path) => ({
    path: path.slice(folder.length + 1),
    file: new Blob([readFileSync(path)]),
  }))
}

async function expectRecorded(name: string, observed: object): Promise<void> {
  const recorded = join(FILES, 'expected', `${name.replaceAll(/[/.]/g, '-')}.json`)
  await expect(`${text(observed)}\n`).toMatchFileSnapshot(recorded)
}

/** Formats JSON with numbers of six digits, and short values on one line. */
function text(value: unknown, indent = ''): string {
  if (typeof value === 'number') return String(Number(value.toPrecision(6)))
  if (typeof value !== 'object' || value === null) return JSON.stringify(value)
  const inner = `${indent}  `
  const parts = Array.isArray(value)
    ? value.map((item) => text(item, inner))
    : Object.entries(value)
        .filter(([, item]) => item !== undefined)
        .map(([key, item]) => `${JSON.stringify(key)}: ${text(item, inner)}`)
  const [open, close] = Array.isArray(value) ? '[]' : '{}'
  const line = `${open}${parts.join(', ')}${close}`
  if (indent.length + line.length <= 400 && !line.includes('\n')) return line
  return `${open}\n${inner}${parts.join(`,\n${inner}`)}\n${indent}${close}`
}
