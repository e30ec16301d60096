import { readdir } from 'node:fs/promises'
import { basename, dirname, join } from 'node:path'
import { FurrowError } from 'furrow'
import { cannotRead } from '../base/errors.ts'
import { type ReadOptions, referenceReader } from '../disk/external-files.ts'
import { statOf } from '../disk/file-status.ts'
import type { SourceFiles } from './source-files.ts'

/** Largest number of files in the folder of an export. A larger folder is more likely the wrong one. */
const MAX_FILES = 10_000

/**
 * Opens the folder of an export, or the folder of its document.
 *
 * @param path a folder, or a JSON file in it. Of a file, only its folder and its name are used.
 * @throws FurrowError if the folder cannot be read, or has too many files.
 */
export async function openSourceFiles(path: string, who: string, options: ReadOptions): Promise<SourceFiles> {
  const isFile = (await statOf(path).catch(() => undefined))?.isFile() ?? false
  if (isFile && !/\.json$/i.test(path)) throw notAnExport(path, who)
  const folder = isFile ? dirname(path) : path
  const paths = await listFiles(folder, who)
  const read = referenceReader(join(folder, 'export'), who, options)
  return {
    name: path,
    paths,
    read: async (file) => (await read(file.split('/').map(encodeURIComponent).join('/'))).bytes,
    ...(isFile && { document: basename(path) }),
  }
}

async function listFiles(folder: string, who: string): Promise<string[]> {
  const found = await readdir(folder, { recursive: true, withFileTypes: false }).catch((error) => {
    throw cannotRead(who, `the export ${folder}`, error, { remedy: 'name the folder of the export' })
  })
  if (found.length > MAX_FILES) {
    throw new FurrowError({
      code: 'out-of-range',
      who,
      problem: `${folder} has too many files for an export`,
      value: found.length,
      limit: `${MAX_FILES} files`,
      remedy: 'move the export to its own folder',
    })
  }
  return found.map((name) => name.replaceAll('\\', '/')).sort()
}

function notAnExport(path: string, who: string): FurrowError {
  const isFbx = /\.fbx$/i.test(path)
  return new FurrowError({
    code: 'unsupported',
    who,
    problem: isFbx ? `${path} is FBX, which the command does not read` : `${path} is not a folder`,
    limit: 'a folder, or the .json file of an export',
    remedy: isFbx
      ? 'name its folder, and pass the character as glTF with --face; Blender converts FBX to glTF'
      : 'name the folder of the export',
  })
}
