import { FurrowError } from 'furrow'
import { firstLine, type Progress } from 'furrow-files'
import type { Browser, Page } from 'playwright-core'
import { launchBrowser, newPage } from '../browser.ts'
import { type LocalServer, startLocalServer } from './local-server.ts'
import type { PageJob, PageReport, PictureRequest } from './picture.ts'
import { faceReader, type PreparedPicture, preparePicture } from './prepare.ts'

export interface Picture extends PageReport {
  width: number
  height: number
  /** RGBA bytes, sRGB, row 0 at the top. */
  pixels: Uint8Array
  /** Time to draw, milliseconds. For the first image of a face, it includes loading the page and the face. */
  milliseconds: number
}

/**
 * Draws images in a headless browser, in order. Consecutive images of one face share a page, which saves loading time.
 * Validates all requests before the browser starts. Writes no files.
 *
 * @param progress called before each image and after the last.
 * @throws FurrowError if a request is invalid, no browser is found, or an image cannot be drawn.
 */
export async function renderPictures(
  requests: readonly PictureRequest[],
  progress: Progress = () => {},
): Promise<Picture[]> {
  const prepared = await prepareAll(requests)
  const browser = await launchBrowser()
  try {
    return await drawAll(browser, prepared, progress)
  } finally {
    await browser.close()
  }
}

export async function renderPicturesIn(
  browser: Browser,
  requests: readonly PictureRequest[],
): Promise<Picture[]> {
  return drawAll(browser, await prepareAll(requests), () => {})
}

async function prepareAll(requests: readonly PictureRequest[]): Promise<PreparedPicture[]> {
  const prepared: PreparedPicture[] = []
  const readFace = faceReader()
  for (const request of requests) prepared.push(await preparePicture(request, readFace))
  return prepared
}

async function drawAll(
  browser: Browser,
  prepared: PreparedPicture[],
  progress: Progress,
): Promise<Picture[]> {
  const server = await startLocalServer()
  try {
    return await drawWith(browser, server, prepared, progress)
  } finally {
    await server.close()
  }
}

async function drawWith(
  browser: Browser,
  server: LocalServer,
  prepared: PreparedPicture[],
  progress: Progress,
): Promise<Picture[]> {
  const pictures: Picture[] = []
  let page: Page | undefined
  try {
    for (const [i, picture] of prepared.entries()) {
      progress(i, prepared.length)
      // Each face gets a new page, so that a memory leak or a lost GPU device does not affect the next face.
      if (i === 0 || !haveSameScene(picture, prepared[i - 1])) {
        await page?.close()
        page = await newPage(browser)
      }
      pictures.push(await drawOne(page!, server, picture))
    }
  } finally {
    await page?.close()
  }
  progress(prepared.length, prepared.length)
  return pictures
}

function haveSameScene({ job: a }: PreparedPicture, { job: b }: PreparedPicture): boolean {
  return a.face === b.face && a.wrinkles === b.wrinkles && a.mesh === b.mesh && a.renderer === b.renderer
}

async function drawOne(
  page: Page,
  server: LocalServer,
  { job, files, notes }: PreparedPicture,
): Promise<Picture> {
  const start = performance.now()
  for (const [path, content] of files) server.offer(path, content)
  const inbox = server.inbox(4 * job.width * job.height)
  const pageJob: PageJob = {
    ...job,
    face: server.addressOf(job.face),
    wrinkles: job.wrinkles && server.addressOf(job.wrinkles),
    uploadTo: inbox.address,
  }
  // Messages should contain paths and not URLs of the local server.
  const withPaths = (text: string) => text.replaceAll(`${server.origin}/file`, '')
  const report = await renderOnPage(page, server, pageJob).catch((error) => ({
    // Removes the method name with which Playwright's messages start.
    error: firstLine(error).replace(/^page\.\w+: /, ''),
  }))
  if ('error' in report) throw drawingFailed(job.face, withPaths(firstLine(report.error)))
  const pixels = inbox.received()
  if (!pixels) throw drawingFailed(job.face, 'the page posted no pixels')
  return {
    ...report,
    warnings: [...notes, ...report.warnings.map(withPaths)],
    width: job.width,
    height: job.height,
    pixels,
    milliseconds: Math.round(performance.now() - start),
  }
}

async function renderOnPage(
  page: Page,
  server: LocalServer,
  job: PageJob,
): Promise<PageReport | { error: string }> {
  let onCrash = () => {}
  const crashed = new Promise<{ error: string }>((resolve) => {
    onCrash = () => resolve({ error: 'the browser ran out of memory or crashed' })
  })
  page.once('crash', onCrash)
  try {
    if (page.url() !== server.page) await open(page, server)
    return await Promise.race([crashed, page.evaluate((job) => window.drawPicture(job), job)])
  } finally {
    // The page is used again, so listeners must not accumulate.
    page.off('crash', onCrash)
  }
}

async function open(page: Page, server: LocalServer): Promise<void> {
  await page.route(
    (url) => !url.href.startsWith(server.origin) && !['data:', 'blob:'].includes(url.protocol),
    (route) => route.abort(),
  )
  await page.goto(server.page)
}

function drawingFailed(face: string, problem: string): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who: 'furrow render',
    problem: `cannot draw ${face} (${problem})`,
    remedy: 'correct the input, or try another --renderer',
  })
}
