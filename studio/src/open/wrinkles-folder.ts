import { FurrowError } from 'furrow'
import { depthProblem } from '../../../packages/cli/src/json-depth.ts'
import { folderDocument } from '../../../packages/cli/src/wrinkles/folder-document.ts'
import { readImages } from '../../../packages/furrow/src/three/loader/load-wrinkle-set.ts'
import type { FileWrinkles } from '../../../packages/furrow/src/three/loader/read-wrinkle-maps.ts'
import { bytesOf } from './dropped-files.ts'
import type { WrinklesFolder } from './sort-files.ts'

/**
 * Reads a folder of wrinkles as `furrow pack` does.
 *
 * @throws FurrowError when its document is malformed, or an image is missing or cannot be decoded.
 */
export async function readWrinklesFolder({ name, files }: WrinklesFolder): Promise<FileWrinkles> {
  const byPath = new Map(files.map(({ path, file }) => [path, file]))
  const json = byPath.has('wrinkles.json') ? await readJson(byPath.get('wrinkles.json')!) : undefined
  const document = folderDocument(json, [...byPath.keys()], name, 'paper', 'Studio')
  const read = async (address: string) =>
    byPath.get(pathOf(address)) ?? Promise.reject(missing(address, name))
  const set = await readImages(document, read, `Studio: ${name}`)
  return { set, drivers: document.drivers ?? [] }
}

async function readJson(file: File): Promise<unknown> {
  const text = new TextDecoder().decode(await bytesOf(file, 'wrinkles.json'))
  let json: unknown
  try {
    json = JSON.parse(text)
  } catch (error) {
    throw malformed((error as Error).message)
  }
  const problem = depthProblem(json)
  if (problem) throw malformed(problem)
  return json
}

function malformed(problem: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who: 'Studio',
    what: `wrinkles.json cannot be read (${problem})`,
    limit: 'JSON',
    remedy: 'correct the file',
  })
}

/** Addresses escape what has a meaning in them. */
function pathOf(address: string): string {
  try {
    return decodeURIComponent(address).replace(/^\.\//, '')
  } catch {
    return address
  }
}

function missing(address: string, folder: string): FurrowError {
  return new FurrowError({
    code: 'unreadable',
    who: 'Studio',
    what: `an image of the wrinkles is not in the folder ${folder}`,
    value: address,
    remedy: 'put it there, or correct wrinkles.json',
  })
}
