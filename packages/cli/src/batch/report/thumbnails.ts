import { existsSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { FurrowError } from 'furrow'
import { targetNamesOf, wrinkledFile } from 'furrow-files'
import { readGlbFile } from 'furrow-files/node'
import type { Browser } from 'playwright-core'
import sharp from 'sharp'
import { posesOf } from '../../auto/report/poses.ts'
import { launchBrowser } from '../../browser.ts'
import { writeAll } from '../../files.ts'
import type { PictureRequest } from '../../render/picture.ts'
import { renderPicturesIn } from '../../render/render-pictures.ts'
import type { ResultLine } from '../results.ts'
import { openScratch } from '../scratch.ts'
import { isRemote, storeOf } from '../stores/store-of.ts'

const WHO = 'furrow batch'

/** Size of a thumbnail, pixels. The page shows it smaller, so it stays sharp on high-density screens. */
export const THUMBNAIL = { width: 288, height: 384 }

/** Camera view of a thumbnail. It is a close-up, so that wrinkles are visible at this size. */
const VIEW = { yaw: 0, pitch: 0, zoom: 1.7 }

/** Returns the file names of the thumbnails without and with wrinkles. `key` is the key of the job. */
export const thumbnailNames = (key: string) => [`${key}-before.webp`, `${key}-after.webp`] as const

/**
 * Draws the output of each result without and with wrinkles, and writes the thumbnails to a folder. Skips existing
 * thumbnails.
 *
 * @param progress called with the number of faces that are done.
 * @returns reasons why faces could not be drawn, each once.
 */
export async function drawThumbnails(
  lines: readonly ResultLine[],
  folder: string,
  progress: (done: number) => void,
): Promise<string[]> {
  const missing = lines.filter(
    ({ key }) => !thumbnailNames(key!).every((name) => existsSync(join(folder, name))),
  )
  const reasons = new Set<string>()
  let browser: Browser | undefined
  const scratch = openScratch({ endsBySignal: true })
  try {
    for (const [done, line] of missing.entries()) {
      progress(done)
      try {
        // A face can crash the browser. The next face then needs a new browser.
        if (!browser?.isConnected()) browser = await launchBrowser()
      } catch (error) {
        if (!(error instanceof FurrowError)) throw error
        return [error.message]
      }
      try {
        await drawFace(browser, line, folder, scratch.path)
      } catch (error) {
        if (!(error instanceof FurrowError)) throw error
        reasons.add(error.message)
      }
    }
  } finally {
    await browser?.close()
    scratch.remove()
  }
  return [...reasons]
}

async function drawFace(
  browser: Browser,
  { key, output }: ResultLine,
  folder: string,
  scratch: string,
): Promise<void> {
  let input = output!
  if (isRemote(input)) {
    input = join(scratch, 'face.glb')
    writeFileSync(input, await storeOf(output!).read(output!))
  }
  const pose = await poseOf(input)
  const modes = ['off', 'default'] as const
  const requests = modes.map(
    (mode): PictureRequest => ({
      input,
      mode,
      view: VIEW,
      ...pose,
      ...THUMBNAIL,
    }),
  )
  const pictures = await renderPicturesIn(browser, requests)
  const [before, after] = await Promise.all(
    pictures.map(({ pixels }) =>
      sharp(pixels, { raw: { ...THUMBNAIL, channels: 4 } })
        .removeAlpha()
        .webp({ quality: 80 })
        .toBuffer(),
    ),
  )
  const names = thumbnailNames(key!)
  const files = [before, after].map((bytes, i) => ({ path: join(folder, names[i]), bytes }))
  await writeAll(files, WHO)
}

/** Returns the first expression that the face supports. If it supports none, returns activation 1 for all areas. */
async function poseOf(input: string): Promise<Pick<PictureRequest, 'targets' | 'activations'>> {
  const glb = await readGlbFile(input, WHO)
  const targets = [...new Set((glb.json.meshes ?? []).flatMap(targetNamesOf))]
  const [pose] = posesOf({ targets, areas: [] })
  if (pose) return { targets: pose.targets }
  const { areas } = wrinkledFile(glb, input, WHO).maps
  return { activations: Object.fromEntries(areas.map(({ name }) => [name, 1])) }
}
