import { readdir } from 'node:fs/promises'
import { basename, dirname, join } from 'node:path'
import { FurrowError, type WrinkleSetDocument } from 'furrow'
import { cannotRead } from '../base/errors.ts'
import { type ReadOptions, referenceReader } from '../disk/external-files.ts'
import { statOf } from '../disk/file-status.ts'
import { readJson } from '../disk/read-bytes.ts'
import { folderDocument, WRINKLES_FILE } from './folder-document.ts'

/**
 * Reads the wrinkle set of a folder. If `wrinkles.json` is missing, or omits the layers, the areas, the strokes or an
 * optional map of a layer, this function adds the files in the folder. Added layers and areas are sorted by name.
 *
 * @param whiteIsVisible for areas without a `convention`: true for white = visible, false for black = visible (as in
 *   the paper of Reis, De Martino and Batagelo).
 * @throws FurrowError if the document is malformed, or the folder has no layers or no areas.
 */
export async function readFolder(
  folder: string,
  whiteIsVisible: boolean,
  who: string,
): Promise<WrinkleSetDocument> {
  const path = join(folder, WRINKLES_FILE)
  const files = await listFiles(folder, who)
  const json = files.includes(WRINKLES_FILE) ? await readJson(path, who) : undefined
  return folderDocument(json, files, folder, whiteIsVisible ? 'weight' : 'paper', who)
}

/**
 * Reads a file to which `wrinkles.json` refers.
 *
 * @throws FurrowError if the file cannot be read, or is outside the folder and `options` do not allow that.
 */
export async function readReferenced(
  folder: string,
  uri: string,
  who: string,
  options: ReadOptions,
): Promise<Uint8Array> {
  const read = referenceReader(join(folder, WRINKLES_FILE), who, options)
  return (await read(uri)).bytes
}

/** Lists the files and folders inside a folder, at any depth. Paths are relative to it, use `/`, and are sorted. */
async function listFiles(folder: string, who: string): Promise<string[]> {
  if ((await statOf(folder).catch(() => undefined))?.isFile()) throw isFile(folder, who)
  try {
    const all = await readdir(folder, { recursive: true, withFileTypes: false })
    return all.map((name) => name.replaceAll('\\', '/')).sort()
  } catch (error) {
    const remedy = 'name a folder with layers/NAME/normal.png and areas/NAME.png'
    throw cannotRead(who, `the folder ${folder}`, error, { remedy })
  }
}

function isFile(path: string, who: string): FurrowError {
  const isDocument = basename(path) === WRINKLES_FILE
  return new FurrowError({
    who,
    problem: `${path} is a file`,
    limit: 'a folder with layers/NAME/normal.png, areas/NAME.png and optionally wrinkles.json',
    remedy: isDocument
      ? `name its folder, ${dirname(path)}`
      : 'generate wrinkles with furrow auto, or extract the wrinkles of a file with furrow unpack',
  })
}
