import { mkdir, open, rename, rm, stat, writeFile } from 'node:fs/promises'
import { basename, dirname, join, resolve } from 'node:path'
import { FurrowError } from 'furrow'
import sharp from 'sharp'
import { firstLine } from '../images.ts'

/** Finds out whether a file of that kind can be written there, and leaves nothing behind. */
export async function checkWritable(path: string, who: string, ending = '.png'): Promise<void> {
  if (!path.toLowerCase().endsWith(ending)) {
    throw fault(path, who, `its name does not end in ${ending}`, `name it e.g. face${ending}`)
  }
  try {
    if (await isFolder(path)) throw new Error('it is a folder')
    const folder = await nearestFolder(dirname(resolve(path)))
    const trial = aside(join(folder, basename(path)))
    await (await open(trial, 'wx')).close()
    await rm(trial)
  } catch (error) {
    throw fault(path, who, firstLine(error))
  }
}

/** Writes RGBA pixels as an opaque RGB PNG; the file appears whole or not at all. Missing folders are made. */
export async function writePng(
  path: string,
  { width, height, pixels }: { width: number; height: number; pixels: Uint8Array },
  who: string,
): Promise<void> {
  const temporary = aside(resolve(path))
  try {
    const png = await sharp(pixels, { raw: { width, height, channels: 4 } })
      .removeAlpha()
      .png({ compressionLevel: 9 })
      .toBuffer()
    await mkdir(dirname(temporary), { recursive: true })
    await writeFile(temporary, png)
    await rename(temporary, path)
  } catch (error) {
    await rm(temporary, { force: true }).catch(() => {})
    throw fault(path, who, firstLine(error))
  }
}

const aside = (path: string) => `${path}.${process.pid}.tmp`

async function isFolder(path: string): Promise<boolean> {
  return (await stat(path).catch(() => undefined))?.isDirectory() ?? false
}

/** The folder itself, or the nearest one above it that exists. */
async function nearestFolder(path: string): Promise<string> {
  const found = await stat(path).catch(() => undefined)
  if (found?.isDirectory()) return path
  if (found) throw new Error(`${path} is not a folder`)
  const above = dirname(path)
  if (above === path) throw new Error(`${path} does not exist`)
  return nearestFolder(above)
}

function fault(
  path: string,
  who: string,
  problem: string,
  remedy = 'choose a file in a folder you may write to',
): FurrowError {
  return new FurrowError({
    who,
    what: `cannot write ${path.toLowerCase().endsWith('.png') ? 'the picture ' : ''}${path} (${problem})`,
    remedy,
  })
}
