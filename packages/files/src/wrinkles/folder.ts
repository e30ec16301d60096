import { readdir } from 'node:fs/promises'
import { basename, dirname, join } from 'node:path'
import { FurrowError, type WrinkleSetDocument } from 'furrow'
import { cannotRead } from '../base/errors.ts'
import { type ReadOptions, referenceReader } from '../disk/external-files.ts'
import { statOf } from '../disk/file-status.ts'
import { readJson } from '../disk/read-bytes.ts'
import { folderDocument, WRINKLES_FILE } from './folder-document.ts'

/**
 * Reads the wrinkle set of a folder: its `wrinkles.json`, completed by `strokes.json` and the files in `layers/` and
 * `areas/`. Without that document, all layers and areas found there are used, in alphabetical order.
 *
 * @param whiteIsVisible the convention of areas that name none.
 * @throws FurrowError when the document is malformed or there are no layers or areas.
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
 * Reads a file that `wrinkles.json` refers to.
 *
 * @throws FurrowError when it cannot be read, or is outside the folder and `options` do not allow that.
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

/** Paths of all files below a folder, relative to it, with `/`, sorted. */
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
      : 'make wrinkles for an avatar with furrow auto, or take them out of a file with furrow unpack',
  })
}
