import type { FileWrinkles } from 'furrow/internal'
import { readImages } from 'furrow/internal/three'
import { folderDocument, WRINKLES_FILE } from 'furrow-files'
import { Folder } from '../files/folder.ts'
import type { WrinklesFolder } from '../files/folder-files.ts'

/**
 * Reads a folder of wrinkles as `furrow pack` does.
 *
 * @throws FurrowError if the document is invalid, or if an image is missing or invalid.
 */
export async function readWrinklesFolder({ name, files }: WrinklesFolder): Promise<FileWrinkles> {
  const folder = new Folder(files, name)
  const document = folderDocument(await folder.json(WRINKLES_FILE), folder.paths, name, 'paper', 'Studio')
  const set = await readImages(document, async (address) => folder.file(address), `Studio: ${name}`)
  return { set, drivers: document.drivers ?? [] }
}
