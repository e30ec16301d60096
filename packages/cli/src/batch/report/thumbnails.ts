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
import { isRemote, placeOf } from '../places/places.ts'
import type { ResultLine } from '../results.ts'
import { openScratch } from '../scratch.ts'

const WHO = 'furrow batch'

/** In pixels: sharp on a phone, where a page shows it a third as wide. */
export const THUMBNAIL = { width: 288, height: 384 }

/** Nearer than a portrait: wrinkles show at the width of a thumb. */
const VIEW = { yaw: 0, pitch: 0, zoom: 1.7 }

/** The pictures of a face without its wrinkles and with them. */
export const THUMBNAIL_NAMES = (key: string) => [`${key}-before.webp`, `${key}-after.webp`] as const

/**
 * Draws the faces of some lines, each without and with its wrinkles, into a folder, all in one browser. Those that are there
 * already are not drawn again.
 *
 * @param progress is given the number of faces that are done.
 * @returns why faces were not drawn, once for each reason.
 */
export async function drawThumbnails(
  lines: readonly ResultLine[],
  folder: string,
  progress: (done: number) => void,
): Promise<string[]> {
  const missing = lines.filter(
    ({ key }) => !THUMBNAIL_NAMES(key!).every((name) => existsSync(join(folder, name))),
  )
  const reasons = new Set<string>()
  let browser: Browser | undefined
  const scratch = openScratch({ endsBySignal: true })
  try {
    for (const [done, line] of missing.entries()) {
      progress(done)
      try {
        // One face can cost the browser its life, but not the pictures of the others.
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
    writeFileSync(input, await placeOf(output!).read(output!))
  }
  const shown = await poseOf(input)
  const modes = ['off', 'default'] as const
  const requests = modes.map(
    (mode): PictureRequest => ({
      input,
      mode,
      view: VIEW,
      ...shown,
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
  const names = THUMBNAIL_NAMES(key!)
  const files = [before, after].map((bytes, i) => ({ path: join(folder, names[i]), bytes }))
  await writeAll(files, WHO)
}

/** The first expression of the report of `furrow auto` that a face can show; otherwise all of its wrinkles. */
async function poseOf(input: string): Promise<Pick<PictureRequest, 'targets' | 'activations'>> {
  const glb = await readGlbFile(input, WHO)
  const targets = [...new Set((glb.json.meshes ?? []).flatMap(targetNamesOf))]
  const [pose] = posesOf({ targets, areas: [] })
  if (pose) return { targets: pose.targets }
  const { areas } = wrinkledFile(glb, input, WHO).maps
  return { activations: Object.fromEntries(areas.map(({ name }) => [name, 1])) }
}
