import { FurrowError } from 'furrow'
import { CHOOSE_FACE, HEAD_BYTES, kindOf, otherFormat, unusable } from 'furrow-files'
import { bytesOf, type DroppedFile } from '../files/dropped-files.ts'
import type { WrinklesFolder } from '../files/folder-files.ts'
import { oneFaceNote, oneFolderNote } from '../labels/messages.ts'

/** Dropped files, with the kind of their contents. */
export type Dropped = DroppedAvatar | DroppedWrinkles | DroppedCaptures | DroppedAreas | DroppedPreset

export interface DroppedAvatar {
  kind: 'avatar'
  face: DroppedFile
  /** All dropped files. The face can reference any of them. */
  files: readonly DroppedFile[]
  /** Wrinkles that replace the wrinkles in the file of the face. */
  wrinkles: WrinklesFolder | null
  /** Messages about choices among several files, one sentence each. */
  notes: readonly string[]
}

/** Wrinkles for the current avatar. */
export interface DroppedWrinkles {
  kind: 'wrinkles'
  wrinkles: WrinklesFolder
  notes: readonly string[]
}

/** CSV files for the current avatar: a facial capture, and possibly other tables that the app Live Link Face writes. */
export interface DroppedCaptures {
  kind: 'captures'
  tables: readonly DroppedFile[]
}

/** Painted areas for the current avatar. */
export interface DroppedAreas {
  kind: 'areas'
  images: readonly DroppedFile[]
}

/** Settings of automatic wrinkles for the current avatar. */
export interface DroppedPreset {
  kind: 'preset'
  preset: DroppedFile
}

const FACE = /\.(glb|vrm|gltf)$/i
const TABLE = /\.csv$/i
const JSON_FILE = /\.json$/i
const IMAGE = /\.(png|jpe?g|webp|avif)$/i
/** Paths of files by which a folder of wrinkles is recognised. */
const WRINKLES = /^(|.*\/)(wrinkles\.json|layers\/[^/]+\/normal\.png)$/

/**
 * Finds the kind of dropped files by their names and their first bytes.
 *
 * @throws FurrowError if no file is supported. The message describes the first file.
 */
export async function sortFiles(dropped: readonly DroppedFile[]): Promise<Dropped> {
  const files = await unpacked(dropped)
  const [wrinkles, ...others] = wrinklesFolders(files)
  const faces = await findFaces(files)
  const face = faces.find(({ path }) => wrinkles && path === `${wrinkles.path}face.glb`) ?? faces[0]
  const notes: string[] = []
  if (faces.length > 1) notes.push(oneFaceNote(face.path, faces.length))
  if (others.length > 0) notes.push(oneFolderNote(wrinkles.name, 1 + others.length))
  if (face) return { kind: 'avatar', face, files, wrinkles: wrinkles ?? null, notes }
  if (wrinkles) return { kind: 'wrinkles', wrinkles, notes }
  // Look for captures before images, because a recording by Live Link Face also contains a picture.
  const tables = files.filter(({ path }) => TABLE.test(path))
  if (tables.length > 0) return { kind: 'captures', tables }
  const images = files.filter(({ path }) => IMAGE.test(path))
  if (images.length > 0) return { kind: 'areas', images }
  const preset = files.find(({ path }) => JSON_FILE.test(path))
  if (preset) return { kind: 'preset', preset }
  throw await unsupportedFilesError(files)
}

async function unpacked(files: readonly DroppedFile[]): Promise<DroppedFile[]> {
  const lists = files.map(async (dropped) => {
    const { path, file } = dropped
    if (!/\.zip$/i.test(path)) return dropped
    const { unzipFolder } = await import('../files/zip.ts')
    const inside = await unzipFolder(file, path)
    const folder = path.replace(/\.zip$/i, '')
    return inside.map((each) => ({ path: `${folder}/${each.path}`, file: new File([each.file], each.path) }))
  })
  return (await Promise.all(lists)).flat()
}

/** Finds folders of wrinkles. The list begins with the least nested folder. */
function wrinklesFolders(files: readonly DroppedFile[]): (WrinklesFolder & { path: string })[] {
  const paths = new Set(files.flatMap(({ path }) => WRINKLES.exec(path)?.[1] ?? []))
  return [...paths].sort(byDepth).map((path) => ({
    path,
    name: path.split('/').at(-2) ?? 'wrinkles',
    files: files.flatMap(({ path: fullPath, file }) =>
      fullPath.startsWith(path) ? { path: fullPath.slice(path.length), file } : [],
    ),
  }))
}

/** Finds faces by file name, or by their first bytes if no name matches. The list begins with the least nested file. */
async function findFaces(files: readonly DroppedFile[]): Promise<DroppedFile[]> {
  const named = files.filter(({ path }) => FACE.test(path))
  const faces = named.length > 0 ? named : await binaryFaces(files)
  return faces.toSorted((a, b) => byDepth(a.path, b.path))
}

async function binaryFaces(files: readonly DroppedFile[]): Promise<DroppedFile[]> {
  const others = files.filter(({ path }) => !IMAGE.test(path))
  const kinds = await Promise.all(
    others.map(async ({ file }) => kindOf(await bytesOf(file.slice(0, HEAD_BYTES), file.name))),
  )
  return others.filter((_, i) => kinds[i] === 'a binary glTF file')
}

function byDepth(a: string, b: string): number {
  return a.split('/').length - b.split('/').length || a.localeCompare(b, 'en')
}

async function unsupportedFilesError(files: readonly DroppedFile[]): Promise<FurrowError> {
  const [first] = files
  const remedy =
    'drop a .glb, .vrm or .gltf, a folder of wrinkles, gray images, a preset, or a CSV of Live Link Face'
  if (!first) return new FurrowError({ who: 'Studio', problem: 'no file was dropped', remedy })
  const other = otherFormat(await bytesOf(first.file.slice(0, HEAD_BYTES), first.path))
  const problem = other?.problem ?? 'its contents are unknown'
  return unusable(first.path, 'Studio', problem, {
    remedy: other && other.remedy !== CHOOSE_FACE ? other.remedy : remedy,
  })
}
